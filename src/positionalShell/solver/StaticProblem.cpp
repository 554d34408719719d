// SPDX-License-Identifier: GPL-3.0-or-later

#include "StaticProblem.hpp"

namespace positionalShell
{

StaticProblem::StaticProblem
(
    const ShellModel& model,
    const Loads& loads,
    const Vector* fixedForce,
    double time,
    const Vector& start,
    const Vector& lack
)
:
    model_(model),
    loads_(loads),
    fixedForce_(fixedForce),
    time_(time),
    start_(start),
    lack_(lack),
    q_(start)
{
    model_.dofs().setPrescribedPositions(time_, q_);
}

void StaticProblem::residual(Vector& full, KindNorms& scale)
{
    full = totalForce(loads_, model_, q_, time_);
    if (fixedForce_) full += *fixedForce_;
    scale = normsByKind(full);
    const Vector internal = model_.internalForce(q_);
    scale = greater(scale, normsByKind(internal));
    full -= internal;
    if (lack_.size() > 0) full -= lack_;
}

void StaticProblem::addStiffness
(
    const StressPrediction& stress,
    SystemMatrix& K
)
{
    model_.addTangent(stress, q_, K);
    for (const LoadPtr& load : loads_)
    {
        if (load->dependsOnPosition())
        {
            load->addTangent(model_, q_, time_, 1, K);
        }
    }
}

std::vector<TieForce> StaticProblem::tieForces() const
{
    return totalTieForces(loads_, model_, q_, time_);
}

Vector StaticProblem::loadRate(double distance) const
{
    const Vector after = totalForce(loads_, model_, q_, time_ + distance);
    const Vector before = totalForce(loads_, model_, q_, time_ - distance);
    return (after - before)/(2*distance);
}

} // namespace positionalShell
