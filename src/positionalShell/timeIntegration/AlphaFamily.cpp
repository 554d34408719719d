// SPDX-License-Identifier: GPL-3.0-or-later

#include "AlphaFamily.hpp"
#include "AlphaProblem.hpp"

#include <cmath>

namespace positionalShell
{

AlphaFamily::AlphaFamily
(
    const std::string& name,
    const ShellModel& model,
    const MotionOptions& options,
    const AlphaParameters& parameters
)
:
    TimeIntegrator(name, model, options),
    parameters_(parameters)
{}

DynamicStep AlphaFamily::doStep
(
    const ShellState& start,
    double dt,
    const Loads& loads,
    const GivenForce& given
)
{
    AlphaProblem problem
    (
        model(), loads, given, start, dt, parameters_, massDamping()
    );
    DynamicStep result;
    result.report = newton().solve(problem);
    result.converged = result.report.converged;
    result.state = problem.endState();
    result.externalForce = problem.externalForce();
    return result;
}

double AlphaFamily::errorConstant() const
{
    return std::abs(parameters_.beta - 1.0/6);
}

} // namespace positionalShell
