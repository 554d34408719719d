// SPDX-License-Identifier: GPL-3.0-or-later

#include "TimeIntegrator.hpp"
#include "ThicknessProblem.hpp"
#include "TieElimination.hpp"

#include <algorithm>
#include <stdexcept>

namespace positionalShell
{

namespace
{

constexpr int thicknessComponent = static_cast<int>(Component::a);

} // namespace

void setFixedRates(const DofMap& dofs, ShellState& state)
{
    dofs.setPrescribedRates(state.time, state.velocity, state.acceleration);
    for (int i = thicknessComponent; i < dofs.nFull(); i += dofsPerNode)
    {
        state.velocity[i] = 0;
        state.acceleration[i] = 0;
    }
}

Vector predictedIncrement
(
    const DofMap& dofs,
    const ShellState& start,
    double dt
)
{
    Vector increment = dt*start.velocity + 0.5*dt*dt*start.acceleration;
    for (int i = thicknessComponent; i < dofs.nFull(); i += dofsPerNode)
    {
        increment[i] = 0;
    }
    Vector driven = start.position;
    dofs.setPrescribedPositions(start.time + dt, driven);
    for (const auto& p : dofs.prescribed())
    {
        increment[p.index] = driven[p.index] - start.position[p.index];
    }
    for (const RigidTie& tie : dofs.ties())
    {
        Vector moved = start.position;
        tie.move
        (
            start.position, tie.rigidPart(start.position, increment), moved
        );
        for (int node : tie.nodes())
        {
            const int first = dofsPerNode*node;
            increment.segment<6>(first) =
                (moved - start.position).segment<6>(first);
        }
    }
    return increment;
}

TimeIntegrator::TimeIntegrator
(
    const std::string& name,
    const ShellModel& model,
    const MotionOptions& options
)
:
    name_(name),
    model_(model),
    massDamping_(options.massDamping),
    newton_(options.newton)
{
    require
    (
        massDamping_ >= 0,
        "massDamping " + std::to_string(massDamping_) + " is negative"
    );
}

void TimeIntegrator::require(bool condition, const std::string& message) const
{
    if (!condition) throw std::invalid_argument(name_ + ": " + message);
}

void TimeIntegrator::initialise
(
    ShellState& state,
    const Loads& loads,
    const Vector* givenForce
) const
{
    const DofMap& dofs = model_.dofs();
    const int n = dofs.nFull();
    require
    (
        state.position.size() == n,
        "the position of the initial state has "
      + std::to_string(state.position.size()) + " values, not "
      + std::to_string(n)
    );
    if (state.velocity.size() != n) state.velocity = Vector::Zero(n);
    if (state.acceleration.size() != n) state.acceleration = Vector::Zero(n);

    dofs.setPrescribedPositions(state.time, state.position);
    setFixedRates(dofs, state);
    equilibrateThickness(state, loads, givenForce);
    setAccelerations(state, loads, givenForce);
}

DynamicStep TimeIntegrator::step
(
    const ShellState& start,
    double dt,
    const Loads& loads,
    const GivenForce& given
)
{
    require(dt > 0, "time step " + std::to_string(dt) + " is not positive");

    // Kept factors belong to one effective matrix K + c0 M
    if (dt != keptTimeStep_) newton_.reset();
    keptTimeStep_ = dt;
    return doStep(start, dt, loads, given);
}

double TimeIntegrator::errorEstimate
(
    const ShellState& start,
    const ShellState& end
) const
{
    const double dt = end.time - start.time;
    const Vector jump = end.acceleration - start.acceleration;
    const KindNorms greatest = greatestEntries(jump);
    return errorConstant()*dt*dt*std::max
    (
        greatest.position/model_.mesh().lengthScale(), greatest.director
    );
}

//- (S32): only the equations of a move
void TimeIntegrator::equilibrateThickness
(
    ShellState& state,
    const Loads& loads,
    const Vector* givenForce
) const
{
    ThicknessProblem problem(model_, loads, givenForce, state);
    NewtonOptions options = newton_.options();
    options.tangentUpdate = TangentUpdate::everyIteration;
    const NewtonReport report = Newton(options).solve(problem);
    if (!report.converged)
    {
        throw std::runtime_error
        (
            name_ + ": the thickness strain of the initial state finds no "
            "equilibrium: " + report.message
        );
    }
    state.position = problem.position();
}

//- (S31): M q'' = F - dU/dq - c M q' on equations with inertia
void TimeIntegrator::setAccelerations
(
    ShellState& state,
    const Loads& loads,
    const Vector* givenForce
) const
{
    const DofMap& dofs = model_.dofs();
    Vector force = totalForce(loads, model_, state.position, state.time);
    if (givenForce) force += *givenForce;
    force -= model_.internalForce(state.position);
    model_.addMassTimes(-massDamping_, state.velocity, force);

    // The inertia of driven nodes acts on the free ones
    Vector driven = Vector::Zero(dofs.nFull());
    for (const auto& p : dofs.prescribed())
    {
        driven[p.index] = state.acceleration[p.index];
    }
    for (const RigidTie& tie : dofs.ties())
    {
        tie.addCentripetal
        (
            state.velocity,
            tie.rigidPart(state.position, state.velocity).angular,
            driven
        );
    }
    model_.addMassTimes(-1, driven, force);

    Vector reduced = dofs.reduce(force);
    SystemMatrix mass = model_.makeMatrix();
    model_.addMass(1, mass);
    for (int e = 0; e < dofs.nEquations(); ++e)
    {
        if (!model_.massless(e)) continue;
        mass.setDiagonal(e, 1);
        reduced[e] = 0;
    }
    const TieElimination ties(dofs);
    ties.project(state.position, reduced);
    LinearSolver solver;
    if (ties.none())
    {
        solver.factorise(mass);
    }
    else
    {
        solver.factoriseSymmetric
        (
            ties.reduced
            (
                state.position, mass.matrix(), Vector::Zero(dofs.nFull()), {}
            )
        );
    }
    Vector own = solver.solve(reduced);
    ties.expand(state.position, own);
    state.acceleration = driven;
    dofs.addExpanded(own, state.acceleration);
}

} // namespace positionalShell
