/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Velocity constraints and pressure forces at slip walls

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Nodes of a patch, or of two patches at once
labelList nodesOf(gasCase& gas, const word& one, const word& other)
{
    const labelHashSet a(gas.gas().mesh().patch(one).nodes);
    const labelHashSet b(gas.gas().mesh().patch(other).nodes);
    return (a & b).sortedToc();
}

primitive gust(const point& x)
{
    return testGas::state
    (
        1e5*(1 + 0.3*std::sin(7*x.x() + 5*x.y() + 3*x.z())),
        vector(60, -40, 30), 1.2
    );
}

} // End namespace


TEST(Walls, holdTheNormalVelocityAlone)
{
    gasSettings s;
    s.box = boxMesh::space(5, 4, 3);
    s.start = gust;
    s.boundary["bottom"] = s.boundary["back"] = "wall";
    gasCase gas(s);
    gas.run(5, 0.2*gas.gas().stable().deltaT);
    const vectorField U(gas.U());

    scalar slip = 0;
    for (const label i : gas.gas().mesh().patch("bottom").nodes)
    {
        EXPECT_LE(mag(U[i].y()), 1e-12);
        slip = max(slip, mag(U[i].x()));
    }
    for (const label i : gas.gas().mesh().patch("back").nodes)
    {
        EXPECT_LE(mag(U[i].z()), 1e-12);
    }
    EXPECT_GT(slip, 10);

    // A node on the edge keeps both constraints, and slides along it
    for (const label i : nodesOf(gas, "bottom", "back"))
    {
        EXPECT_LE(mag(U[i].y()) + mag(U[i].z()), 1e-12);
        EXPECT_GT(mag(U[i].x()), 1);
    }

    // Elsewhere nothing is held
    EXPECT_GT(mag(U[nodesOf(gas, "top", "front")[2]].y()), 1);
}


// The same on walls that are not aligned with the axes
TEST(Walls, holdTheNormalVelocityWhenTurned)
{
    const scalar c = std::cos(0.6), s = std::sin(0.6);
    gasSettings settings;
    settings.box = boxMesh::plane(6, 5);
    settings.box.map = [=](const point& x)
    {
        return point(c*x.x() - s*x.y(), s*x.x() + c*x.y(), x.z());
    };
    settings.start = gust;
    settings.boundary["bottom"] = settings.boundary["left"] = "wall";
    gasCase gas(settings);
    gas.run(5, 0.2*gas.gas().stable().deltaT);
    const vectorField U(gas.U());

    for (const label i : gas.gas().mesh().patch("bottom").nodes)
    {
        EXPECT_LE(mag(U[i] & vector(-s, c, 0)), 1e-12);
    }
    const label corner = nodesOf(gas, "bottom", "left")[0];
    EXPECT_LE(mag(U[corner]), 1e-12);
}


TEST(Walls, giveTheirOwnVelocityWhenTheyMove)
{
    gasSettings s;
    s.box = boxMesh::plane(6, 5);
    s.start = gust;
    s.boundary["right"] = "wall";
    gasCase gas(s);
    const scalar dt = 0.1*gas.gas().stable().deltaT;
    gas.run(4, dt,
        [](const point& x, scalar t) { return x + vector(25*x.x()*t, 0, 0); });
    const vectorField U(gas.U());
    for (const label i : gas.gas().mesh().patch("right").nodes)
    {
        EXPECT_NEAR(U[i].x(), 25, 1e-9);
    }

    // The wall has stopped
    gas.run(1, dt);
    const vectorField after(gas.U());
    for (const label i : gas.gas().mesh().patch("right").nodes)
    {
        EXPECT_LE(mag(after[i].x()), 1e-9);
    }
}


// Round the edge of a step the gas is free to turn: only the mean of the two
// walls' normals is held there
TEST(Walls, letTheGasTurnRoundAnEdge)
{
    gasSettings s;
    s.box = boxMesh::plane(6, 6);
    s.box.keep = [](label i, label j, label) { return i < 3 || j >= 3; };
    s.start = gust;
    s.boundary["cut"] = s.boundary["bottom"] = "wall";
    gasCase gas(s);
    gas.run(5, 0.2*gas.gas().stable().deltaT);
    const vectorField U(gas.U());

    const feMesh& mesh = gas.gas().mesh();
    label edges = 0;
    for (const label i : mesh.patch("cut").nodes)
    {
        const point& x = mesh.nodes()[i];
        const bool onTop = mag(x.y() - 0.5) < 1e-9;
        const bool onFront = mag(x.x() - 0.5) < 1e-9;
        if (onTop && onFront)
        {
            ++edges;
            EXPECT_LE(mag(U[i] & vector(1, -1, 0)), 1e-10);
            EXPECT_GT(mag(U[i] & vector(1, 1, 0)), 1);
        }
        else if (onTop)
        {
            EXPECT_LE(mag(U[i].y()), 1e-12);
        }
        else
        {
            EXPECT_LE(mag(U[i].x()), 1e-12);
        }
    }
    EXPECT_EQ(edges, 1);

    // The inner corner between the step's front and the floor holds both
    const label corner = nodesOf(gas, "cut", "bottom")[0];
    EXPECT_LE(mag(U[corner]), 1e-12);
}


// Forces on a wall for a pressure that is linear along it: resultant and moment
// are the exact ones
TEST(Walls, pressureForces)
{
    for (const boxMesh& box : {boxMesh::plane(4, 5), boxMesh::space(4, 5, 3)})
    {
        const scalar a = 2e4, b = 3e4;
        gasSettings s;
        s.box = box;
        s.box.distort(0.2);
        const scalar slope = box.size.z() < 0.5 ? 0 : b;
        s.start = [=](const point& x)
        {
            return testGas::state(
                1e5 + a*x.y() + slope*x.z(), vector::zero, 1.2);
        };
        gasCase gas(s);
        const fePatch& patch = gas.gas().mesh().patch("right");
        const vectorField forces(gas.gas().pressureForces(patch, 9e4));

        vector sum(Zero), moment(Zero);
        forAll(forces, i)
        {
            sum += forces[i];
            moment += gas.x()[patch.nodes[i]] ^ forces[i];
        }
        const scalar depth = box.size.z();
        const scalar force = (1e4 + a/2 + slope/2)*depth;
        EXPECT_LE(mag(sum - vector(force, 0, 0)), 1e-9*force);

        // int y (1e4 + a y + b z) dA about the z axis
        const scalar mz = -(1e4/2 + a/3 + slope/4)*depth;
        EXPECT_NEAR(moment.z(), mz, 1e-9*mag(mz));
        if (slope > 0)
        {
            const scalar my = 1e4/2 + a/4 + b/3;
            EXPECT_NEAR(moment.y(), my, 1e-9*my);
        }
    }
}
