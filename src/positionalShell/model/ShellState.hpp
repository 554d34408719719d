// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that an instant of a shell's motion is made of: enough to restart.
// Rates of the thickness strain a are not part of the state (a has no inertia and
// follows from equilibrium at each instant); their entries stay zero.

#ifndef positionalShell_ShellState_hpp
#define positionalShell_ShellState_hpp

#include "ShellTypes.hpp"

namespace positionalShell
{

struct ShellState
{
    double time = 0;        // [s]
    Vector position;        // full vector q
    Vector velocity;        // full vector dq/dt
    Vector acceleration;    // full vector d2q/dt2
};

} // namespace positionalShell

#endif
