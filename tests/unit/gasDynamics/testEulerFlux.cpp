/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "RandomStates.hpp"
#include "gasDynamics/EulerFlux.hpp"

#include <gtest/gtest.h>

using namespace gasDynamics;

namespace
{

const PerfectGas gas = PerfectGas::fromGamma(1.4);

//! Component by component, as eq. (G1) reads
template<int dim>
void fluxByComponents()
{
    RandomStates random;
    for (int sample = 0; sample < 50; ++sample)
    {
        const double rho = random.uniform(.1, 3), p = random.uniform(.1, 3);
        const Vec<dim> U = random.vector<dim>(2);
        const double rhoE = p/0.4 + 0.5*rho*U.squaredNorm();
        const State<dim> s = conserved<dim>(gas, rho, U, p);
        const Flux<dim> F = eulerFlux<dim>(s, p);
        for (int j = 0; j < dim; ++j)
        {
            EXPECT_NEAR(F(0, j), rho*U[j], 1e-13);
            for (int i = 0; i < dim; ++i)
            {
                EXPECT_NEAR(F(1 + i, j), rho*U[i]*U[j] + (i == j ? p : 0), 1e-13);
            }
            EXPECT_NEAR(F(dim + 1, j), (rhoE + p)*U[j], 1e-12);
        }
    }
}

//! The flux through a surface is that of the flux matrix less what the
//! surface sweeps over
template<int dim>
void fluxThroughSurface()
{
    RandomStates random;
    for (int sample = 0; sample < 50; ++sample)
    {
        const State<dim> s = random.state<dim>(gas);
        const double p = pressure<dim>(gas, s);
        const Vec<dim> S = random.vector<dim>(1), w = random.vector<dim>(1);
        const State<dim> expected = eulerFlux<dim>(s, p)*S - w.dot(S)*s;
        EXPECT_LT((fluxThrough<dim>(s, p, S, w) - expected).norm(), 1e-13);
    }
}

//! The Euler flux is homogeneous of degree one, F(s) = F'(s) s; F' from
//! differences: an error in any single term breaks it
template<int dim>
void fluxIsHomogeneous()
{
    RandomStates random;
    for (int sample = 0; sample < 20; ++sample)
    {
        const State<dim> s = random.state<dim>(gas);
        const double h = 1e-6;
        for (int j = 0; j < dim; ++j)
        {
            State<dim> sum = State<dim>::Zero();
            for (int k = 0; k < dim + 2; ++k)
            {
                State<dim> up = s, down = s;
                up[k] += h;
                down[k] -= h;
                const State<dim> slope =
                    (
                        eulerFlux<dim>(up, pressure<dim>(gas, up)).col(j)
                      - eulerFlux<dim>(down, pressure<dim>(gas, down)).col(j)
                    )/(2*h);
                sum += slope*s[k];
            }
            const State<dim> F = eulerFlux<dim>(s, pressure<dim>(gas, s)).col(j);
            EXPECT_LT((sum - F).norm(), 1e-7*(1 + F.norm()));
        }
    }
}

} // namespace

TEST(EulerFlux, byComponents)
{
    fluxByComponents<1>();
    fluxByComponents<2>();
    fluxByComponents<3>();
}

TEST(EulerFlux, throughAMovingSurface)
{
    fluxThroughSurface<1>();
    fluxThroughSurface<2>();
    fluxThroughSurface<3>();
}

TEST(EulerFlux, isHomogeneousOfDegreeOne)
{
    fluxIsHomogeneous<1>();
    fluxIsHomogeneous<2>();
    fluxIsHomogeneous<3>();
}

// A wall that moves with the gas: only pressure and its work
TEST(EulerFlux, throughASurfaceThatMovesWithTheGas)
{
    const Vec<2> U(3, -1), S(0.5, 2);
    const State<2> f = fluxThrough<2>(conserved<2>(gas, 1.2, U, 5), 5, S, U);
    EXPECT_EQ(f[0], 0);
    EXPECT_EQ(f[1], 2.5);
    EXPECT_EQ(f[2], 10);
    EXPECT_EQ(f[3], -2.5);
}
