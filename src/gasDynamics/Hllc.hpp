/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/EulerFlux.hpp"

#include <algorithm>

namespace gasDynamics
{

//! HLLC flux (Toro, Spruce, Speares 1994; wave speeds of Einfeldt 1988)
//  through a surface with area vector S that moves with velocity w,
//  eq. (G14) of doc/theory/gas.md.
//
//  left is the state on the side that S points away from. Exact for
//  left == right, for an isolated contact and, with these wave speeds, for
//  an isolated shock.
template<int dim>
State<dim> hllcFlux
(
    const PerfectGas& gas,
    const State<dim>& left,
    const State<dim>& right,
    const Vec<dim>& S,
    const Vec<dim>& w
)
{
    const double area = S.norm();
    if (area == 0)
    {
        return State<dim>::Zero();
    }
    const Vec<dim> n = S/area;
    const double wn = w.dot(n);

    const double rhoL = left[0], rhoR = right[0];
    const double pL = pressure<dim>(gas, left);
    const double pR = pressure<dim>(gas, right);
    const double uL = velocity<dim>(left).dot(n);
    const double uR = velocity<dim>(right).dot(n);
    const double cL = gas.soundSpeed(pL, rhoL);
    const double cR = gas.soundSpeed(pR, rhoR);

    // Roe averages bound the outer wave speeds
    const double sqL = std::sqrt(rhoL), sqR = std::sqrt(rhoR);
    const double HL = (left[dim + 1] + pL)/rhoL;
    const double HR = (right[dim + 1] + pR)/rhoR;
    const Vec<dim> UT =
        (sqL*velocity<dim>(left) + sqR*velocity<dim>(right))/(sqL + sqR);
    const double HT = (sqL*HL + sqR*HR)/(sqL + sqR);
    const double uT = UT.dot(n);
    const double cT =
        std::sqrt((gas.gamma() - 1)*(HT - 0.5*UT.squaredNorm()));

    const double SL = std::min(uL - cL, uT - cT);
    const double SR = std::max(uR + cR, uT + cT);

    if (wn <= SL)
    {
        return fluxThrough<dim>(left, pL, S, w);
    }
    if (wn >= SR)
    {
        return fluxThrough<dim>(right, pR, S, w);
    }

    const double SM =
        (pR - pL + rhoL*uL*(SL - uL) - rhoR*uR*(SR - uR))
       /(rhoL*(SL - uL) - rhoR*(SR - uR));

    auto star = [&](const State<dim>& s, double p, double u, double SK)
    {
        const double rho = s[0];
        const double factor = rho*(SK - u)/(SK - SM);
        State<dim> r;
        r[0] = factor;
        r.template segment<dim>(1) =
            factor*(velocity<dim>(s) + (SM - u)*n);
        r[dim + 1] =
            factor
           *(s[dim + 1]/rho + (SM - u)*(SM + p/(rho*(SK - u))));
        return r;
    };

    const bool useLeft = (wn <= SM);
    const State<dim>& s = useLeft ? left : right;
    const double p = useLeft ? pL : pR;
    const double u = useLeft ? uL : uR;
    const double SK = useLeft ? SL : SR;
    const State<dim> sStar = star(s, p, u, SK);

    // F* = F_K + S_K (s* - s_K), seen from the moving surface
    return fluxThrough<dim>(s, p, S, w)
         + area*(SK*(sStar - s) - wn*(sStar - s));
}

} // namespace gasDynamics
