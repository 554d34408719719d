/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/Hllc.hpp"

namespace gasDynamics
{

//! Incoming characteristic [m/s] beside the outgoing one of a plane wave that
//  passes the surface obliquely, eq. (G71) of doc/theory/gas.md:
//  tangential^2/outgoing.
//
//  outgoing: J+ = pi + u_n, of the wave alone; tangential: its velocity along
//  the surface; mach: of the undisturbed gas, relative to the surface and out
//  of it. Waves that would come in, at larger angles than the gas carries out,
//  count the less the larger tangential is.
inline double incomingOfPlaneWave
(
    double outgoing,
    double tangential,
    double mach
)
{
    // What leaves with the gas has no incoming part, and what enters with it
    // is the outer state's alone
    if (std::abs(mach) >= 1 || outgoing == 0 || tangential == 0)
    {
        return 0;
    }
    // tan^2 of half the angle of the wave, and of the steepest that gets out
    const double squares = tangential*tangential/(outgoing*outgoing);
    const double steepest = std::min(1.0, (1 + mach)/(1 - mach));
    return
        outgoing
       *(squares <= steepest ? squares : steepest*steepest/squares);
}


//! Velocity [m/s] of a plane wave that brings gas at the pressure p and the
//  speed of sound c to the pressure inner: pi of eq. (G70)
inline double strengthOfWave
(
    const PerfectGas& gas,
    double inner,
    double p,
    double c
)
{
    const double half = 0.5*(gas.gamma() - 1);
    return c/half*(std::pow(inner/p, half/gas.gamma()) - 1);
}


//! The state outside of a surface through which a wave leaves: the undisturbed
//  outer state, plus what is incoming along the normal of a plane wave
//  that leaves obliquely, eqs. (G70)-(G72). The outer state itself where the
//  wave goes along the normal.
//
//  afterflow: velocity [m/s] that a curved wave has and a plane one of its
//  pressure has not, eq. (G74)
template<int dim>
State<dim> outsideOfWave
(
    const PerfectGas& gas,
    const State<dim>& inner,
    const State<dim>& outer,
    const Vec<dim>& S,
    const Vec<dim>& w,
    const Vec<dim>& afterflow
)
{
    const Vec<dim> n = S.normalized();
    const Vec<dim> outerU = velocity<dim>(outer);
    const Vec<dim> u = velocity<dim>(inner) - outerU - afterflow;
    const double normal = u.dot(n);
    const double ofCurvature = -afterflow.dot(n);
    const double tangential = (u - normal*n).norm();
    if (tangential == 0 && ofCurvature == 0)
    {
        return outer;
    }

    const double p = pressure<dim>(gas, outer);
    const double c = gas.soundSpeed(p, outer[0]);
    const double half = 0.5*(gas.gamma() - 1);
    const double perPressure = half/gas.gamma();
    const double pi = strengthOfWave(gas, pressure<dim>(gas, inner), p, c);

    // Half of the incoming wave is pressure, half is velocity; not more of
    // it than half of what empties the gas
    const double mach = (outerU - w).dot(n)/c;
    const double most = 0.5*c/half;
    const double incoming =
        incomingOfPlaneWave(pi + normal, tangential, mach) + ofCurvature;
    const double wave = std::max(-most, std::min(most, 0.5*incoming));
    const double cNew = c + half*wave;
    const double pNew = p*std::pow(cNew/c, 1/perPressure);
    return conserved<dim>
    (
        gas, gas.gamma()*pNew/(cNew*cNew), Vec<dim>(outerU - wave*n), pNew
    );
}


//! Flux through the far field, eq. (G14): by HLLC between the inner state and
//  the state outside of the wave that leaves.
template<int dim>
State<dim> farFieldFlux
(
    const PerfectGas& gas,
    const State<dim>& inner,
    const State<dim>& outer,
    const Vec<dim>& S,
    const Vec<dim>& w,
    const Vec<dim>& afterflow = Vec<dim>::Zero()
)
{
    if (inner == outer && afterflow == Vec<dim>::Zero())
    {
        return fluxThrough<dim>(outer, pressure<dim>(gas, outer), S, w);
    }
    return hllcFlux<dim>
    (
        gas, inner, outsideOfWave<dim>(gas, inner, outer, S, w, afterflow),
        S, w
    );
}

} // namespace gasDynamics
