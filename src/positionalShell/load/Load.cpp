// SPDX-License-Identifier: GPL-3.0-or-later

#include "Load.hpp"

namespace positionalShell
{

Vector totalForce
(
    const Loads& loads,
    const ShellModel& model,
    const Vector& q,
    double time
)
{
    Vector force = Vector::Zero(model.dofs().nFull());
    for (const LoadPtr& load : loads) load->addForce(model, q, time, force);
    return force;
}

std::vector<TieForce> totalTieForces
(
    const Loads& loads,
    const ShellModel& model,
    const Vector& q,
    double time,
    double factor
)
{
    std::vector<TieForce> forces;
    for (const LoadPtr& load : loads)
    {
        load->addTieForces(model, q, time, forces);
    }
    for (TieForce& f : forces)
    {
        f.force *= factor;
        f.moment *= factor;
    }
    return forces;
}

} // namespace positionalShell
