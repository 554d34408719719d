/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Prescribed motions: the derivatives against differences of the values

#include "IStringStream.H"
#include "shellTimeFunction.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Foam;

namespace
{

dictionary dictFrom(const std::string& text)
{
    IStringStream is(text);
    return dictionary(is);
}


//- A motion and the length of time over which it changes
struct motion
{
    const char* name;
    const char* entry;
    scalar period;
};

void PrintTo(const motion& m, std::ostream* os) { *os << m.name; }

class Motion : public testing::TestWithParam<motion> {};

} // End namespace


// Central differences with h = 1e-3 of the period: their truncation error is
// h^2/6 of the third (h^2/12 of the fourth) derivative, for a sine of size A
// 6.6e-6 omega A (3.3e-6 omega^2 A); the other motions are no rougher
TEST_P(Motion, derivativesAreThoseOfTheValue)
{
    const motion& m = GetParam();
    const auto f =
        readMotion("displacement", dictFrom(m.entry), true);

    const scalar h = 1e-3*m.period;
    const scalar omega = 6.3/m.period;
    scalar size = 0;
    for (int i = 0; i <= 20; ++i)
    {
        size = std::max(size, std::abs(f->value(i*m.period/20)));
    }
    std::mt19937 random(11);
    std::uniform_real_distribution<scalar> times(0.01, 0.99);

    for (int i = 0; i < 20; ++i)
    {
        const scalar t = m.period*times(random);
        EXPECT_NEAR
        (
            f->firstDerivative(t),
            (f->value(t + h) - f->value(t - h))/(2*h),
            1e-5*omega*size
        );
        EXPECT_NEAR
        (
            f->secondDerivative(t),
            (f->value(t + h) - 2*f->value(t) + f->value(t - h))/(h*h),
            1e-5*omega*omega*size
        );
    }
}


// In statics any Function1 will do; its value is the same
TEST_P(Motion, valueIsThatOfTheFunction)
{
    const motion& m = GetParam();
    const auto dynamic = readMotion("displacement", dictFrom(m.entry), true);
    const auto statics = readMotion("displacement", dictFrom(m.entry), false);

    for (const scalar part : {0.0, 0.1, 0.37, 1.2})
    {
        EXPECT_DOUBLE_EQ
        (
            dynamic->value(part*m.period), statics->value(part*m.period)
        );
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Types, Motion,
    testing::Values
    (
        motion{"number", "displacement 0.7;", 1},
        motion{"constant", "displacement constant 0.7;", 1},
        motion{"zero", "displacement zero;", 1},
        motion{"one", "displacement one;", 1},
        motion
        {
            "polynomial",
            "displacement polynomial ((0.3 0) (-0.2 1) (0.5 2) (0.25 3.5));",
            1
        },
        motion
        {
            "sine",
            "displacement { type sine; frequency 12; amplitude 0.4; scale 1.5;"
            " level 0.2; t0 0.013; }",
            1.0/12
        },
        motion
        {
            "sineCoeffs",
            "displacement sine; displacementCoeffs { frequency 2;"
            " amplitude 1; scale 1; level 0; }",
            0.5
        },
        motion
        {
            "smoothStep",
            "displacement { type smoothStep; start -0.05; duration 1.2;"
            " height 0.8; }",
            1.0
        }
    )
);


TEST(PrescribedMotion, withUnknownDerivativesIsAnErrorInDynamics)
{
    const dictionary dict(dictFrom("displacement table ((0 0) (1 1));"));

    const auto statics = readMotion("displacement", dict, false);
    EXPECT_DOUBLE_EQ(statics->value(0.25), 0.25);
    try
    {
        readMotion("displacement", dict, true);
        FAIL() << "no error";
    }
    catch (const IOerror& e)
    {
        EXPECT_NE(e.message().find("smoothStep"), std::string::npos)
            << e.message();
    }
}


TEST(LoadFactor, isOneWhenAbsent)
{
    EXPECT_EQ(readLoadFactor("factor", dictFrom("a 1;"))->value(3), 1);
}


TEST(LoadFactor, isAnyFunction)
{
    const auto f = readLoadFactor
    (
        "factor", dictFrom("factor table ((0 0) (2 1));")
    );
    EXPECT_DOUBLE_EQ(f->value(0.5), 0.25);
}
