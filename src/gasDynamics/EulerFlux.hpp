/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/ConservedState.hpp"

namespace gasDynamics
{

//! Euler flux in all directions, eq. (G1) of doc/theory/gas.md,
//  for a state whose pressure is known.
template<int dim>
inline Flux<dim> eulerFlux(const State<dim>& s, double p)
{
    const Vec<dim> U = velocity<dim>(s);
    Flux<dim> F = s*U.transpose();
    F.template middleRows<dim>(1).diagonal().array() += p;
    F.template bottomRows<1>() += p*U.transpose();
    return F;
}

//! Flux of the conserved quantities through a surface with area vector S
//  (not normalised) that moves with velocity w: (F - w s).S
template<int dim>
inline State<dim> fluxThrough
(
    const State<dim>& s,
    double p,
    const Vec<dim>& S,
    const Vec<dim>& w
)
{
    const Vec<dim> U = velocity<dim>(s);
    State<dim> f = s*(U - w).dot(S);
    f.template segment<dim>(1) += p*S;
    f[dim + 1] += p*U.dot(S);
    return f;
}

} // namespace gasDynamics
