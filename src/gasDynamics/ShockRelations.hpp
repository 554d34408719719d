/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/ExactRiemann.hpp"

namespace gasDynamics
{

//! State behind a shock of Mach number Ms >= 1 that runs in the +x direction
//  into the state ahead: Rankine-Hugoniot, eq. (G23) of doc/theory/gas.md.
Primitive1D behindShock
(
    const PerfectGas&, const Primitive1D& ahead, double Ms
);

//! Pressure behind the shock after normal reflection from a rigid wall,
//  eq. (G24); p1 ahead of and p2 behind the incident shock.
double reflectedPressure(const PerfectGas&, double p1, double p2);

} // namespace gasDynamics
