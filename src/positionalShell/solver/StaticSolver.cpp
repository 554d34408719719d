// SPDX-License-Identifier: GPL-3.0-or-later

#include "StaticSolver.hpp"
#include "StaticProblem.hpp"
#include "StepParts.hpp"

#include <stdexcept>

namespace positionalShell
{

StaticSolver::StaticSolver(const ShellModel& model, StaticOptions options)
:
    model_(model),
    options_(options),
    newton_(options.newton)
{
    if (options_.maxCuts < 0)
    {
        throw std::invalid_argument
        (
            "static solver: maxCuts " + std::to_string(options_.maxCuts)
          + " is negative"
        );
    }
}

StaticStep StaticSolver::step
(
    const ShellState& start,
    double t,
    const Loads& loads,
    const Vector* fixedForce
)
{
    const Vector none;
    Vector lackAtStart;
    StaticStep result;
    int iterations = 0;
    Vector q = start.position;
    const auto attempt = [&](double from, double to)
    {
        // What the start lacks is asked for only once the step is cut
        if ((from > 0 || to < 1) && lackAtStart.size() == 0)
        {
            StaticProblem atStart
            (
                model_, loads, fixedForce, start.time, start.position, none
            );
            KindNorms scale;
            atStart.residual(lackAtStart, scale);
        }
        const Vector lack = to < 1 ? Vector((1 - to)*lackAtStart) : none;
        const double time =
            to < 1 ? start.time + to*(t - start.time) : t;
        StaticProblem problem(model_, loads, fixedForce, time, q, lack);
        try
        {
            result.report = newton_.solve(problem);
        }
        catch (const SingularMatrix& singular)
        {
            // Of an iterate, perhaps: a shorter part may pass by it
            result.report = NewtonReport();
            result.report.message = singular.what();
        }
        iterations += result.report.iterations;
        if (result.report.converged) q = problem.position();
        return PartOutcome{result.report.converged};
    };
    const PartsReport parts = takeInParts(options_.maxCuts, 1, attempt);
    result.parts = parts.accepted;
    result.report.iterations = iterations;
    result.converged = parts.reached == 1;
    result.state = start;
    if (result.converged)
    {
        result.state.time = t;
        result.state.position = q;
    }
    return result;
}

StaticStep StaticSolver::run
(
    const ShellState& start,
    double endTime,
    int nSteps,
    const Loads& loads,
    const std::function<void(const StaticStep&)>& observer
)
{
    if (nSteps < 1)
    {
        throw std::invalid_argument
        (
            "static solver: " + std::to_string(nSteps)
          + " load steps; at least 1 is needed"
        );
    }
    StaticStep last;
    last.state = start;
    for (int k = 1; k <= nSteps; ++k)
    {
        const double t = start.time + (endTime - start.time)*k/nSteps;
        last = step(last.state, t, loads);
        if (!last.converged) return last;
        if (observer) observer(last);
    }
    return last;
}

} // namespace positionalShell
