// SPDX-License-Identifier: GPL-3.0-or-later

#include "Reactions.hpp"

#include <Eigen/Geometry>

namespace positionalShell
{

Vector reactions
(
    const ShellModel& model,
    const ShellState& state,
    const Vector& externalForce,
    double massDamping
)
{
    Vector balance = model.internalForce(state.position) - externalForce;
    const Vector rate = state.acceleration + massDamping*state.velocity;
    model.addMassTimes(1, rate, balance);
    Vector result = Vector::Zero(balance.size());
    for (const auto& p : model.dofs().prescribed())
    {
        result[p.index] = balance[p.index];
    }
    return result;
}

ResultantForce resultant
(
    const std::vector<int>& nodes,
    const Vector& q,
    const Vector& force,
    const Vec3& about
)
{
    ResultantForce sum;
    for (int node : nodes)
    {
        const int x = fullIndex(node, Component::x);
        const int g = fullIndex(node, Component::gx);
        const Vec3 onPosition = force.segment<3>(x);
        const Vec3 onDirector = force.segment<3>(g);
        sum.force += onPosition;
        sum.moment += (q.segment<3>(x) - about).cross(onPosition)
            + q.segment<3>(g).cross(onDirector);
    }
    return sum;
}

} // namespace positionalShell
