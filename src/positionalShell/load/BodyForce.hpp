// SPDX-License-Identifier: GPL-3.0-or-later
//
// Force per mass [N/kg] on the whole shell, e.g. gravity, times a factor of time.

#ifndef positionalShell_BodyForce_hpp
#define positionalShell_BodyForce_hpp

#include "Load.hpp"

namespace positionalShell
{

class BodyForce : public Load
{
public:

    BodyForce
    (
        const ShellModel& model,
        const Vec3& forcePerMass,
        TimeFunctionPtr factor = constant(1)
    );

    void addForce
    (
        const ShellModel&, const Vector& q, double time, Vector& force
    ) const override;

private:

    Vector unitForce_;
    TimeFunctionPtr factor_;
};

} // namespace positionalShell

#endif
