/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "RandomStates.hpp"
#include "gasDynamics/FarField.hpp"

#include <gtest/gtest.h>

using namespace gasDynamics;

namespace
{

const PerfectGas gas = PerfectGas::fromGamma(1.4);

//! Plane sound wave of pressure 1 + rise in gas with rho = p = 1 that moves
//! with U: simple wave in the unit direction k
template<int dim>
State<dim> simpleWave(double rise, const Vec<dim>& k, const Vec<dim>& U)
{
    const double g = gas.gamma(), p = 1 + rise;
    const double speed =
        2*std::sqrt(g)/(g - 1)*(std::pow(p, 0.5*(g - 1)/g) - 1);
    return conserved<dim>
    (
        gas, std::pow(p, 1/g), Vec<dim>(U + speed*k), p
    );
}

//! A direction at an angle to n
template<int dim>
Vec<dim> inclined(RandomStates& random, const Vec<dim>& n, double angle)
{
    Vec<dim> t = random.vector<dim>(1);
    t -= t.dot(n)*n;
    return std::cos(angle)*n + std::sin(angle)*t.normalized();
}

//! A wave that goes out at any angle sees nothing: the flux is its own, up to
//! the square of its strength
template<int dim>
void letsPlaneWavesOut()
{
    RandomStates random;
    for (const double strength : {1e-4, -1e-4, 1e-5})
    {
        for (int sample = 0; sample < 200; ++sample)
        {
            const Vec<dim> S = random.vector<dim>(2);
            const Vec<dim> n = S.normalized();
            const double mach = random.uniform(-0.5, 0.9);
            const Vec<dim> w = random.vector<dim>(1);
            const Vec<dim> U = w + mach*std::sqrt(gas.gamma())*n;

            // Up to 3/4 of the angle of the last wave that gets out, and of
            // the normal's right angle
            const double last =
                std::acos(std::min(1.0, std::max(-mach, 0.0)));
            const Vec<dim> k =
                inclined<dim>(random, n, 0.75*random.uniform(0, last));

            const State<dim> outer = simpleWave<dim>(0, k, U);
            const State<dim> wave = simpleWave<dim>(strength, k, U);
            State<dim> off =
                farFieldFlux<dim>(gas, wave, outer, S, w)
              - fluxThrough<dim>(wave, pressure<dim>(gas, wave), S, w);
            if (mach < 0)
            {
                // Gas that comes in has the outer velocity along the surface
                const Vec<dim> momentum = off.template segment<dim>(1);
                const Vec<dim> along = momentum - momentum.dot(n)*n;
                off.template segment<dim>(1) -= along;
                off[dim + 1] -= along.dot(U);
            }
            EXPECT_LT(off.norm(), 100*strength*strength*S.norm())
                << "Mach " << mach << ", k " << k.transpose() << ", n "
                << n.transpose() << ", off " << off.transpose();
        }
    }
}

//! Along the normal it is HLLC with the outer state; of uniform gas its flux
template<int dim>
void isHllcAlongTheNormal()
{
    RandomStates random;
    for (int sample = 0; sample < 100; ++sample)
    {
        const Vec<dim> S = Vec<dim>::Unit(sample % dim)*random.uniform(1, 2);
        const Vec<dim> U = random.vector<dim>(1), w = random.vector<dim>(1);
        const State<dim> outer = conserved<dim>(gas, 1, U, 1);
        const State<dim> inner = conserved<dim>
        (
            gas, random.uniform(0.5, 2), Vec<dim>(U + random.uniform(-1, 1)*S),
            random.uniform(0.5, 2)
        );
        const State<dim> expected = hllcFlux<dim>(gas, inner, outer, S, w);
        EXPECT_LT
        (
            (farFieldFlux<dim>(gas, inner, outer, S, w) - expected).norm(),
            1e-12*(1 + expected.norm())
        );
        EXPECT_EQ
        (
            (farFieldFlux<dim>(gas, outer, outer, S, w)),
            (fluxThrough<dim>(outer, pressure<dim>(gas, outer), S, w))
        );
    }
}

//! Whatever the states, the state outside is one
template<int dim>
void outsideIsPhysical()
{
    RandomStates random;
    for (int sample = 0; sample < 2000; ++sample)
    {
        const State<dim> inner = random.state<dim>(gas, 20);
        const State<dim> outer = random.state<dim>(gas, 3);
        const State<dim> out = outsideOfWave<dim>
        (
            gas, inner, outer, random.vector<dim>(2), random.vector<dim>(2),
            random.vector<dim>(100)
        );
        EXPECT_TRUE(isPhysical<dim>(gas, out)) << out.transpose();
    }
}

} // namespace


TEST(FarField, letsPlaneWavesOut)
{
    letsPlaneWavesOut<2>();
    letsPlaneWavesOut<3>();
}


TEST(FarField, isHllcAlongTheNormal)
{
    isHllcAlongTheNormal<1>();
    isHllcAlongTheNormal<2>();
    isHllcAlongTheNormal<3>();
}


TEST(FarField, outsideIsPhysical)
{
    outsideIsPhysical<1>();
    outsideIsPhysical<2>();
    outsideIsPhysical<3>();
}


//! What comes in carries no more energy than what goes out, and is continuous
TEST(FarField, incomingIsBounded)
{
    RandomStates random;
    for (int sample = 0; sample < 2000; ++sample)
    {
        const double out = random.uniform(-1, 1);
        const double along = random.uniform(0, 3);
        const double mach = random.uniform(-1.2, 1.2);
        const double in = incomingOfPlaneWave(out, along, mach);
        const double most =
            std::abs(mach) >= 1 ? 0 : std::min(1.0, (1 + mach)/(1 - mach));
        EXPECT_LE(std::abs(in), most*std::abs(out)*(1 + 1e-14));
        EXPECT_NEAR
        (
            incomingOfPlaneWave(out, along + 1e-9, mach), in,
            1e-7*(1 + std::abs(in/out))
        );
    }
    // 45 degrees, and a motion along the surface without pressure
    EXPECT_NEAR
    (
        incomingOfPlaneWave(1 + std::sqrt(0.5), std::sqrt(0.5), 0),
        1 - std::sqrt(0.5), 1e-14
    );
    EXPECT_LT(std::abs(incomingOfPlaneWave(1e-3, 1, 0)), 1e-8);
}
