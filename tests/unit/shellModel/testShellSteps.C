/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Steps of a shell: given forces, repeated steps, driven nodes, energies

#include "shellCase.H"
#include "shellVector.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using positionalShell::Component;
typedef positionalShell::Vector fullVector;

namespace
{

//- A force along z on every node
fullVector force(const shellModel& shell, const scalar size)
{
    fullVector f = fullVector::Zero(shell.nDofs());
    for (int node = 0; node < shell.mesh().nNodes(); ++node)
    {
        f[positionalShell::fullIndex(node, Component::z)] = size;
    }
    return f;
}

} // End namespace


TEST(ShellSteps, aRepeatedStepStartsFromTheSameBits)
{
    shellCase made(clamp, "");
    shellModel shell(made.time());
    for (int i = 0; i < 3; ++i)
    {
        shell.advance(0.01, force(shell, 0.01));
    }

    shell.storeOldState();
    const fullVector start = shell.state().position;
    const scalar work = shell.energies().externalWork;
    shell.advance(0.01, force(shell, 0.02));
    const fullVector first = shell.state().position;
    const scalar firstWork = shell.energies().externalWork;

    shell.restoreOldState();
    EXPECT_EQ(shell.state().position, start);
    EXPECT_EQ(shell.energies().externalWork, work);
    EXPECT_NEAR(shell.state().time, 0.03, 1e-15);

    // Another force gives another end ...
    shell.advance(0.01, force(shell, -0.02));
    EXPECT_GT((shell.state().position - first).norm(), 1e-4);

    // ... and the first one the first end, to the tolerance of Newton
    shell.restoreOldState();
    shell.advance(0.01, force(shell, 0.02));
    EXPECT_LE
    (
        (shell.state().position - first).norm(),
        1e-6*(first - start).norm()
    );
    EXPECT_NEAR
    (
        shell.energies().externalWork, firstWork, 1e-6*std::abs(firstWork)
    );
    EXPECT_NEAR(shell.state().time, 0.04, 1e-15);
}


// A free body under a constant force F: momentum F t, whatever its shape does
TEST(ShellSteps, aFreeShellGainsTheMomentumOfTheForce)
{
    shellCase made("", "");
    shellModel shell(made.time());
    const fullVector f = force(shell, 0.01);
    for (int i = 0; i < 10; ++i)
    {
        shell.advance(0.01, f);
    }

    const vector momentum
    (
        toFoam(shell.model().linearMomentum(shell.state().velocity))
    );
    EXPECT_LE(mag(momentum - 0.1*resultant(f)), 1e-7*mag(momentum));
    EXPECT_LE(mag(shell.energies().impulse - momentum), 1e-7*mag(momentum));
}


TEST(ShellSteps, drivenNodesMoveAsPrescribed)
{
    shellCase made
    (
        "a { type prescribed; nodeSet uMin; component z; displacement"
        " { type sine; frequency 3; amplitude 0.1; scale 1; level 0; } }"
        " b { type fixed; nodeSet uMin; components (x y gx gy gz); }",
        ""
    );
    shellModel shell(made.time());
    for (int i = 0; i < 5; ++i)
    {
        shell.advance(0.01);
    }

    const scalar omega = 6*std::acos(-1.0);
    const int node = shell.mesh().nodeSet("uMin").front();
    const int i = positionalShell::fullIndex(node, Component::z);
    EXPECT_NEAR(shell.state().position[i], 0.1*std::sin(omega*0.05), 1e-14);
    EXPECT_NEAR
    (
        shell.state().velocity[i], 0.1*omega*std::cos(omega*0.05), 1e-12
    );

    // The energy of the shell came through the driven nodes
    const shellEnergies e(shell.energies());
    EXPECT_EQ(e.externalWork, 0);
    EXPECT_GT(e.kinetic + e.strain, 0);
    EXPECT_LE(std::abs(e.mismatch()), 0.02*(e.kinetic + e.strain));
}


TEST(ShellSteps, staticsFindsTheStateWithoutInertia)
{
    shellCase made
    (
        clamp,
        "a { type edge; nodeSet uMax; forcePerLength (0 0 0.001); }",
        "analysis static;"
    );
    shellModel shell(made.time());
    shell.advance(1);

    // Timoshenko's cantilever P L^3/(3 E I), wide: between plane stress and
    // plane strain (1 - nu^2); the shear adds less than 1 %
    const scalar beam = 0.001*8/(3*1000*1e-3/12);
    EXPECT_LE(shell.maxDisplacement(), 1.01*beam);
    EXPECT_GE(shell.maxDisplacement(), 0.91*beam);
    EXPECT_EQ(shell.energies().kinetic, 0);
}


TEST(ShellSteps, aForceOfAnotherSizeIsAnError)
{
    shellCase made(clamp, "");
    shellModel shell(made.time());
    EXPECT_THROW(shell.advance(0.01, fullVector::Zero(3)), error);
}


TEST(ShellSteps, nothingIsWrittenBeforeTheFirstStep)
{
    shellCase made(clamp, "");
    shellModel shell(made.time());
    shell.write();
    EXPECT_FALSE(shellStateExists(made.time(), made.time->timeName()));
}


TEST(ShellSteps, theStateIsReadBackToTheLastBit)
{
    shellCase made(clamp, "a { type gravity; g (0.3 0 -1); }");
    fullVector position;
    fullVector acceleration;
    shellEnergies energies;
    {
        shellModel shell(made.time());
        for (int i = 0; i < 3; ++i)
        {
            shell.advance(0.01);
        }
        shell.write();
        position = shell.state().position;
        acceleration = shell.state().acceleration;
        energies = shell.energies();
    }

    const shellModel again(made.time());
    EXPECT_EQ(again.state().position, position);
    EXPECT_EQ(again.state().acceleration, acceleration);
    EXPECT_EQ(again.energies().externalWork, energies.externalWork);
    EXPECT_EQ(again.energies().kinetic, energies.kinetic);
    EXPECT_EQ(again.energies().mismatch(), energies.mismatch());
}
