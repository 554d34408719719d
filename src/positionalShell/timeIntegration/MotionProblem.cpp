// SPDX-License-Identifier: GPL-3.0-or-later

#include "MotionProblem.hpp"

namespace positionalShell
{

namespace
{

constexpr int thicknessComponent = static_cast<int>(Component::a);

} // namespace

MotionProblem::MotionProblem
(
    const ShellModel& model,
    const Loads& loads,
    const Vector* fixedForce,
    const ShellState& start,
    double dt,
    const NewmarkOptions& options
)
:
    model_(model),
    loads_(loads),
    fixedForce_(fixedForce),
    start_(start),
    dt_(dt),
    beta_(options.beta),
    gamma_(options.gamma),
    damping_(options.massDamping)
{
    predict();
}

//- First guess: constant acceleration; driven unknowns are exact
void MotionProblem::predict()
{
    const DofMap& dofs = model_.dofs();
    end_ = start_;
    end_.time = start_.time + dt_;
    increment_ =
        dt_*start_.velocity + 0.5*dt_*dt_*start_.acceleration;
    for (int i = thicknessComponent; i < dofs.nFull(); i += dofsPerNode)
    {
        increment_[i] = 0;
    }
    Vector driven = start_.position;
    dofs.setPrescribedPositions(end_.time, driven);
    for (const auto& p : dofs.prescribed())
    {
        increment_[p.index] = driven[p.index] - start_.position[p.index];
    }
    update();
}

//- Rates from the increment, (S30)
void MotionProblem::update()
{
    end_.position = start_.position + increment_;
    end_.acceleration =
        (increment_ - dt_*start_.velocity)/(beta_*dt_*dt_)
      - (0.5/beta_ - 1)*start_.acceleration;
    end_.velocity = start_.velocity
      + dt_
       *((1 - gamma_)*start_.acceleration + gamma_*end_.acceleration);

    const DofMap& dofs = model_.dofs();
    dofs.setPrescribedRates(end_.time, end_.velocity, end_.acceleration);
    for (int i = thicknessComponent; i < dofs.nFull(); i += dofsPerNode)
    {
        end_.velocity[i] = 0;
        end_.acceleration[i] = 0;
    }
}

void MotionProblem::residual(Vector& full, KindNorms& scale)
{
    external_ = totalForce(loads_, model_, end_.position, end_.time);
    if (fixedForce_) external_ += *fixedForce_;
    const Vector internal = model_.internalForce(end_.position);
    const Vector rate = end_.acceleration + damping_*end_.velocity;
    const Vector inertia = model_.massTimes(rate);

    scale = greater
    (
        normsByKind(external_),
        greater(normsByKind(internal), normsByKind(inertia))
    );
    full = external_ - internal - inertia;
}

void MotionProblem::addTangent(SystemMatrix& K)
{
    model_.addTangent(end_.position, K);
    model_.addMass((1/dt_ + gamma_*damping_)/(beta_*dt_), K);
    for (const LoadPtr& load : loads_)
    {
        if (load->dependsOnPosition())
        {
            load->addTangent(model_, end_.position, end_.time, 1, K);
        }
    }
}

void MotionProblem::move(const Vector& increment)
{
    model_.dofs().addExpanded(increment, increment_);
    update();
}

} // namespace positionalShell
