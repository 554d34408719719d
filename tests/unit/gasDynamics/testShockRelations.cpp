/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "CsvTable.hpp"
#include "gasDynamics/EulerFlux.hpp"
#include "gasDynamics/ShockRelations.hpp"

#include <gtest/gtest.h>

using namespace gasDynamics;

namespace
{

const PerfectGas gas = PerfectGas::fromGamma(1.4);

// The table has 7 digits
constexpr double TABLE_DIGITS = 1e-6;

} // namespace

TEST(ShockRelations, incidentShockOfTheTable)
{
    const CsvTable table("normal_shock_reflection.csv");
    ASSERT_GE(table.size(), 10u);
    const Primitive1D ahead{1.4, 0, 1};

    for (std::size_t i = 0; i < table.size(); ++i)
    {
        const double Ms = table(i, "Ms");
        SCOPED_TRACE(Ms);
        const Primitive1D s = behindShock(gas, ahead, Ms);
        const double p = table(i, "p2_p1"), rho = table(i, "rho2_rho1");
        const double u = table(i, "u2_c1");
        EXPECT_NEAR(s.p, p, TABLE_DIGITS*p);
        EXPECT_NEAR(s.rho, 1.4*rho, TABLE_DIGITS*rho);
        EXPECT_NEAR(s.u, u, TABLE_DIGITS*u);
    }
}

TEST(ShockRelations, reflectedPressureOfTheTable)
{
    const CsvTable table("normal_shock_reflection.csv");
    for (std::size_t i = 0; i < table.size(); ++i)
    {
        SCOPED_TRACE(table(i, "Ms"));
        const double p2 = behindShock(gas, {1.4, 0, 1}, table(i, "Ms")).p;
        const double p5 = table(i, "p5_p1");
        EXPECT_NEAR(reflectedPressure(gas, 1, p2), p5, TABLE_DIGITS*p5);
    }
}

// Rankine-Hugoniot: F2 - F1 = speed (s2 - s1), for a gas that moves ahead
TEST(ShockRelations, conserveMassMomentumAndEnergy)
{
    for (const double gamma : {1.2, 1.4, 5.0/3.0})
    {
        const PerfectGas other = PerfectGas::fromGamma(gamma);
        const Primitive1D ahead{1.189, -40, 1e5};
        for (const double Ms : {1.0, 1.21, 2.0, 8.0})
        {
            const Primitive1D s = behindShock(other, ahead, Ms);
            const double speed = ahead.u + Ms*other.soundSpeed(ahead.p, ahead.rho);
            const auto s1 = conserved<1>(other, ahead.rho, Vec<1>(ahead.u), ahead.p);
            const auto s2 = conserved<1>(other, s.rho, Vec<1>(s.u), s.p);
            const State<1> f2 = fluxThrough<1>(s2, s.p, Vec<1>(1), Vec<1>(speed));
            const State<1> f1 = fluxThrough<1>(s1, ahead.p, Vec<1>(1), Vec<1>(speed));
            for (int k = 0; k < 3; ++k)
            {
                EXPECT_NEAR(f2[k], f1[k], 1e-11*(1 + std::abs(f1[k])));
            }
        }
    }
}

// A wall is a plane of symmetry: two equal shocks that meet reflect as from it
TEST(ShockRelations, reflectionIsTheRiemannProblemOfTwoShocks)
{
    const Primitive1D ahead{1.189, 0, 1e5};
    for (const double Ms : {1.05, 1.21, 2.0, 5.0})
    {
        const Primitive1D s = behindShock(gas, ahead, Ms);
        const ExactRiemann meeting(gas, s, {s.rho, -s.u, s.p});
        const double p5 = reflectedPressure(gas, ahead.p, s.p);
        EXPECT_NEAR(meeting.pStar(), p5, 1e-12*p5);
        EXPECT_NEAR(meeting.uStar(), 0, 1e-10);
    }
}

// Strong shocks: p5/p2 -> (3 gamma - 1)/(gamma - 1), 8 for gamma 1.4
TEST(ShockRelations, limits)
{
    EXPECT_NEAR(reflectedPressure(gas, 1, 1e9)/1e9, 8, 1e-7);
    EXPECT_NEAR((reflectedPressure(gas, 1, 1 + 1e-7) - 1)/1e-7, 2, 1e-5);
    EXPECT_NEAR(behindShock(gas, {1, 0, 1}, 1e4).rho, 6, 1e-6);
}

TEST(ShockRelations, refuseAMachNumberBelowOne)
{
    EXPECT_THROW(behindShock(gas, {1, 0, 1}, 0.99), std::invalid_argument);
    EXPECT_THROW(behindShock(gas, {1, 0, 1}, std::nan("")), std::invalid_argument);
}
