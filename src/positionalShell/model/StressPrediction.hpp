// SPDX-License-Identifier: GPL-3.0-or-later
//
// States that the stress of a tangent comes from: the stress before, extrapolated in
// first order to after, (N3). The same state twice means the stress of that state.

#ifndef positionalShell_StressPrediction_hpp
#define positionalShell_StressPrediction_hpp

#include "ShellTypes.hpp"

namespace positionalShell
{

struct StressPrediction
{
    const Vector& before;   // full position vectors
    const Vector& after;
};

} // namespace positionalShell

#endif
