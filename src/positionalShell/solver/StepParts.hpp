// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step that is taken in parts where the whole does not succeed: a part that fails
// is halved and repeated from its start, parts that succeed grow again.

#ifndef positionalShell_StepParts_hpp
#define positionalShell_StepParts_hpp

#include <functional>

namespace positionalShell
{

//- What became of a part of a step
struct PartOutcome
{
    bool accepted = false;

    //- Length wanted for the next part (for this one again if not accepted) over
    //  that of this one; 0: half after a failure, twice after two successes
    double factor = 0;
};

struct PartsReport
{
    double reached = 0;     // 1: the whole step
    int accepted = 0;
    int rejected = 0;
    double next = 1;        // length that the next part would have had
};

//- Cover 0 ... 1 by parts; the first has the length first (at most 1). Gives up when
//  a part shorter than 2^-maxCuts would be needed.
PartsReport takeInParts
(
    int maxCuts,
    double first,
    const std::function<PartOutcome(double from, double to)>& attempt
);

} // namespace positionalShell

#endif
