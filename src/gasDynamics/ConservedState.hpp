/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/PerfectGas.hpp"

#include <Eigen/Core>

namespace gasDynamics
{

//! Conserved variables per volume in dim space dimensions:
//  (rho, rho U_1 .. rho U_dim, rho E); E = e + |U|^2/2.
template<int dim>
using State = Eigen::Matrix<double, dim + 2, 1, Eigen::DontAlign>;

//! Flux of a State: column j is the flux in direction j.
template<int dim>
using Flux = Eigen::Matrix<double, dim + 2, dim, Eigen::DontAlign>;

template<int dim>
using Vec = Eigen::Matrix<double, dim, 1, Eigen::DontAlign>;

template<int dim>
inline Vec<dim> velocity(const State<dim>& s)
{
    return s.template segment<dim>(1)/s[0];
}

template<int dim>
inline double pressure(const PerfectGas& gas, const State<dim>& s)
{
    const double kinetic = 0.5*s.template segment<dim>(1).squaredNorm()/s[0];
    return (gas.gamma() - 1)*(s[dim + 1] - kinetic);
}

template<int dim>
inline State<dim> conserved
(
    const PerfectGas& gas,
    double rho,
    const Vec<dim>& U,
    double p
)
{
    State<dim> s;
    s[0] = rho;
    s.template segment<dim>(1) = rho*U;
    s[dim + 1] = gas.internalEnergy(p) + 0.5*rho*U.squaredNorm();
    return s;
}

//! True for a state that exists: finite, rho > 0 and p > 0.
template<int dim>
inline bool isPhysical(const PerfectGas& gas, const State<dim>& s)
{
    return s.allFinite() && s[0] > 0 && pressure<dim>(gas, s) > 0;
}

} // namespace gasDynamics
