/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The geometry of the part of the mesh that moves, which may grow, gives what
// the geometry of the whole mesh gives

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A blast at the low end
gasSettings settings(const boxMesh& box)
{
    gasSettings s;
    s.box = box;
    s.schemes = "timeScheme twoStep; shockCapturing fluxCorrected;";
    s.allPatches("wall");
    s.boundary["left"] = "farField";
    s.start = [](const point& x)
    {
        const bool inside = x.x() < 0.3;
        return testGas::state(inside ? 4e5 : 1e5, Zero, inside ? 3 : 1.2);
    };
    return s;
}

//- What is right of a place moves there and back
pointField bulge(const pointField& x0, const scalar from, const scalar amount)
{
    pointField x(x0);
    for (point& xi : x)
    {
        const scalar s = max(xi.x() - from, scalar(0));
        xi.x() += amount*s*(1 - xi.x());
        xi.x() += amount*s*xi.y()*xi.z()*(1 - xi.x());
    }
    return x;
}

struct answer
{
    scalarField p, rho, Ux;
    scalar stable, mass;
};

//- all: every node has moved before
answer run(const boxMesh& box, const bool all)
{
    gasCase gas(settings(box));
    const scalar dt = 0.3*gas.gas().stable().deltaT;
    const pointField x0(gas.x());
    if (all)
    {
        gas.gas().storeOldState();
        gas.gas().advance(dt, x0 + 1e-3*vector(1, 0, 0));
        gas.gas().restoreOldState();
    }
    auto steps = [&](const scalar from)
    {
        for (label i = 1; i <= 6; ++i)
        {
            gas.gas().advance
            (
                dt, bulge(x0, from, 0.1*std::sin(0.7*i))
            );
        }
    };
    steps(0.7);

    // Rests where it is, then moves again, farther
    gas.run(2, dt);
    steps(0.4);
    gas.run(1, dt);
    return answer
    {
        gas.scalars("p"), gas.scalars("rho"), gas.U().component(0)(),
        gas.gas().stable().deltaT, gas.gas().totals().mass
    };
}

void compare(const boxMesh& box)
{
    const answer part(run(box, false)), whole(run(box, true));
    EXPECT_GT(max(whole.p), 1.5*min(whole.p));
    EXPECT_LE(largest((part.p - whole.p)/1e5), 1e-11);
    EXPECT_LE(largest(part.rho - whole.rho), 1e-11);
    EXPECT_LE(largest((part.Ux - whole.Ux)/340.0), 1e-11);
    EXPECT_NEAR(part.stable, whole.stable, 1e-11*whole.stable);
    EXPECT_NEAR(part.mass, whole.mass, 1e-12*whole.mass);
}

} // End namespace


TEST(MovingPart, givesWhatTheWholeGives)
{
    compare(boxMesh::lines(40));
    compare(boxMesh::plane(16, 6));
    compare(boxMesh::space(10, 4, 3));
}


TEST(MovingPart, whatIsStillInUniformGasKeepsItsBits)
{
    gasSettings s = settings(boxMesh::space(10, 4, 3));
    s.start = [](const point&) { return testGas::state(1e5, Zero, 1.2); };
    gasCase gas(s);
    const scalarField before(gas.scalars("rho"));
    const pointField x0(gas.x());
    const scalar dt = 0.3*gas.gas().stable().deltaT;
    gas.gas().advance(dt, bulge(x0, 0.7, 0.01));
    const scalarField after(gas.scalars("rho"));
    label moved = 0;
    forAll(x0, a)
    {
        if (x0[a].x() < 0.35)
        {
            // Farther than a step reaches
            EXPECT_EQ(after[a], before[a]);
        }
        moved += (gas.x()[a] != x0[a]);
    }
    EXPECT_GT(moved, 0);
    EXPECT_LT(moved, x0.size()/2);
}
