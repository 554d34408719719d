// SPDX-License-Identifier: GPL-3.0-or-later

#include "StepParts.hpp"

#include <algorithm>
#include <cmath>

namespace positionalShell
{

PartsReport takeInParts
(
    int maxCuts,
    double first,
    const std::function<PartOutcome(double from, double to)>& attempt
)
{
    const double least = std::ldexp(1.0, -maxCuts);
    PartsReport report;
    double length = std::min(1.0, first);
    int successes = 0;
    while (report.reached < 1)
    {
        // What round-off leaves of the step goes to its last part
        const double rest = 1 - report.reached;
        const bool last = length >= rest*(1 - 1e-9);
        const double tried = last ? rest : length;
        const PartOutcome outcome =
            attempt(report.reached, last ? 1 : report.reached + tried);
        if (outcome.accepted)
        {
            ++report.accepted;
            ++successes;
            report.reached = last ? 1 : report.reached + tried;
            if (outcome.factor > 0) length = tried*outcome.factor;
            else if (successes >= 2) length *= 2;
        }
        else
        {
            ++report.rejected;
            successes = 0;
            length = tried*(outcome.factor > 0 ? outcome.factor : 0.5);
            if (length < least) break;
        }
    }
    report.next = length;
    return report;
}

} // namespace positionalShell
