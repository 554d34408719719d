/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "RandomStates.hpp"

#include <gtest/gtest.h>

using namespace gasDynamics;

// Properties of air in round numbers, worked out by hand
TEST(PerfectGas, relationsOfItsConstants)
{
    const PerfectGas air(287.0, 1004.5);
    EXPECT_NEAR(air.gamma(), 1.4, 1e-14);
    EXPECT_NEAR(air.Cv(), 717.5, 1e-11);
    EXPECT_NEAR(air.Cp(), 1004.5, 1e-11);
    EXPECT_NEAR(air.density(1e5, 293), 1e5/(287.0*293.0), 1e-14);
    EXPECT_NEAR(air.temperature(1e5, 1.2), 1e5/(287.0*1.2), 1e-11);
    EXPECT_NEAR(air.internalEnergy(1e5), 2.5e5, 1e-8);
    EXPECT_NEAR(air.soundSpeed(1e5, 1.4), std::sqrt(1e5), 1e-10);
}

TEST(PerfectGas, fromGammaKeepsGammaAndR)
{
    const PerfectGas gas = PerfectGas::fromGamma(5.0/3.0, 2.5);
    EXPECT_NEAR(gas.gamma(), 5.0/3.0, 1e-14);
    EXPECT_EQ(gas.R(), 2.5);
}

TEST(PerfectGas, refusesConstantsOfNoGas)
{
    EXPECT_THROW(PerfectGas(0, 1000), std::invalid_argument);
    EXPECT_THROW(PerfectGas(-287, 1000), std::invalid_argument);
    EXPECT_THROW(PerfectGas(287, 287), std::invalid_argument);
    EXPECT_THROW(PerfectGas(287, 200), std::invalid_argument);
    EXPECT_THROW(PerfectGas(std::nan(""), 1000), std::invalid_argument);
    EXPECT_THROW(PerfectGas(287, std::nan("")), std::invalid_argument);
    EXPECT_THROW(PerfectGas::fromGamma(1), std::invalid_argument);
}

TEST(PerfectGas, errorNamesTheValues)
{
    try
    {
        PerfectGas(287, 200);
        FAIL() << "no error";
    }
    catch (const std::invalid_argument& e)
    {
        const std::string message = e.what();
        EXPECT_NE(message.find("R = 287"), std::string::npos) << message;
        EXPECT_NE(message.find("Cp = 200"), std::string::npos) << message;
    }
}

template<int dim>
void conservedAndBack()
{
    const PerfectGas gas = PerfectGas::fromGamma(1.4);
    RandomStates random;
    for (int i = 0; i < 100; ++i)
    {
        const double rho = random.uniform(0.1, 10), p = random.uniform(0.1, 10);
        const Vec<dim> U = random.vector<dim>(3);
        const State<dim> s = conserved<dim>(gas, rho, U, p);
        EXPECT_EQ(s[0], rho);
        EXPECT_LT((velocity<dim>(s) - U).norm(), 1e-14);
        EXPECT_NEAR(pressure<dim>(gas, s), p, 1e-13);
        EXPECT_NEAR(s[dim + 1], p/0.4 + 0.5*rho*U.squaredNorm(), 1e-12);
    }
}

TEST(ConservedState, goesToPrimitiveAndBack)
{
    conservedAndBack<1>();
    conservedAndBack<2>();
    conservedAndBack<3>();
}

TEST(ConservedState, knowsStatesThatCannotBe)
{
    const PerfectGas gas = PerfectGas::fromGamma(1.4);
    const State<2> good = conserved<2>(gas, 1, Vec<2>(1, -2), 1);
    EXPECT_TRUE(isPhysical<2>(gas, good));

    State<2> bad = good;
    bad[0] = -1;
    EXPECT_FALSE(isPhysical<2>(gas, bad));

    // kinetic energy alone is 2.5
    bad = good;
    bad[3] = 2.4;
    EXPECT_FALSE(isPhysical<2>(gas, bad));

    bad = good;
    bad[1] = std::nan("");
    EXPECT_FALSE(isPhysical<2>(gas, bad));
}
