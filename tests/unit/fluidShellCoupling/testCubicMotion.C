/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The motion within a coupling step, eq. (C4)

#include "cubicMotion.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(CubicMotion, reproducesACubicExactly)
{
    // d(t) = 1 - 2 t + 3 t^2 + 4 t^3 along (1 2 0), windows of unequal length
    auto d = [](scalar t) { return 1 - 2*t + 3*t*t + 4*t*t*t; };
    auto v = [](scalar t) { return -2 + 6*t + 12*t*t; };
    const vector e(1, 2, 0);
    const vectorField one(1, e);

    const pointField origin(1, Zero);
    cubicMotion motion(1);
    motion.reset(d(0)*one, v(0)*one);
    scalar t = 0;
    for (const scalar duration : {0.3, 0.5, 0.1})
    {
        motion.advance(duration, d(t + duration)*one, v(t + duration)*one);
        for (const scalar s : {0.0, 0.2, 0.5, 0.9, 1.0})
        {
            const vectorField at(motion.at(origin, s));
            EXPECT_LE(mag(at[0] - d(t + s*duration)*e), 1e-13);
        }
        t += duration;
    }
}


TEST(CubicMotion, isContinuousAcrossWindows)
{
    const pointField origin(1, Zero);
    cubicMotion motion(1);
    motion.reset(vectorField(1, Zero), vectorField(1, vector(3, 0, 0)));
    motion.advance(0.1, vectorField(1, vector(1, 0, 0)),
        vectorField(1, vector(-2, 0, 0)));
    const vectorField end(motion.at(origin, 1));
    motion.advance(0.4, vectorField(1, vector(5, 1, 0)),
        vectorField(1, vector(1, 1, 1)));
    EXPECT_LE(mag(end[0] - motion.at(origin, 0)()[0]), 1e-15);

    // Velocity at the start of the window, by a difference quotient
    const scalar h = 1e-6;
    const vector way = motion.at(origin, h)()[0] - motion.at(origin, 0)()[0];
    const vector velocity = way/(0.4*h);
    EXPECT_LE(mag(velocity - vector(-2, 0, 0)), 1e-3);
}


TEST(CubicMotion, anotherEndKeepsTheStart)
{
    const vectorField zero(1, Zero), x(1, vector(1, 0, 0));
    const pointField origin(1, Zero);
    cubicMotion motion(1), other(1);
    for (cubicMotion* m : {&motion, &other})
    {
        m->reset(0.1*x, 2*x);
        m->advance(0.1, 0.4*x, 3*x);
    }
    motion.setEnd(7*x, zero);
    motion.setEnd(0.4*x, 3*x);
    for (const scalar s : {0.0, 0.3, 0.7, 1.0})
    {
        EXPECT_EQ(motion.at(origin, s)(), other.at(origin, s)());
    }
    motion.setEnd(0.5*x, zero);
    EXPECT_LE(mag(motion.at(origin, 0)()[0] - 0.1*x[0]), 1e-15);
    EXPECT_EQ(motion.at(origin, 1)()[0], 0.5*x[0]);
}
