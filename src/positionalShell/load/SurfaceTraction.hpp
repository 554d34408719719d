// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dead traction [Pa of initial mid-surface area] on an element set, or dead
// pressure along the initial normals, times a factor of time.

#ifndef positionalShell_SurfaceTraction_hpp
#define positionalShell_SurfaceTraction_hpp

#include "Load.hpp"

#include <string>

namespace positionalShell
{

class SurfaceTraction : public Load
{
public:

    //- Traction vector fixed in space
    SurfaceTraction
    (
        const ShellModel& model,
        const std::string& elementSet,
        const Vec3& traction,
        TimeFunctionPtr factor = constant(1)
    );

    //- Pressure that keeps the direction and area of the initial state. Positive
    //  pressure pushes against the normal (as on the upper face).
    static LoadPtr deadPressure
    (
        const ShellModel& model,
        const std::string& elementSet,
        double pressure,
        TimeFunctionPtr factor = constant(1)
    );

    void addForce
    (
        const ShellModel&, const Vector& q, double time, Vector& force
    ) const override;

private:

    Vector unitForce_;
    TimeFunctionPtr factor_;

    SurfaceTraction(Vector unitForce, TimeFunctionPtr factor);
};

} // namespace positionalShell

#endif
