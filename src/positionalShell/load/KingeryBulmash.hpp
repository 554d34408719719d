// SPDX-License-Identifier: GPL-3.0-or-later
//
// Overpressure on one face of a shell by a charge of TNT, from the fits of Kingery and
// Bulmash: peak, impulse, arrival and duration at each point's distance, incident and
// reflected mixed by the angle of incidence, (L3)-(L6). Positive phase only; the face is
// taken as part of an endless wall (no clearing from its edges), and what other walls
// reflect is not there.

#ifndef positionalShell_KingeryBulmash_hpp
#define positionalShell_KingeryBulmash_hpp

#include "BlastTable.hpp"
#include "PressureField.hpp"

namespace positionalShell
{

//- Decay b of Friedlander's history (1 - t/td) exp(-b t/td) whose impulse is this part of
//  peak times duration, (L4). Throws std::invalid_argument unless part is positive.
double friedlanderDecay(double part);

struct KingeryBulmash : public PressureField
{
    BlastTable::Burst burst = BlastTable::Burst::freeAir;
    double mass = 0;                // W, TNT [kg]
    Vec3 position = Vec3::Zero();   // of the charge
    double side = 1;                // loaded face: 1 upper, -1 lower
    double pressure = 101325;       // of the air [Pa]
    double temperature = 288.15;    // of the air [K]

    //- Throws std::invalid_argument naming what is out of range
    void check() const;

    //- Z of a point, at sea level
    double scaledDistance(const Vec3& X) const;

    //- side times the overpressure; throws std::invalid_argument when the point is
    //  outside the range of the fits
    PressureHistory at(const Vec3& X, const Vec3& normal) const override;
};

} // namespace positionalShell

#endif
