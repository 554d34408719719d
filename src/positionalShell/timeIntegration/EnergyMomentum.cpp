// SPDX-License-Identifier: GPL-3.0-or-later

#include "EnergyMomentum.hpp"
#include "EnergyMomentumProblem.hpp"

namespace positionalShell
{

EnergyMomentum::EnergyMomentum
(
    const ShellModel& model,
    const MotionOptions& options
)
:
    TimeIntegrator("energyMomentum", model, options)
{
    for (const Section& section : model.sections())
    {
        require
        (
            section.material->linear(),
            "the tangent of the material " + section.material->name()
          + " of element set " + section.elementSet
          + " depends on the strain; select another integrator"
        );
    }
}

DynamicStep EnergyMomentum::doStep
(
    const ShellState& start,
    double dt,
    const Loads& loads,
    const GivenForce& given
)
{
    EnergyMomentumProblem problem
    (
        model(), loads, given, start, dt, massDamping()
    );
    DynamicStep result;
    result.report = newton().solve(problem);
    result.converged = result.report.converged;
    result.state = problem.endState();
    result.externalForce = problem.forceAtEnd();
    result.meanForce = problem.meanForce();
    result.meanReaction = problem.meanReaction();
    return result;
}

} // namespace positionalShell
