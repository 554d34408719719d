/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The map between gas nodes and shell: what its transpose must keep, and what
// it must refuse

#include "Constraints.hpp"
#include "StructuredMesh.hpp"
#include "interfaceMap.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

const scalar thickness = 0.02;

//- A quarter cylinder of radius 1 and length 0.7
positionalShell::ShellMesh curvedMesh()
{
    auto place = [](double u, double v)
    {
        const double angle = 0.5*M_PI*u;
        return positionalShell::Vec3(std::cos(angle), std::sin(angle), 0.7*v);
    };
    auto normal = [](double u, double)
    {
        const double angle = 0.5*M_PI*u;
        return positionalShell::Vec3(std::cos(angle), std::sin(angle), 0);
    };
    return positionalShell::structuredMesh(3, 2, place, normal);
}

positionalShell::ShellModel curvedShell()
{
    using namespace positionalShell;
    ShellMesh mesh = curvedMesh();
    DofMap dofs = Constraints(mesh).clamped("uMin").dofMap();
    Section section;
    section.thickness = thickness;
    section.material = Material::create
    (
        "SaintVenantKirchhoff",
        {{"youngsModulus", 1e9}, {"poissonRatio", 0.3}, {"density", 1000}}
    );
    return ShellModel(std::move(mesh), {section}, std::move(dofs));
}

//- Points on both faces and the far rim of the shell
pointField surfacePoints()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.02, 0.98);
    DynamicList<point> points;
    for (int i = 0; i < 60; ++i)
    {
        const double angle = 0.5*M_PI*uniform(random);
        const double r = 1 + (i % 2 ? 0.5 : -0.5)*thickness;
        points.append
        (
            point(r*std::cos(angle), r*std::sin(angle), 0.7*uniform(random))
        );
    }
    return pointField(points);
}

positionalShell::Vector randomVector(int size, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    positionalShell::Vector v(size);
    for (int i = 0; i < size; ++i)
    {
        v[i] = normal(random);
    }
    return v;
}

vectorField randomField(label size, unsigned seed)
{
    const positionalShell::Vector v = randomVector(3*size, seed);
    vectorField f(size);
    forAll(f, i)
    {
        f[i] = vector(v[3*i], v[3*i + 1], v[3*i + 2]);
    }
    return f;
}

} // End namespace


TEST(InterfaceMap, transposeKeepsForceMomentAndWork)
{
    const auto model = curvedShell();
    const pointField points(surfacePoints());

    // The cubic elements follow the circle to about 1e-4 of the thickness
    const interfaceMap map(model, points, 0.01);

    const vectorField forces(randomField(points.size(), 11));
    const positionalShell::Vector Q = map.generalisedForce(forces);
    const scalar size = sum(mag(forces));

    EXPECT_LE(mag(interfaceMap::resultant(Q) - sum(forces)), 1e-12*size);

    // Moment and work in a state far from the initial one
    const positionalShell::Vector q0 = model.initialState().position;
    const positionalShell::Vector q =
        q0 + 0.3*randomVector(q0.size(), 12);
    const vectorField displaced(map.displacement(q));
    const vectorField initial(points.size(), Zero);
    const positionalShell::Vector dq = q - q0;

    EXPECT_LE
    (
        mag(sum(forces & displaced) - Q.dot(dq)),
        1e-12*size*max(mag(displaced))
    );

    // Places of the nodes in state q = initial place on the shell + motion
    const vectorField places(displaced + points);
    EXPECT_LE
    (
        mag(sum(places ^ forces) - interfaceMap::moment(Q, q)),
        2*map.worstOffset()*size + 1e-12*size*max(mag(places))
    );
}


TEST(InterfaceMap, rigidMotionIsReproduced)
{
    const auto model = curvedShell();
    const pointField points(surfacePoints());
    const interfaceMap map(model, points, 0.01);

    // Rotation about z by 0.7 and a translation, on positions and directors
    const double c = std::cos(0.7), s = std::sin(0.7);
    auto turn = [&](double x, double y)
    {
        return vector(c*x - s*y, s*x + c*y, 0);
    };
    const vector shift(0.3, -0.2, 0.5);

    positionalShell::Vector q = model.initialState().position;
    for (int i = 0; i < q.size(); i += positionalShell::dofsPerNode)
    {
        const vector x = turn(q[i], q[i + 1]);
        const vector g = turn(q[i + 3], q[i + 4]);
        q[i] = x.x() + shift.x();
        q[i + 1] = x.y() + shift.y();
        q[i + 2] += shift.z();
        q[i + 3] = g.x();
        q[i + 4] = g.y();
    }

    const vectorField moved(map.displacement(q));
    forAll(points, i)
    {
        const vector expected =
            turn(points[i].x(), points[i].y())
          + vector(0, 0, points[i].z()) + shift - points[i];
        EXPECT_LE(mag(moved[i] - expected), 2*map.worstOffset() + 1e-12);
    }
}


TEST(InterfaceMap, nodeOffTheShellIsRefusedWithItsPlace)
{
    FatalError.throwExceptions();
    const auto model = curvedShell();
    const pointField points(1, point(1.5, 0.1, 0.3));

    try
    {
        interfaceMap map(model, points, 0.01);
        FAIL() << "a node half a metre off the shell was accepted";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("(1.5 0.1 0.3)"), std::string::npos);
        EXPECT_NE(e.message().find("mapTolerance"), std::string::npos);
    }
}
