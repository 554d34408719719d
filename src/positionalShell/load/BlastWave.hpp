// SPDX-License-Identifier: GPL-3.0-or-later
//
// Overpressure of a blast wave from a point, without a gas: Friedlander's history
// behind a front that travels at constant speed, (L1)-(L2).

#ifndef positionalShell_BlastWave_hpp
#define positionalShell_BlastWave_hpp

#include "PressureField.hpp"

namespace positionalShell
{

struct BlastWave : public PressureField
{
    Vec3 centre = Vec3::Zero();
    double referenceDistance = 1;   // r0 [m]
    double peak = 0;                // overpressure of the front at r0 [Pa]
    double peakExponent = 0;        // decays with (r/r0)^-peakExponent
    double arrival = 0;             // of the front at r0 [s]
    double speed = 0;               // of the front [m/s]
    double duration = 1;            // of the positive phase [s]
    double decay = 1;               // b [-]

    //- Throws std::invalid_argument naming what is out of range
    void check() const;

    double value(const Vec3& X, double time) const;

    PressureHistory at(const Vec3& X, const Vec3& normal) const override;
};

} // namespace positionalShell

#endif
