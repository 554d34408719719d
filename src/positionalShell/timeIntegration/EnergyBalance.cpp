// SPDX-License-Identifier: GPL-3.0-or-later

#include "EnergyBalance.hpp"
#include "Reactions.hpp"

namespace positionalShell
{

EnergyBalance::EnergyBalance
(
    const ShellModel& model,
    const ShellState& start,
    const Vector& externalForce,
    double massDamping
)
:
    model_(model),
    massDamping_(massDamping),
    last_(start),
    lastForce_(externalForce),
    lastReaction_(reactions(model, start, externalForce, massDamping)),
    reaction_(lastReaction_),
    kinetic_(model.kineticEnergy(start.velocity)),
    strain_(model.strainEnergy(start.position))
{
    initialTotal_ = kinetic_ + strain_;
}

void EnergyBalance::add(const DynamicStep& step)
{
    const ShellState& now = step.state;
    const double dt = now.time - last_.time;
    const Vector moved = now.position - last_.position;
    const Vector react =
        reactions(model_, now, step.externalForce, massDamping_);

    const bool given = step.meanForce.size() > 0;
    const Vector meanForce = given
        ? step.meanForce
        : Vector(0.5*(lastForce_ + step.externalForce));
    const Vector meanReaction = given
        ? step.meanReaction
        : Vector(0.5*(lastReaction_ + react));
    externalWork_ += moved.dot(meanForce);
    supportWork_ += moved.dot(meanReaction);

    const Vector meanVelocity = 0.5*(last_.velocity + now.velocity);
    dissipated_ += massDamping_*dt
       *meanVelocity.dot(model_.massTimes(meanVelocity));

    for (int i = 0; i < model_.mesh().nNodes(); ++i)
    {
        const int x = fullIndex(i, Component::x);
        impulse_ +=
            dt*(meanForce.segment<3>(x) + meanReaction.segment<3>(x));
    }

    kinetic_ = model_.kineticEnergy(now.velocity);
    strain_ = model_.strainEnergy(now.position);
    last_ = now;
    lastForce_ = step.externalForce;
    lastReaction_ = react;
    reaction_ = given ? step.meanReaction : react;
}

double EnergyBalance::mismatch() const
{
    return total() - initialTotal_ - externalWork_ - supportWork_ + dissipated_;
}

} // namespace positionalShell
