/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Each kind of boundary does what its name says, alone and where two meet

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Gas that flows everywhere, with a wave in it
primitive gust(const point& x)
{
    return testGas::state
    (
        1e5*(1 + 0.3*std::sin(7*x.x() + 5*x.y() + 3*x.z())),
        vector(60, -40, 30), 1.2
    );
}

//- The node at a place
label nodeAt(gasCase& gas, const point& x)
{
    forAll(gas.x(), i)
    {
        if (mag(gas.x()[i] - x) < 1e-9)
        {
            return i;
        }
    }
    ADD_FAILURE() << "no node";
    return 0;
}

std::string text(const scalar v)
{
    std::ostringstream os;
    os << std::setprecision(17) << v;
    return os.str();
}

} // End namespace


namespace
{

//- Largest difference of pressure, over it, between a mirrored scene and its
//  half with a patch of some type in the middle
scalar differenceOfHalf(const bool plane, const word& type)
{
    gasSettings whole, half;
    whole.box = plane ? boxMesh::plane(32, 16) : boxMesh::lines(32);
    half.box = plane ? boxMesh::plane(16, 16) : boxMesh::lines(16);
    whole.start = half.start = [plane](const point& x)
    {
        // Lines have points at several y, of which a patch takes its first
        const scalar y = plane ? x.y() : 0;
        const scalar r2 = sqr(x.x()/0.3) + sqr((y - 0.4)/0.3);
        return testGas::state
        (
            1e5*(1 + std::exp(-r2)), vector(90*x.x(), 20*x.y(), 0), 1.2
        );
    };
    whole.box.map = [](const point& x)
    {
        return point(2*x.x() - 1, x.y(), x.z());
    };
    half.box.types[0] = type;
    for (gasSettings* s : {&whole, &half})
    {
        s->schemes = "timeScheme twoStep;";
        s->boundary["top"] = s->boundary["bottom"] = "wall";
        s->boundary["right"] = "farField";
    }
    whole.boundary["left"] = "farField";
    gasCase one(whole), other(half);
    const scalar dt = 0.5*one.gas().stable().deltaT;
    one.run(30, dt);
    other.run(30, dt);

    const scalarField p(one.scalars("p")), q(other.scalars("p"));
    scalar difference = 0;
    forAll(q, i)
    {
        const scalar there = p[nodeAt(one, other.x()[i])];
        difference = max(difference, mag(q[i]/there - 1));
    }
    if (type != "patch")
    {
        const vectorField U(other.U());
        for (const label i : other.gas().mesh().patch("left").nodes)
        {
            EXPECT_LE(mag(U[i].x()), 1e-12);
        }
    }
    return difference;
}

} // End namespace


// Half of a mirrored scene is the whole one: on lines up to rounding, on
// triangles up to the weights of the edges along the plane
TEST(BoundaryKinds, symmetryIsTheOtherHalf)
{
    for (const word type : {"symmetryPlane", "symmetry"})
    {
        EXPECT_LE(differenceOfHalf(false, type), 1e-12) << type;

        // The diagonals of the two meshes differ
        EXPECT_LE(differenceOfHalf(true, type), 8e-3) << type;
    }
    EXPECT_GT(differenceOfHalf(false, "patch"), 0.02);
    EXPECT_GT(differenceOfHalf(true, "patch"), 0.02);
}


// What leaves through one of a cyclic pair comes in through the other: the
// start does not matter
TEST(BoundaryKinds, cyclicsHaveNoPlace)
{
    auto startAt = [](const scalar shift)
    {
        return [=](const point& x)
        {
            const scalar s = std::sin
            (
                2*constant::mathematical::pi*(x.x() - shift)
            );
            return testGas::state
            (
                1e5*(1 + 0.2*s + 0.1*x.y()), vector(150 + 40*s, 10, 0), 1.2
            );
        };
    };
    const scalar shift = 0.25;
    gasSettings here, there;
    for (gasSettings* s : {&here, &there})
    {
        s->box = boxMesh::plane(16, 4);
        s->box.types[0] = s->box.types[1] = "cyclic";
        s->boundary["top"] = s->boundary["bottom"] = "wall";
        s->schemes = "timeScheme twoStep;";
    }
    here.start = startAt(0);
    there.start = startAt(shift);
    gasCase one(here), other(there);
    const scalar dt = 0.5*one.gas().stable().deltaT;
    one.run(40, dt);
    other.run(40, dt);
    const scalarField p(one.scalars("p")), q(other.scalars("p"));
    forAll(p, i)
    {
        point x(one.x()[i]);
        x.x() += shift - (x.x() + shift > 1 - 1e-9 ? 1 : 0);
        EXPECT_NEAR(q[nodeAt(other, x)]/p[i], 1, 1e-11);
    }
}


namespace
{

//- Highest pressure that a weak wave makes at the right end, over the wave's
scalar atTheEnd(const word& kind)
{
    gasSettings s;
    s.box = boxMesh::lines(100);
    s.boundary["right"] = kind;
    s.start = [](const point& x)
    {
        const scalar bump = 1e-3*std::exp(-sqr((x.x() - 0.6)/0.06));
        return testGas::state
        (
            1e5*(1 + bump), vector(std::sqrt(1.4e5/1.2)*bump/1.4, 0, 0),
            1.2*(1 + bump/1.4)
        );
    };
    if (kind == "fixedValue")
    {
        s.entries["right/p"] = "fixedValue; value uniform 1e5;";
        s.boundary["right"] = "open";
    }
    gasCase gas(s);
    const label end = gas.gas().mesh().patch("right").nodes[0];
    scalar highest = 0;
    for (label i = 0; i < 150; ++i)
    {
        gas.run(1, 0.5*gas.gas().stable().deltaT);
        highest = max(highest, gas.scalars("p")[end] - 1e5);
    }
    return highest/100;
}

} // End namespace


// The wave goes by, is sent back or is cancelled
TEST(BoundaryKinds, whatAWaveSees)
{
    EXPECT_NEAR(atTheEnd("open"), 1, 0.05);
    EXPECT_NEAR(atTheEnd("farField"), 1, 0.05);
    EXPECT_NEAR(atTheEnd("wall"), 2, 0.1);
    EXPECT_LE(atTheEnd("fixedValue"), 1e-9);
}


namespace
{

//- A tube whose left end has tables in time, from p, T, U to these
gasSettings tableInlet(const std::string& kind, const scalar end)
{
    gasSettings s;
    s.box = boxMesh::lines(20);
    s.start = [](const point&)
    {
        return testGas::state(1e5, vector(50, 0, 0), 1.2);
    };
    const scalar T = testGas::T(1e5, 1.2);
    auto table = [&](const std::string& from, const std::string& to)
    {
        return kind + "; uniformValue table ((0 " + from + ") (" + text(end)
          + " " + to + "));";
    };
    s.entries["left/p"] = table("1e5", "1.2e5");
    s.entries["left/T"] = table(text(T), text(1.1*T));
    s.entries["left/U"] = table("(50 0 0)", "(80 0 0)");
    return s;
}

} // End namespace


// Tables are read at the gas's own time: here the run's clock stays
TEST(BoundaryKinds, fixedValuesFollowTables)
{
    const scalar end = 1e-3, T = testGas::T(1e5, 1.2);
    gasCase gas(tableInlet("uniformFixedValue", end));
    const label node = gas.gas().mesh().patch("left").nodes[0];
    for (label i = 1; i <= 50; ++i)
    {
        gas.run(1, 0.01*end);
        const scalar part = 0.01*i;
        EXPECT_NEAR(gas.scalars("p")[node]/1e5, 1 + 0.2*part, 1e-12);
        EXPECT_NEAR(gas.scalars("T")[node]/T, 1 + 0.1*part, 1e-12);
        EXPECT_NEAR(gas.U()[node].x(), 50 + 30*part, 1e-9);
    }
    EXPECT_EQ(gas.clock().value(), 0);
}


// The outer state meets the gas of the start
TEST(BoundaryKinds, farFieldFollowsTables)
{
    const scalar end = 1e-3;
    gasCase gas(tableInlet("farField", end));
    const label node = gas.gas().mesh().patch("left").nodes[0];
    gas.run(50, 0.01*end);

    // Half of the outer p + rho c u goes in; the gas's own p - rho c u is still
    // that of the start
    const scalar impedance = 1.2*std::sqrt(1.4e5/1.2);
    const scalar rise = 0.5*(1e4 + impedance*15);
    EXPECT_NEAR(gas.scalars("p")[node] - 1e5, rise, 0.06*rise);
    EXPECT_NEAR(gas.U()[node].x() - 50, rise/impedance, 0.06*rise/impedance);
    EXPECT_EQ(gas.clock().value(), 0);
}


// Where boundaries meet every one holds
TEST(BoundaryKinds, edgesAndCornersKeepAll)
{
    gasSettings s;
    s.box = boxMesh::space(4, 4, 4);
    s.box.types[4] = "symmetryPlane";
    s.start = gust;
    s.boundary["bottom"] = "wall";
    s.boundary["left"] = "fixedValue";
    s.boundary["right"] = "wall";
    s.boundary["front"] = "farField";
    s.schemes = "timeScheme twoStep;";
    gasCase gas(s);
    gas.run(6, 0.3*gas.gas().stable().deltaT);
    const scalarField p(gas.scalars("p"));
    const vectorField U(gas.U());
    const scalar h = 0.25;

    // Three walls; two walls and what is along them
    const label corner = nodeAt(gas, point(1, 0, 0));
    EXPECT_LE(mag(U[corner]), 1e-11);
    const label edge = nodeAt(gas, point(1, 0, h));
    EXPECT_LE(mag(U[edge].x()) + mag(U[edge].y()), 1e-11);
    EXPECT_GT(mag(U[edge].z()), 1);

    // Walls keep their normal velocity next to prescribed values, which hold
    // along them
    const label inlet = nodeAt(gas, point(0, 0, 0));
    EXPECT_LE(mag(U[inlet] - vector(60, 0, 0)), 1e-10);
    const label inletEdge = nodeAt(gas, point(0, 0, h));
    EXPECT_LE(mag(U[inletEdge] - vector(60, 0, 30)), 1e-10);
    const label inside = nodeAt(gas, point(0, h, h));
    EXPECT_LE(mag(U[inside] - vector(60, -40, 30)), 1e-10);
    EXPECT_NEAR(p[inside]/gust(point(0, h, h)).p, 1, 1e-13);

    // A wall that ends at a far field
    const label outer = nodeAt(gas, point(h, 0, 1));
    EXPECT_LE(mag(U[outer].y()), 1e-11);
    EXPECT_GT(mag(U[outer].x()), 1);
}


// A corner between a wall that moves and one that stays
TEST(BoundaryKinds, movingAndFixedWallsMeet)
{
    gasSettings s;
    s.box = boxMesh::plane(6, 5);
    s.start = gust;
    s.boundary["right"] = s.boundary["bottom"] = "wall";
    gasCase gas(s);
    gas.run(4, 0.1*gas.gas().stable().deltaT,
        [](const point& x, scalar t) { return x + vector(25*x.x()*t, 0, 0); });
    const label right = gas.gas().mesh().patch("right").nodes[0];
    const scalar end = gas.x()[right].x();
    EXPECT_LE
    (
        mag(gas.U()[nodeAt(gas, point(end, 0, 0))] - vector(25, 0, 0)), 1e-9
    );
}
