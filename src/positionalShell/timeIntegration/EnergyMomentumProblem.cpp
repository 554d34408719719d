// SPDX-License-Identifier: GPL-3.0-or-later

#include "EnergyMomentumProblem.hpp"

namespace positionalShell
{

EnergyMomentumProblem::EnergyMomentumProblem
(
    const ShellModel& model,
    const Loads& loads,
    const GivenForce& given,
    const ShellState& start,
    double dt,
    double massDamping
)
:
    model_(model),
    loads_(loads),
    given_(given),
    start_(start),
    dt_(dt),
    damping_(massDamping),
    increment_(predictedIncrement(model.dofs(), start, dt)),
    end_(start)
{
    end_.time = start_.time + dt_;
    update();
}

//- Rates from the increment, (T5)
void EnergyMomentumProblem::update()
{
    end_.position = start_.position + increment_;
    middle_ = start_.position + 0.5*increment_;
    end_.velocity = (2/dt_)*increment_ - start_.velocity;
    end_.acceleration = (2/dt_)*(increment_/dt_ - start_.velocity);
    setFixedRates(model_.dofs(), end_);
}

void EnergyMomentumProblem::residual(Vector& full, KindNorms& scale)
{
    external_ = totalForce(loads_, model_, middle_, middleTime());
    if (given_.start) external_ += 0.5*(*given_.start);
    if (given_.end) external_ += 0.5*(*given_.end);

    Vector internal = Vector::Zero(external_.size());
    model_.addConservingForce(start_.position, end_.position, internal);
    const Vector inertia = model_.massTimes
    (
        (1/dt_)*(end_.velocity - start_.velocity)
      + 0.5*damping_*(end_.velocity + start_.velocity)
    );
    scale = greater
    (
        normsByKind(external_),
        greater(normsByKind(internal), normsByKind(inertia))
    );
    resistance_ = internal + inertia;
    full = external_ - resistance_;
}

void EnergyMomentumProblem::addStiffness
(
    const StressPrediction& stress,
    SystemMatrix& K
)
{
    model_.addConservingTangent(stress, start_.position, end_.position, K);
    for (const LoadPtr& load : loads_)
    {
        if (load->dependsOnPosition())
        {
            load->addTangent(model_, middle_, middleTime(), 0.5, K);
        }
    }
}

void EnergyMomentumProblem::addInertia(SystemMatrix& K)
{
    model_.addMass((2/dt_ + damping_)/dt_, K);
}

std::vector<TieForce> EnergyMomentumProblem::tieForces() const
{
    return totalTieForces(loads_, model_, middle_, middleTime());
}

Vector EnergyMomentumProblem::forceAtEnd() const
{
    Vector force = totalForce(loads_, model_, end_.position, end_.time);
    if (given_.end) force += *given_.end;
    return force;
}

Vector EnergyMomentumProblem::meanReaction() const
{
    Vector reaction = Vector::Zero(resistance_.size());
    for (const auto& p : model_.dofs().prescribed())
    {
        reaction[p.index] = resistance_[p.index] - external_[p.index];
    }
    return reaction;
}

} // namespace positionalShell
