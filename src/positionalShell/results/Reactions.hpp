// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces that supports exert on the shell, (R9)-(R10).

#ifndef positionalShell_Reactions_hpp
#define positionalShell_Reactions_hpp

#include "ShellModel.hpp"

namespace positionalShell
{

//- Force and moment about a point [N], [N m]
struct ResultantForce
{
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
};

//- Force of the supports on prescribed unknowns in a state, full vector, zero
//  elsewhere, (R9). externalForce: full vector at the same instant; statics:
//  acceleration and velocity of zero.
Vector reactions
(
    const ShellModel& model,
    const ShellState& state,
    const Vector& externalForce,
    double massDamping = 0
);

//- Resultant of a full force vector over nodes, in a state, (R10)
ResultantForce resultant
(
    const std::vector<int>& nodes,
    const Vector& q,
    const Vector& force,
    const Vec3& about = Vec3::Zero()
);

} // namespace positionalShell

#endif
