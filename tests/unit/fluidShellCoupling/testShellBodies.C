/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Which shell a gas node belongs to: baffles, several shells, rims, part of a
// shell, and the order of the nodes

#include "Constraints.hpp"
#include "StructuredMesh.hpp"
#include "interfaceMap.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace Foam;
using positionalShell::Vec3;

namespace
{

//- Square plates of side 1 parallel to the plane z = 0
struct plate
{
    const char* name;
    double z;
    double thickness;
};

positionalShell::ShellModel plates(const std::vector<plate>& all)
{
    using namespace positionalShell;
    std::vector<Vec3> nodes;
    std::vector<Triangle> triangles;
    NamedSets sets;
    std::vector<Section> sections;
    for (const plate& p : all)
    {
        const ShellMesh one = structuredMesh
        (
            3, 2, [&](double u, double v) { return Vec3(u, v, p.z); }
        );
        const int firstNode = int(nodes.size());
        nodes.insert(nodes.end(), one.nodes().begin(), one.nodes().end());
        for (Triangle t : one.triangles())
        {
            for (int& node : t)
            {
                node += firstNode;
            }
            sets[p.name].push_back(int(triangles.size()));
            triangles.push_back(t);
        }
        Section section;
        section.elementSet = p.name;
        section.thickness = p.thickness;
        section.material = Material::create
        (
            "SaintVenantKirchhoff",
            {{"youngsModulus", 1e9}, {"poissonRatio", 0.3}, {"density", 1000}}
        );
        sections.push_back(section);
    }
    ShellMesh mesh(nodes, triangles, {}, sets);
    DofMap dofs = Constraints(mesh).dofMap();
    return ShellModel(std::move(mesh), sections, std::move(dofs));
}

//- Points of the unit square at the height z
pointField square(const scalar z, const label n = 7)
{
    DynamicList<point> points;
    for (label i = 0; i <= n; ++i)
    {
        for (label j = 0; j <= n; ++j)
        {
            points.append(point(scalar(i)/n, scalar(j)/n, z));
        }
    }
    return pointField(points);
}

//- Messages of the error that a map with these nodes raises
std::string refusal
(
    const positionalShell::ShellModel& model,
    const pointField& nodes
)
{
    FatalError.throwExceptions();
    try
    {
        interfaceMap map(model, nodes, 0.01);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}

} // End namespace


TEST(ShellBodies, splitPointsOfABaffleSitOnTheMidSurface)
{
    const auto model = plates({{"baffle", 0, 0.01}});
    pointField nodes(square(0));
    const label n = nodes.size();
    nodes.append(square(0));
    const interfaceMap map(model, nodes, 0.01);
    EXPECT_LE(map.worstOffset(), 1e-15);
    EXPECT_LE(map.largestXi3(), 1e-12);

    // Pressures of both sides subtract: 3 Pa above, 1 Pa below
    vectorField forces(2*n, vector(0, 0, -3.0/n));
    SubList<vector>(forces, n, n) = vector(0, 0, 1.0/n);
    const auto Q = map.generalisedForce(forces);
    EXPECT_LE(mag(interfaceMap::resultant(Q) - vector(0, 0, -2)), 1e-14);

    // Both sides stay together, whatever the shell does
    positionalShell::Vector q = model.initialState().position;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < q.size(); ++i)
    {
        q[i] += 0.1*normal(random);
    }
    const vectorField moved(map.displacement(q));
    for (label i = 0; i < n; ++i)
    {
        EXPECT_EQ(moved[i], moved[n + i]);
    }
}


TEST(ShellBodies, facesTipsAndEdgesOfAPanelWithThickness)
{
    const scalar h = 0.04;
    const auto model = plates({{"panel", 0, h}});
    pointField nodes(square(0.5*h));
    const label n = nodes.size();
    nodes.append(square(-0.5*h));
    for (const scalar z : {-0.5*h, -0.25*h, 0.0, 0.25*h, 0.5*h})
    {
        nodes.append(point(1, 0.5, z));
    }
    const interfaceMap map(model, nodes, 0.01);
    EXPECT_LE(map.worstOffset(), 1e-14);
    for (label i = 0; i < n; ++i)
    {
        EXPECT_NEAR(map.shellPoint(i).xi3, 1, 1e-12);
        EXPECT_NEAR(map.shellPoint(n + i).xi3, -1, 1e-12);
    }

    // Through the tip from back to front; its ends are edges of both faces
    for (label k = 0; k < 5; ++k)
    {
        EXPECT_NEAR(map.shellPoint(2*n + k).xi3, -1 + 0.5*k, 1e-12);
    }
}


TEST(ShellBodies, eachNodeBelongsToItsOwnShell)
{
    // The face of the thick plate, at z = 0.1, is nearer to the mid-surface of
    // the thin one (0.031 away) than to its own (0.1 away)
    const auto model = plates({{"thick", 0, 0.2}, {"thin", 0.131, 0.002}});
    pointField nodes(square(0.1));
    const label n = nodes.size();
    nodes.append(square(0.130));
    nodes.append(square(0.132));
    nodes.append(square(-0.1));

    const interfaceMap map(model, nodes, 0.01);
    EXPECT_LE(map.worstOffset(), 1e-13);
    const scalar xi3[] = {1, -1, 1, -1};
    const char* owner[] = {"thick", "thin", "thin", "thick"};
    forAll(nodes, i)
    {
        const auto& p = map.shellPoint(i);
        EXPECT_NEAR(p.xi3, xi3[i/n], 1e-10);
        EXPECT_EQ(model.section(p.element).elementSet, owner[i/n]);
    }

    // A force on one leaves the other alone
    vectorField forces(nodes.size(), Zero);
    SubList<vector>(forces, n, 0) = vector(0, 0, 1);
    const auto Q = map.generalisedForce(forces);
    EXPECT_LE(mag(interfaceMap::resultant(Q) - vector(0, 0, n)), 1e-11);
    const auto& thin = model.mesh().elementSet("thin");
    for (const int e : thin)
    {
        for (const int node : model.mesh().triangle(e))
        {
            EXPECT_EQ(Q.segment<7>(7*node).norm(), 0);
        }
    }
}


TEST(ShellBodies, aShellMayBeWettedInPart)
{
    const auto model = plates({{"panel", 0, 0.02}});
    pointField nodes(square(0.01));
    for (point& p : nodes)
    {
        p.x() *= 0.3;
    }
    const interfaceMap map(model, nodes, 0.01);
    const auto Q = map.generalisedForce
    (
        vectorField(nodes.size(), vector(0, 0, 1))
    );
    // Elements from x = 1/3 on get nothing
    const auto& mesh = model.mesh();
    for (int node = 0; node < mesh.nNodes(); ++node)
    {
        if (mesh.nodes()[node].x() > 0.34)
        {
            EXPECT_EQ(Q.segment<7>(7*node).norm(), 0);
        }
    }
    EXPECT_NEAR(interfaceMap::resultant(Q).z(), nodes.size(), 1e-11);
}


// As after decomposition: the same nodes in another order, and only some
TEST(ShellBodies, theMapDoesNotDependOnTheOrderOfTheNodes)
{
    const auto model = plates({{"thick", 0, 0.2}, {"thin", 0.131, 0.002}});
    pointField nodes(square(0.1, 12));
    nodes.append(square(0.130, 12));
    const interfaceMap map(model, nodes, 0.01);

    labelList order(identity(nodes.size()));
    std::shuffle(order.begin(), order.end(), std::mt19937(5));
    order.setSize(nodes.size()/2);
    const interfaceMap part(model, pointField(nodes, order), 0.01);
    forAll(order, i)
    {
        const auto& one = map.shellPoint(order[i]);
        const auto& other = part.shellPoint(i);
        EXPECT_EQ(one.element, other.element);
        EXPECT_EQ(one.xi1, other.xi1);
        EXPECT_EQ(one.xi2, other.xi2);
        EXPECT_EQ(one.xi3, other.xi3);
    }
}


TEST(ShellBodies, theErrorNamesTheWorstNodeAndItsShell)
{
    const auto model = plates({{"front", 0, 0.02}, {"rear", 1, 0.02}});
    pointField nodes(square(0.01));
    nodes[3].z() = 0.013;
    nodes[5] = point(0.25, 0.75, 1.07);
    const std::string said = refusal(model, nodes);
    for
    (
        const char* word :
        {
            "2 of 64 interface nodes", "(0.25 0.75 1.07)", "rear", "xi3 = 7",
            "thickness there is 0.02", "mapTolerance allows 0.01"
        }
    )
    {
        EXPECT_NE(said.find(word), std::string::npos) << word << said;
    }
}


TEST(ShellBodies, nodesBeyondTheRimAreRefused)
{
    const auto model = plates({{"panel", 0, 0.02}});
    EXPECT_EQ(refusal(model, pointField(1, point(1.0001, 0.5, 0.01))), "");
    EXPECT_NE(refusal(model, pointField(1, point(1.01, 0.5, 0.01))), "");
}
