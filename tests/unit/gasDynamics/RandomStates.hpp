/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/ConservedState.hpp"

#include <random>

namespace gasDynamics
{

//! Seeded random states and vectors of order one
class RandomStates
{
    std::mt19937 engine_{20250101};

public:

    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

    template<int dim>
    Vec<dim> vector(double size)
    {
        Vec<dim> v;
        for (int i = 0; i < dim; ++i)
        {
            v[i] = uniform(-size, size);
        }
        return v;
    }

    template<int dim>
    State<dim> state(const PerfectGas& gas, double speed = 2)
    {
        const double rho = uniform(0.2, 3);
        const double p = uniform(0.2, 3);
        return conserved<dim>(gas, rho, vector<dim>(speed), p);
    }
};

//! The same gas for an observer who moves with -V
template<int dim>
State<dim> boosted(const State<dim>& s, const Vec<dim>& V)
{
    const Vec<dim> momentum = s.template segment<dim>(1);
    State<dim> r = s;
    r.template segment<dim>(1) += s[0]*V;
    r[dim + 1] += momentum.dot(V) + 0.5*s[0]*V.squaredNorm();
    return r;
}

} // namespace gasDynamics
