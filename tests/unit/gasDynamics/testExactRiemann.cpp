/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "CsvTable.hpp"
#include "RandomStates.hpp"
#include "gasDynamics/EulerFlux.hpp"
#include "gasDynamics/ExactRiemann.hpp"

#include <gtest/gtest.h>

using namespace gasDynamics;

namespace
{

const PerfectGas gas = PerfectGas::fromGamma(1.4);

// The table has 8 digits
constexpr double TABLE_DIGITS = 1e-7;

State<1> stateOf(const Primitive1D& s)
{
    return conserved<1>(gas, s.rho, Vec<1>(s.u), s.p);
}

struct TableRow
{
    Primitive1D left, right;
    double speedScale;

    TableRow(const CsvTable& t, std::size_t i)
    :
        left{t(i, "rhoL"), t(i, "uL"), t(i, "pL")},
        right{t(i, "rhoR"), t(i, "uR"), t(i, "pR")},
        speedScale
        (
            gas.soundSpeed(left.p, left.rho)
          + gas.soundSpeed(right.p, right.rho)
        )
    {}
};

} // namespace

TEST(ExactRiemann, starStatesOfTheTable)
{
    const CsvTable table("riemann_star_states.csv");
    ASSERT_GE(table.size(), 10u);

    for (std::size_t i = 0; i < table.size(); ++i)
    {
        SCOPED_TRACE(table.text(i, "problem"));
        const TableRow row(table, i);
        const ExactRiemann solution(gas, row.left, row.right);
        const double p = table(i, "p_star"), u = table(i, "u_star");

        EXPECT_NEAR(solution.pStar(), p, TABLE_DIGITS*p);
        EXPECT_NEAR(solution.uStar(), u, TABLE_DIGITS*row.speedScale);

        const double beside = 1e-9*row.speedScale;
        const double rhoL = table(i, "rho_starL"), rhoR = table(i, "rho_starR");
        const double uStar = solution.uStar();
        EXPECT_NEAR(solution.sample(uStar - beside).rho, rhoL, TABLE_DIGITS*rhoL);
        EXPECT_NEAR(solution.sample(uStar + beside).rho, rhoR, TABLE_DIGITS*rhoR);
    }
}

// Just outside the head of each outer wave the state is undisturbed; just
// inside it is not (shock) or changes linearly from it (head of a fan)
TEST(ExactRiemann, wavesAreWhereTheTableHasThem)
{
    const CsvTable table("riemann_star_states.csv");
    for (std::size_t i = 0; i < table.size(); ++i)
    {
        SCOPED_TRACE(table.text(i, "problem"));
        const TableRow row(table, i);
        const ExactRiemann solution(gas, row.left, row.right);
        const double eps = 1e-6*row.speedScale;

        auto check = [&](const Primitive1D& outer, double head, double tail,
                         double side, const std::string& kind)
        {
            const double jump = solution.pStar() - outer.p;
            if (std::abs(jump) < 1e-5*outer.p)
            {
                return;
            }
            EXPECT_EQ(solution.sample(head + side*eps).p, outer.p);
            EXPECT_NE(solution.sample(head - side*eps).p, outer.p);
            EXPECT_EQ(solution.sample(tail - side*eps).p, solution.pStar());
            EXPECT_EQ(kind, jump > 0 ? "shock" : "raref");
        };
        check(row.left, table(i, "left_speed_head"), table(i, "left_speed_tail"),
              -1, table.text(i, "left_wave"));
        check(row.right, table(i, "right_speed_head"), table(i, "right_speed_tail"),
              1, table.text(i, "right_wave"));
    }
}

// By the conservation law itself, independent of any table: over a fan of
// waves between the rays a and b, the integral of the state equals
// b s(b) - a s(a) - F(b) + F(a)
TEST(ExactRiemann, conservesMassMomentumAndEnergy)
{
    RandomStates random;
    int tested = 0;
    while (tested < 20)
    {
        const Primitive1D L{random.uniform(.1, 2), random.uniform(-1, 1), random.uniform(.1, 2)};
        const Primitive1D R{random.uniform(.1, 2), random.uniform(-1, 1), random.uniform(.1, 2)};
        const ExactRiemann solution(gas, L, R);
        const double a = -9, b = 9;
        ASSERT_EQ(solution.sample(a).p, L.p);
        ASSERT_EQ(solution.sample(b).p, R.p);

        const int n = 200000;
        const double h = (b - a)/n;
        State<1> integral = State<1>::Zero();
        for (int i = 0; i < n; ++i)
        {
            integral += h*stateOf(solution.sample(a + (i + 0.5)*h));
        }
        const State<1> sL = stateOf(L), sR = stateOf(R);
        const State<1> expected =
            b*sR - a*sL - eulerFlux<1>(sR, R.p) + eulerFlux<1>(sL, L.p);

        // Midpoint rule: at most one interval per discontinuity is wrong
        EXPECT_LT((integral - expected).norm(), 10*h);
        ++tested;
    }
}

TEST(ExactRiemann, insideAFanTheCharacteristicsAreStraight)
{
    const Primitive1D L{1, -2, 0.4}, R{1, 2, 0.4};
    const ExactRiemann solution(gas, L, R);
    const double cL = gas.soundSpeed(L.p, L.rho);
    for (double speed = -2.7; speed < -0.4; speed += 0.1)
    {
        const Primitive1D s = solution.sample(speed);
        const double c = gas.soundSpeed(s.p, s.rho);
        EXPECT_NEAR(s.u - c, speed, 1e-12);
        EXPECT_NEAR(s.u + 5*c, L.u + 5*cL, 1e-12);
        EXPECT_NEAR(s.p/std::pow(s.rho, 1.4), L.p/std::pow(L.rho, 1.4), 1e-12);
    }
}

TEST(ExactRiemann, equalStatesStayAsTheyAre)
{
    const Primitive1D s{1.2, 3, 1e5};
    const ExactRiemann solution(gas, s, s);
    EXPECT_NEAR(solution.pStar(), 1e5, 1e-9);
    EXPECT_NEAR(solution.uStar(), 3, 1e-12);
    EXPECT_NEAR(solution.sample(3.1).rho, 1.2, 1e-14);
}

TEST(ExactRiemann, mirroredProblemHasTheMirroredSolution)
{
    const Primitive1D L{1, 0.75, 1}, R{0.125, -0.1, 0.1};
    const ExactRiemann one(gas, L, R);
    const ExactRiemann other(gas, {R.rho, -R.u, R.p}, {L.rho, -L.u, L.p});
    for (double speed = -3; speed <= 3; speed += 0.37)
    {
        EXPECT_NEAR(one.sample(speed).rho, other.sample(-speed).rho, 1e-13);
        EXPECT_NEAR(one.sample(speed).u, -other.sample(-speed).u, 1e-13);
    }
}

TEST(ExactRiemann, refusesStatesThatCannotBe)
{
    const Primitive1D good{1, 0, 1};
    for (const Primitive1D& bad : {Primitive1D{-1, 0, 1}, Primitive1D{1, 0, 0},
                                   Primitive1D{1, std::nan(""), 1},
                                   Primitive1D{std::nan(""), 0, 1}})
    {
        EXPECT_THROW(ExactRiemann(gas, good, bad), std::invalid_argument);
        EXPECT_THROW(ExactRiemann(gas, bad, good), std::invalid_argument);
    }
}

// Limit of two fans without vacuum: uR - uL = 2 (cL + cR)/(gamma - 1)
TEST(ExactRiemann, refusesVacuum)
{
    const double c = gas.soundSpeed(1, 1);
    EXPECT_THROW
    (
        ExactRiemann(gas, {1, -5.001*c, 1}, {1, 5.001*c, 1}), std::invalid_argument
    );
    const ExactRiemann thin(gas, {1, -4.9*c, 1}, {1, 4.9*c, 1});
    EXPECT_GT(thin.pStar(), 0);
}
