// SPDX-License-Identifier: GPL-3.0-or-later

#include "IntervalIntegrator.hpp"
#include "StepParts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace positionalShell
{

namespace
{

//- Given force within the interval: linear
struct PartOfGivenForce
{
    Vector start;
    Vector end;
    GivenForce force;

    PartOfGivenForce(const GivenForce& whole, double from, double to)
    {
        if (!whole.start || !whole.end)
        {
            force = whole;
            return;
        }
        start = (1 - from)*(*whole.start) + from*(*whole.end);
        end = (1 - to)*(*whole.start) + to*(*whole.end);
        force = GivenForce(&start, &end);
    }
};

} // namespace

IntervalIntegrator::IntervalIntegrator
(
    TimeIntegrator& integrator,
    IntervalOptions options
)
:
    integrator_(integrator),
    options_(options),
    guard_(integrator.model())
{
    if (options_.maxCuts < 0)
    {
        throw std::invalid_argument
        (
            "maxCuts " + std::to_string(options_.maxCuts) + " is negative"
        );
    }
    if (options_.errorTolerance < 0)
    {
        throw std::invalid_argument
        (
            "errorTolerance " + std::to_string(options_.errorTolerance)
          + " is negative"
        );
    }
}

void IntervalIntegrator::refuseSpurious
(
    const ShellState& start,
    DynamicStep& step
)
{
    const double excess = guard_.excess(start, step);
    if (excess == 0) return;

    char text[80];
    std::snprintf
    (
        text, sizeof(text), "the step makes %.3g J from nothing: %s", excess,
        "a spurious solution"
    );
    step.converged = false;
    step.report.message = text;
}

//- Another length of step costs a factorisation: only a useful change is made
double IntervalIntegrator::factor(double error) const
{
    const double best = 0.9*std::cbrt(options_.errorTolerance/error);
    if (error <= options_.errorTolerance && best < 1.3) return 1;
    return std::max(0.2, std::min(best, 2.0));
}

std::vector<DynamicStep> IntervalIntegrator::advance
(
    const ShellState& start,
    double interval,
    const Loads& loads,
    const GivenForce& given,
    double& wanted
)
{
    std::vector<DynamicStep> steps;
    DynamicStep failed;
    const auto attempt = [&](double from, double to)
    {
        const ShellState& here = steps.empty() ? start : steps.back().state;
        const PartOfGivenForce part(given, from, to);
        const double dt = (to - from)*interval;
        try
        {
            failed = integrator_.step(here, dt, loads, part.force);
            if (failed.converged) refuseSpurious(here, failed);
        }
        catch (const SingularMatrix& singular)
        {
            failed = DynamicStep();
            failed.report.message = singular.what();
        }

        PartOutcome outcome;
        outcome.accepted = failed.converged;
        if (failed.converged && options_.errorTolerance > 0)
        {
            const double error =
                integrator_.errorEstimate(here, failed.state);
            outcome.accepted = error <= options_.errorTolerance;
            outcome.factor = factor(error);
        }
        // The end of the interval exactly: later steps start from there
        if (to == 1) failed.state.time = start.time + interval;
        if (outcome.accepted) steps.push_back(failed);
        return outcome;
    };
    const double first = wanted > 0 ? wanted/interval : 1;
    const PartsReport parts = takeInParts(options_.maxCuts, first, attempt);
    wanted = options_.errorTolerance > 0 ? parts.next*interval : 0;
    if (parts.reached < 1)
    {
        if (failed.converged)
        {
            failed.converged = false;
            failed.report.message =
                "the local error is above its tolerance at the shortest step";
        }
        steps.push_back(failed);
    }
    return steps;
}

} // namespace positionalShell
