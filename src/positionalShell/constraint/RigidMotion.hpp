// SPDX-License-Identifier: GPL-3.0-or-later
//
// Given motion of a rigid body: displacement of a point along a direction and rotation
// about an axis through it, both functions of time, (C9).

#ifndef positionalShell_RigidMotion_hpp
#define positionalShell_RigidMotion_hpp

#include "ShellTypes.hpp"
#include "TimeFunction.hpp"

namespace positionalShell
{

struct RigidMotion
{
    Vec3 point = Vec3::Zero();          // initial place

    Vec3 direction = Vec3::UnitX();     // need not be a unit vector
    TimeFunctionPtr displacement;       // along it, times its length; null: none

    Vec3 axis = Vec3::UnitZ();          // of any length but zero
    TimeFunctionPtr angle;              // [rad]; null: none

    //- Displacement of component c of a place with this initial arm, and change of
    //  that of a director. Throw std::invalid_argument for an axis of zero length.
    TimeFunctionPtr ofPosition(const Vec3& arm, int c) const;
    TimeFunctionPtr ofDirector(const Vec3& director, int c) const;
};

} // namespace positionalShell

#endif
