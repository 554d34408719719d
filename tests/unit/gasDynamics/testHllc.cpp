/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "RandomStates.hpp"
#include "gasDynamics/Hllc.hpp"
#include "gasDynamics/ShockRelations.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace gasDynamics;

namespace
{

const PerfectGas gas = PerfectGas::fromGamma(1.4);

template<int dim>
void expectNear(const State<dim>& a, const State<dim>& b, double tolerance)
{
    EXPECT_LT((a - b).norm(), tolerance*(1 + b.norm()))
        << a.transpose() << " is not " << b.transpose();
}

template<int dim>
void equalStatesGiveTheirOwnFlux()
{
    RandomStates random;
    for (int sample = 0; sample < 100; ++sample)
    {
        const State<dim> s = random.state<dim>(gas);
        const Vec<dim> S = random.vector<dim>(2), w = random.vector<dim>(3);
        const double p = pressure<dim>(gas, s);
        expectNear<dim>
        (
            hllcFlux<dim>(gas, s, s, S, w), fluxThrough<dim>(s, p, S, w), 1e-13
        );
    }
}

//! Seen from the other side of the surface the flux has the other sign
template<int dim>
void isAntisymmetric()
{
    RandomStates random;
    for (int sample = 0; sample < 200; ++sample)
    {
        const State<dim> L = random.state<dim>(gas), R = random.state<dim>(gas);
        const Vec<dim> S = random.vector<dim>(2), w = random.vector<dim>(2);
        const State<dim> there = hllcFlux<dim>(gas, L, R, S, w);
        const State<dim> back = -hllcFlux<dim>(gas, R, L, Vec<dim>(-S), w);
        expectNear<dim>(there, back, 1e-12);
    }
}

//! Gas and surface moving together carry the same mass; momentum and energy
//! fluxes change as those quantities do
template<int dim>
void isGalileanInvariant()
{
    RandomStates random;
    for (int sample = 0; sample < 200; ++sample)
    {
        const State<dim> L = random.state<dim>(gas), R = random.state<dim>(gas);
        const Vec<dim> S = random.vector<dim>(2), w = random.vector<dim>(2);
        const Vec<dim> V = random.vector<dim>(3);
        const State<dim> f = hllcFlux<dim>(gas, L, R, S, w);
        const State<dim> g = hllcFlux<dim>
        (
            gas, boosted<dim>(L, V), boosted<dim>(R, V), S, Vec<dim>(w + V)
        );
        expectNear<dim>(g, boosted<dim>(f, V), 1e-11);
    }
}

//! An isolated contact and an isolated shock, whose exact flux is that of the
//! state on the side of the wave where the surface is
template<int dim>
void isExactForAnIsolatedWave(const State<dim>& L, const State<dim>& R,
                              const Vec<dim>& n, double waveSpeed)
{
    for (double wn = waveSpeed - 4; wn < waveSpeed + 4; wn += 0.3)
    {
        if (std::abs(wn - waveSpeed) < 1e-6)
        {
            continue;
        }
        const State<dim>& s = wn < waveSpeed ? L : R;
        const Vec<dim> w = wn*n, S = 2.5*n;
        const State<dim> exact = fluxThrough<dim>(s, pressure<dim>(gas, s), S, w);
        expectNear<dim>(hllcFlux<dim>(gas, L, R, S, w), exact, 1e-12);
    }
}

} // namespace

TEST(Hllc, equalStates)
{
    equalStatesGiveTheirOwnFlux<1>();
    equalStatesGiveTheirOwnFlux<2>();
    equalStatesGiveTheirOwnFlux<3>();
}

TEST(Hllc, antisymmetry)
{
    isAntisymmetric<1>();
    isAntisymmetric<2>();
    isAntisymmetric<3>();
}

TEST(Hllc, galileanInvariance)
{
    isGalileanInvariant<1>();
    isGalileanInvariant<2>();
    isGalileanInvariant<3>();
}

TEST(Hllc, turnsWithTheFrame)
{
    RandomStates random;
    const Eigen::Matrix3d Q =
        Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3).normalized().toRotationMatrix();
    auto turned = [&](State<3> s)
    {
        const Vec<3> m = s.segment<3>(1);
        s.segment<3>(1) = Q*m;
        return s;
    };
    for (int sample = 0; sample < 100; ++sample)
    {
        const State<3> L = random.state<3>(gas), R = random.state<3>(gas);
        const Vec<3> S = random.vector<3>(2), w = random.vector<3>(2);
        const State<3> f = hllcFlux<3>(gas, L, R, S, w);
        const State<3> g = hllcFlux<3>
        (
            gas, turned(L), turned(R), Vec<3>(Q*S), Vec<3>(Q*w)
        );
        expectNear<3>(g, turned(f), 1e-12);
    }
}

TEST(Hllc, isolatedContactWithShear)
{
    const Vec<3> n = Vec<3>(1, 2, -2)/3;
    const Vec<3> t1 = Vec<3>(2, 1, 2)/3, t2 = Vec<3>(2, -2, -1)/3;
    const double u = 0.7;
    isExactForAnIsolatedWave<3>
    (
        conserved<3>(gas, 1, u*n + 0.5*t1, 1.3),
        conserved<3>(gas, 4, u*n - 2*t2, 1.3),
        n, u
    );
}

TEST(Hllc, isolatedShock)
{
    const Vec<2> n(0.6, -0.8), t(0.8, 0.6);
    for (const double Ms : {1.05, 1.21, 3.0})
    {
        const Primitive1D ahead{1.4, -0.3, 1};
        const Primitive1D behind = behindShock(gas, ahead, Ms);
        isExactForAnIsolatedWave<2>
        (
            conserved<2>(gas, behind.rho, behind.u*n + 0.4*t, behind.p),
            conserved<2>(gas, ahead.rho, ahead.u*n + 0.4*t, ahead.p),
            n, ahead.u + Ms
        );
    }
}

TEST(Hllc, surfaceOutsideAllWavesSeesOneSideOnly)
{
    RandomStates random;
    for (int sample = 0; sample < 50; ++sample)
    {
        const State<2> L = random.state<2>(gas), R = random.state<2>(gas);
        const Vec<2> n(0.6, 0.8);
        const State<2> left = hllcFlux<2>(gas, L, R, n, Vec<2>(-20*n));
        expectNear<2>
        (
            left, fluxThrough<2>(L, pressure<2>(gas, L), n, Vec<2>(-20*n)), 1e-13
        );
        const State<2> right = hllcFlux<2>(gas, L, R, n, Vec<2>(20*n));
        expectNear<2>
        (
            right, fluxThrough<2>(R, pressure<2>(gas, R), n, Vec<2>(20*n)), 1e-13
        );
    }
}

// Against the exact Riemann flux: for weak waves the two agree up to the square
// of the jumps
TEST(Hllc, agreesWithTheExactFluxForWeakWaves)
{
    auto difference = [](double eps)
    {
        const Primitive1D L{1, 0.3, 1};
        const Primitive1D R{1 + 0.7*eps, 0.3 - 0.4*eps, 1 + 1.1*eps};
        const Primitive1D s = ExactRiemann(gas, L, R).sample(0);
        const State<1> sL = conserved<1>(gas, L.rho, Vec<1>(L.u), L.p);
        const State<1> sR = conserved<1>(gas, R.rho, Vec<1>(R.u), R.p);
        const State<1> exact = conserved<1>(gas, s.rho, Vec<1>(s.u), s.p);
        const Vec<1> S(1), w(0);
        return
            (
                hllcFlux<1>(gas, sL, sR, S, w)
              - fluxThrough<1>(exact, s.p, S, w)
            ).norm();
    };
    EXPECT_LT(difference(0.01), 1e-4);
    EXPECT_GT(difference(0.02)/difference(0.01), 3.5);
    EXPECT_GT(difference(0.01)/difference(0.005), 3.5);
}

TEST(Hllc, noAreaNoFlux)
{
    RandomStates random;
    const State<2> f = hllcFlux<2>
    (
        gas, random.state<2>(gas), random.state<2>(gas), Vec<2>(0, 0), Vec<2>(1, 1)
    );
    EXPECT_EQ(f.norm(), 0);
}
