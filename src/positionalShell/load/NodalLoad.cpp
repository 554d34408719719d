// SPDX-License-Identifier: GPL-3.0-or-later

#include "NodalLoad.hpp"

namespace positionalShell
{

NodalLoad::NodalLoad
(
    const ShellModel& model,
    const std::string& nodeSet,
    const Vec3& force,
    TimeFunctionPtr factor,
    const Vec3& directorForce
)
:
    nodes_(model.mesh().nodeSet(nodeSet)),
    force_(force),
    factor_(std::move(factor)),
    directorForce_(directorForce)
{}

void NodalLoad::addForce
(
    const ShellModel&,
    const Vector&,
    double time,
    Vector& force
) const
{
    const double factor = factor_->value(time);
    for (int node : nodes_)
    {
        force.segment<3>(fullIndex(node, Component::x)) += factor*force_;
        force.segment<3>(fullIndex(node, Component::gx)) +=
            factor*directorForce_;
    }
}

} // namespace positionalShell
