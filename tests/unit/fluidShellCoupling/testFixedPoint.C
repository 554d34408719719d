/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Accelerations of the coupling iteration on linear passes, whose answers are
// known: (C16)-(C18)

#include "fixedPoint.H"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace Foam;
using Vector = positionalShell::Vector;

namespace
{

//- g(u) = A u + b
struct pass
{
    Eigen::MatrixXd A;
    Vector b;

    Vector operator()(const Vector& u) const { return A*u + b; }

    Vector fixed() const
    {
        const auto n = b.size();
        return (Eigen::MatrixXd::Identity(n, n) - A).lu().solve(b);
    }
};

pass diagonal(const Vector& factors)
{
    return pass{factors.asDiagonal(), Vector::Ones(factors.size())};
}

//- Error after n passes from zero
scalar errorAfter
(
    const fixedPoint::method method,
    const pass& g,
    const label n,
    const scalar omega
)
{
    fixedPoint accelerated(method);
    accelerated.begin(omega);
    Vector u = Vector::Zero(g.b.size());
    for (label i = 0; i < n; ++i)
    {
        u = accelerated.next(u, g(u));
    }
    return (u - g.fixed()).norm();
}

} // End namespace


TEST(FixedPoint, constantRelaxationByHand)
{
    // g = -3 u + 8, fixed at 2, diverges by itself
    pass g{Eigen::MatrixXd::Constant(1, 1, -3), Vector::Constant(1, 8)};
    fixedPoint f(fixedPoint::constant);
    f.begin(0.2);
    Vector u = Vector::Zero(1);
    u = f.next(u, g(u));
    EXPECT_NEAR(u[0], 1.6, 1e-15);
    u = f.next(u, g(u));
    EXPECT_NEAR(u[0], 1.92, 1e-15);
    EXPECT_GT(errorAfter(fixedPoint::constant, g, 20, 1), 1e6);
}


TEST(FixedPoint, aitkenByHand)
{
    // Residuals 8 at 0 and 1.6 at 1.6: omega 0.2*(-8*(1.6 - 8)/6.4^2) = 1/4,
    // which is exact in one dimension
    pass g{Eigen::MatrixXd::Constant(1, 1, -3), Vector::Constant(1, 8)};
    fixedPoint f(fixedPoint::Aitken);
    f.begin(0.2);
    Vector u = Vector::Zero(1);
    u = f.next(u, g(u));
    u = f.next(u, g(u));
    EXPECT_NEAR(f.omega(), 0.25, 1e-15);
    EXPECT_NEAR(u[0], 2, 1e-14);
}


TEST(FixedPoint, aitkenConvergesWherePlainPassesDiverge)
{
    Vector factors(3);
    factors << -4, -2.5, -1;
    const pass g(diagonal(factors));
    EXPECT_GT(errorAfter(fixedPoint::constant, g, 30, 1), 1e6);
    EXPECT_LT(errorAfter(fixedPoint::Aitken, g, 30, 0.3), 1e-6);
}


TEST(FixedPoint, quasiNewtonIsExactAfterAsManyPassesAsDimensions)
{
    Vector factors(4);
    factors << -30, -6, 2, 0.5;
    const pass g(diagonal(factors));
    EXPECT_GT(errorAfter(fixedPoint::quasiNewton, g, 3, 0.1), 1e-3);
    EXPECT_LT(errorAfter(fixedPoint::quasiNewton, g, 6, 0.1), 1e-10);
}


TEST(FixedPoint, quasiNewtonBearsPassesThatRepeatOthers)
{
    // One direction only: from the third pass on columns are rounding
    Vector factors = Vector::Constant(5, -7);
    const pass g(diagonal(factors));
    for (const label n : {2, 3, 6, 12})
    {
        EXPECT_LT(errorAfter(fixedPoint::quasiNewton, g, n, 0.1), 1e-12) << n;
    }
}


TEST(FixedPoint, beginForgetsTheStepBefore)
{
    pass g{Eigen::MatrixXd::Constant(1, 1, -3), Vector::Constant(1, 8)};
    fixedPoint f(fixedPoint::quasiNewton);
    for (label step = 0; step < 2; ++step)
    {
        f.begin(0.2);
        const Vector u = f.next(Vector::Zero(1), g(Vector::Zero(1)));
        EXPECT_NEAR(u[0], 1.6, 1e-15);
    }
}
