// SPDX-License-Identifier: GPL-3.0-or-later

#include "AlphaProblem.hpp"

namespace positionalShell
{

AlphaProblem::AlphaProblem
(
    const ShellModel& model,
    const Loads& loads,
    const GivenForce& given,
    const ShellState& start,
    double dt,
    const AlphaParameters& parameters,
    double massDamping
)
:
    model_(model),
    loads_(loads),
    given_(given.end),
    start_(start),
    dt_(dt),
    p_(parameters),
    damping_(massDamping),
    increment_(predictedIncrement(model.dofs(), start, dt)),
    end_(start)
{
    end_.time = start_.time + dt_;
    if (p_.alphaF != 0)
    {
        startForce_ = totalAt(start_, given.start)
            - model_.internalForce(start_.position);
        model_.addMassTimes(-damping_, start_.velocity, startForce_);

        // Thickness strain is in equilibrium at each instant, (S16)
        for (Eigen::Index i = 0; i < startForce_.size(); ++i)
        {
            const bool thickness =
                i%dofsPerNode == static_cast<int>(Component::a);
            startForce_[i] *= thickness ? 0 : p_.alphaF;
        }
    }
    moveStartOfTies();
    update();
}

Vector AlphaProblem::totalAt(const ShellState& state, const Vector* given) const
{
    Vector force = totalForce(loads_, model_, state.position, state.time);
    if (given) force += *given;
    return force;
}

//- Rates from the increment, (S30)
void AlphaProblem::update()
{
    end_.position = start_.position + increment_;
    end_.acceleration =
        (increment_ - dt_*start_.velocity)/(p_.beta*dt_*dt_)
      - (0.5/p_.beta - 1)*start_.acceleration;
    end_.velocity = start_.velocity
      + dt_
       *((1 - p_.gamma)*start_.acceleration + p_.gamma*end_.acceleration);
    setFixedRates(model_.dofs(), end_);
}

void AlphaProblem::residual(Vector& full, KindNorms& scale)
{
    external_ = totalAt(end_, given_);
    const Vector internal = model_.internalForce(end_.position);
    const Vector rate = (1 - p_.alphaM)*end_.acceleration
      + p_.alphaM*start_.acceleration
      + (1 - p_.alphaF)*damping_*end_.velocity;
    const Vector inertia = model_.massTimes(rate);

    scale = greater
    (
        normsByKind(external_),
        greater(normsByKind(internal), normsByKind(inertia))
    );
    full = (1 - p_.alphaF)*(external_ - internal) - inertia;
    if (startForce_.size() > 0) full += startForce_;
    for (const TieForce& f : tieStart_)
    {
        model_.dofs().ties()[f.tie].spread
        (
            end_.position, {f.force, f.moment}, full
        );
    }
}

//- Forces of the start on rigid ties balance about its own arms: their resultants
//  there act at the end, instead of themselves
void AlphaProblem::moveStartOfTies()
{
    const std::vector<RigidTie>& ties = model_.dofs().ties();
    if (ties.empty() || startForce_.size() == 0) return;
    const Vector inertia =
        model_.massTimes(p_.alphaM*start_.acceleration);
    const Vector whole = startForce_ - inertia;
    for (std::size_t t = 0; t < ties.size(); ++t)
    {
        const RigidTie::Six sum = ties[t].resultant(start_.position, whole);
        tieStart_.push_back({int(t), sum.linear, Vec3::Zero(), sum.angular});
        for (int node : ties[t].nodes())
        {
            const int first = dofsPerNode*node;
            startForce_.segment<6>(first) = inertia.segment<6>(first);
        }
    }
}

std::vector<TieForce> AlphaProblem::tieForces() const
{
    std::vector<TieForce> forces = totalTieForces
    (
        loads_, model_, end_.position, end_.time, 1 - p_.alphaF
    );
    forces.insert(forces.end(), tieStart_.begin(), tieStart_.end());
    return forces;
}

void AlphaProblem::addStiffness
(
    const StressPrediction& stress,
    SystemMatrix& K
)
{
    model_.addTangent(stress, end_.position, K);
    for (const LoadPtr& load : loads_)
    {
        if (load->dependsOnPosition())
        {
            load->addTangent(model_, end_.position, end_.time, 1, K);
        }
    }
    K.scale(1 - p_.alphaF);
}

void AlphaProblem::addInertia(SystemMatrix& K)
{
    const double ofRate = (1 - p_.alphaF)*damping_*p_.gamma/(p_.beta*dt_);
    model_.addMass((1 - p_.alphaM)/(p_.beta*dt_*dt_) + ofRate, K);
}

} // namespace positionalShell
