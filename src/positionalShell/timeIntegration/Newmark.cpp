// SPDX-License-Identifier: GPL-3.0-or-later

#include "Newmark.hpp"
#include "MotionProblem.hpp"
#include "ThicknessProblem.hpp"

#include <stdexcept>

namespace positionalShell
{

namespace
{

void require(bool condition, const std::string& message)
{
    if (!condition) throw std::invalid_argument("Newmark: " + message);
}

//- Thickness strain has no rates; driven unknowns take those of their motion
void setFixedRates(const ShellModel& model, ShellState& state)
{
    const DofMap& dofs = model.dofs();
    dofs.setPrescribedRates(state.time, state.velocity, state.acceleration);
    const int a = static_cast<int>(Component::a);
    for (int i = a; i < dofs.nFull(); i += dofsPerNode)
    {
        state.velocity[i] = 0;
        state.acceleration[i] = 0;
    }
}

} // namespace

Newmark::Newmark(const ShellModel& model, NewmarkOptions options)
:
    model_(model),
    options_(options),
    newton_(options.newton)
{
    const double least = 0.25*(options.gamma + 0.5)*(options.gamma + 0.5);
    require
    (
        options.gamma >= 0.5,
        "gamma " + std::to_string(options.gamma) + " is less than 1/2"
    );
    require
    (
        options.beta >= least*(1 - 1e-12),
        "beta " + std::to_string(options.beta)
      + " is less than (gamma + 1/2)^2/4 = " + std::to_string(least)
    );
    require
    (
        options.massDamping >= 0,
        "massDamping " + std::to_string(options.massDamping) + " is negative"
    );
}

void Newmark::initialise
(
    ShellState& state,
    const Loads& loads,
    const Vector* fixedForce
)
{
    const int n = model_.dofs().nFull();
    require
    (
        state.position.size() == n,
        "the position of the initial state has "
      + std::to_string(state.position.size()) + " values, not "
      + std::to_string(n)
    );
    if (state.velocity.size() != n) state.velocity = Vector::Zero(n);
    if (state.acceleration.size() != n) state.acceleration = Vector::Zero(n);

    model_.dofs().setPrescribedPositions(state.time, state.position);
    setFixedRates(model_, state);
    equilibrateThickness(state, loads, fixedForce);
    setAccelerations(state, loads, fixedForce);
}

DynamicStep Newmark::step
(
    const ShellState& start,
    double dt,
    const Loads& loads,
    const Vector* fixedForce
)
{
    require(dt > 0, "time step " + std::to_string(dt) + " is not positive");

    // Kept factors belong to one effective matrix K + c0 M
    if (dt != keptTimeStep_) newton_.reset();
    keptTimeStep_ = dt;

    MotionProblem problem(model_, loads, fixedForce, start, dt, options_);
    DynamicStep result;
    result.report = newton_.solve(problem);
    result.converged = result.report.converged;
    result.state = problem.endState();
    result.externalForce = problem.externalForce();
    return result;
}

//- (S32): only the equations of a move
void Newmark::equilibrateThickness
(
    ShellState& state,
    const Loads& loads,
    const Vector* fixedForce
)
{
    ThicknessProblem problem(model_, loads, fixedForce, state);
    NewtonOptions options = options_.newton;
    options.tangentUpdate = TangentUpdate::everyIteration;
    const NewtonReport report = Newton(options).solve(problem);
    if (!report.converged)
    {
        throw std::runtime_error
        (
            "Newmark: the thickness strain of the initial state finds no "
            "equilibrium: " + report.message
        );
    }
    state.position = problem.position();
}

//- (S31): M q'' = F - dU/dq - c M q' on equations with inertia
void Newmark::setAccelerations
(
    ShellState& state,
    const Loads& loads,
    const Vector* fixedForce
)
{
    const DofMap& dofs = model_.dofs();
    Vector force = totalForce(loads, model_, state.position, state.time);
    if (fixedForce) force += *fixedForce;
    force -= model_.internalForce(state.position);
    model_.addMassTimes(-options_.massDamping, state.velocity, force);

    // The inertia of driven nodes acts on the free ones
    Vector driven = Vector::Zero(dofs.nFull());
    for (const auto& p : dofs.prescribed())
    {
        driven[p.index] = state.acceleration[p.index];
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
    LinearSolver solver;
    solver.factorise(mass);
    state.acceleration = driven;
    dofs.addExpanded(solver.solve(reduced), state.acceleration);
}

} // namespace positionalShell
