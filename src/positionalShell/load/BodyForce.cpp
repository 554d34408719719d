// SPDX-License-Identifier: GPL-3.0-or-later

#include "BodyForce.hpp"

namespace positionalShell
{

BodyForce::BodyForce
(
    const ShellModel& model,
    const Vec3& forcePerMass,
    TimeFunctionPtr factor
)
:
    factor_(std::move(factor))
{
    // The force of a uniform acceleration field: no part on the directors
    Vector field = Vector::Zero(model.dofs().nFull());
    for (int i = 0; i < model.mesh().nNodes(); ++i)
    {
        field.segment<3>(fullIndex(i, Component::x)) = forcePerMass;
    }
    unitForce_ = model.massTimes(field);
}

void BodyForce::addForce
(
    const ShellModel&,
    const Vector&,
    double time,
    Vector& force
) const
{
    force += factor_->value(time)*unitForce_;
}

} // namespace positionalShell
