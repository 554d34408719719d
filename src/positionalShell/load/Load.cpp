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

} // namespace positionalShell
