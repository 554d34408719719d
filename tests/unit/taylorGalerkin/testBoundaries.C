/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Boundaries: prescribed values, far field, and what must be refused

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

primitive rest()
{
    return testGas::state(1e5, vector::zero, 1.2);
}

//- A weak wave that runs to the right at the speed of sound
primitive simpleWave(const point& x)
{
    const scalar bump = 1e-3*std::exp(-sqr((x.x() - 0.5)/0.06));
    const scalar c = std::sqrt(1.4*1e5/1.2);
    return testGas::state
    (
        1e5*(1 + bump), vector(c*bump/1.4, 0, 0), 1.2*(1 + bump/1.4)
    );
}

template<class Action>
std::string errorOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "no error";
}

void expectMention(const std::string& message, const char* words)
{
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // End namespace


TEST(Boundaries, fixedValuesHold)
{
    gasSettings s;
    s.box = boxMesh::plane(6, 6);
    s.start = [](const point& x)
    {
        return testGas::state(1e5*(1 + x.y()), vector(80, 10, 0), 1 + x.y());
    };
    s.boundary["left"] = "fixedValue";
    gasCase gas(s);
    gas.run(10, 0.3*gas.gas().stable().deltaT);
    const scalarField p(gas.scalars("p")), rho(gas.scalars("rho"));
    const vectorField U(gas.U());
    for (const label i : gas.gas().mesh().patch("left").nodes)
    {
        const primitive v(s.start(gas.x()[i]));
        EXPECT_NEAR(p[i]/v.p, 1, 1e-13);
        EXPECT_NEAR(rho[i]/(v.p/(testGas::R()*v.T)), 1, 1e-13);
        EXPECT_LE(mag(U[i] - v.U), 1e-11);
    }
}


namespace
{

//- What is left of a wave when it has gone out through a far field and its
//  echo would be in the middle of the tube, as a part of the wave
scalar echo(const std::string& scheme, const label nCells)
{
    gasSettings s;
    s.box = boxMesh::lines(nCells);
    s.start = simpleWave;
    s.schemes = "timeScheme " + scheme + "; shockCapturing none;";
    s.boundary["right"] = s.boundary["left"] = "farField";
    gasCase gas(s);
    const scalar start = largest(gas.scalars("p") - 1e5);
    EXPECT_GT(start, 90);

    const scalar c = std::sqrt(1.4*1e5/1.2);
    const scalar dt = 0.5*gas.gas().stable().deltaT;
    gas.run(label(1.0/c/dt), dt);
    return largest(gas.scalars("p") - 1e5)/start;
}

} // End namespace


TEST(Boundaries, farFieldLetsWavesOut)
{
    EXPECT_LE(echo("twoStep", 200), 1e-5);

    // threeStep sees its neighbours' mass flux of the step's end, the far
    // field's of the start: an echo of first order in the step
    const scalar coarse = echo("threeStep", 200), fine = echo("threeStep", 400);
    EXPECT_LE(coarse, 0.04);
    EXPECT_LE(fine, 0.55*coarse);
}


// The same wave is sent back by a wall, so the test above can tell
TEST(Boundaries, wallSendsWavesBack)
{
    gasSettings s;
    s.box = boxMesh::lines(200);
    s.start = simpleWave;
    s.boundary["right"] = "wall";
    gasCase gas(s);
    const scalar start = largest(gas.scalars("p") - 1e5);
    const scalar c = std::sqrt(1.4*1e5/1.2);
    const scalar dt = 0.5*gas.gas().stable().deltaT;
    gas.run(label(1.0/c/dt), dt);

    const scalarField p(gas.scalars("p"));
    const label at = findMax(p);
    EXPECT_NEAR(p[at] - 1e5, start, 0.03*start);
    EXPECT_NEAR(gas.x()[at].x(), 0.5, 0.02);
    EXPECT_LT(gas.U()[at].x(), 0);
}


// Outer state other than the inner one: the flow goes to it
TEST(Boundaries, farFieldDrivesTheFlow)
{
    gasSettings s;
    s.box = boxMesh::lines(50);
    s.schemes = "timeScheme twoStep; shockCapturing pressureLaplacian;";
    const primitive outer(testGas::state(1.5e5, vector(100, 0, 0), 1.6));
    s.start = [&](const point& x)
    {
        return x.x() < 1e-9 || x.x() > 1 - 1e-9 ? outer : rest();
    };
    s.boundary["left"] = s.boundary["right"] = "farField";
    gasCase gas(s);
    const scalar dt = 0.3*gas.gas().stable().deltaT;
    gas.run(3000, dt);
    EXPECT_LE(largest(gas.scalars("p")/1.5e5 - 1), 1e-3);
    EXPECT_LE(max(mag(gas.U() - outer.U)), 0.5);
}


TEST(Boundaries, initialStateMustBePhysical)
{
    gasSettings s;
    s.box = boxMesh::lines(5);
    s.start = [](const point& x)
    {
        primitive v(rest());
        v.T = x.x() > 0.5 ? -5 : 300;
        return v;
    };
    const std::string message = errorOf([&]() { gasCase gas(s); });
    expectMention(message, "not physical");
    expectMention(message, "T = -5");
}


// A step far beyond the stable one: stops, says where and what to do, and has
// written the state before
TEST(Boundaries, stopsBeforeAStateThatCannotBe)
{
    for (const char* scheme : {"twoStep", "threeStep"})
    {
        gasSettings s;
        s.box = boxMesh::lines(40);
        s.schemes = std::string("timeScheme ") + scheme
          + "; shockCapturing none;";
        s.start = [](const point& x)
        {
            return testGas::state(x.x() < 0.5 ? 1e6 : 1e4, vector::zero, 1);
        };
        gasCase gas(s);
        const scalar dt = 3*gas.gas().stable().deltaT;
        const std::string message = errorOf([&]() { gas.run(20, dt); });
        expectMention(message, "no longer in a physical state");
        expectMention(message, "node ");
        expectMention(message, "maxCo");
        expectMention(message, "fluxCorrected");

        for (const char* name : {"p", "U", "T", "rho"})
        {
            EXPECT_TRUE(isFile(gas.path()/gas.clock().timeName()/name)) << name;
        }
        EXPECT_GT(min(gas.scalars("p")), 0);
        EXPECT_GT(min(gas.scalars("rho")), 0);
    }
}
