// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

//- Nodes and triangles of a unit square of one quadrilateral, to be spoilt
struct Square
{
    std::vector<Vec3> nodes;
    std::vector<Triangle> triangles;

    Square()
    {
        const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
        nodes = mesh.nodes();
        triangles = mesh.triangles();
    }

    std::string error() const
    {
        return errorOf([this] { ShellMesh(nodes, triangles); });
    }
};

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(ShellMesh, structuredMeshHasItsNodesOnTheSurface)
{
    const ShellMesh mesh = structuredMesh
    (
        3, 2, [](double u, double v) -> Vec3 { return {std::cos(u), std::sin(u), v}; }
    );
    EXPECT_EQ(mesh.nNodes(), 10*7);
    EXPECT_EQ(mesh.nElements(), 12);
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const Vec3& x = mesh.nodes()[i];
        EXPECT_NEAR(x.head<2>().norm(), 1, 1e-15);
        // du x dv points outwards; averaged normals of a cubic surface are close
        const Vec3 radial(x[0], x[1], 0);
        EXPECT_LT((mesh.directors()[i] - radial).norm(), 2e-3) << i;
        EXPECT_NEAR(mesh.directors()[i].norm(), 1, 1e-15);
    }
    EXPECT_EQ(mesh.nodeSet("uMin").size(), 7u);
    EXPECT_EQ(mesh.nodeSet("vMax").size(), 10u);
    EXPECT_EQ(mesh.nodeSet("all").size(), 70u);
    EXPECT_EQ(mesh.elementSet("all").size(), 12u);
    EXPECT_NEAR(mesh.nodes()[mesh.nodeSet("uMaxVMax")[0]][2], 1, 1e-15);
}

TEST(ShellMesh, givenDirectorsAreKeptAtUnitLength)
{
    const Square square;
    const std::vector<Vec3> directors(square.nodes.size(), Vec3(0, 0, 3));
    const ShellMesh mesh(square.nodes, square.triangles, {}, {}, directors);
    EXPECT_LT((mesh.directors()[5] - Vec3(0, 0, 1)).norm(), 1e-15);
}

TEST(ShellMesh, edgesOfASet)
{
    const ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    EXPECT_EQ(mesh.edgesOf("uMax").size(), 1u);
    EXPECT_EQ(mesh.edgesOf("vMin").size(), 2u);
    // 4 triangles have 12 edges; 3 inner ones are shared
    EXPECT_EQ(mesh.edgesOf("all").size(), 9u);
    EXPECT_EQ(mesh.edgesOf("uMaxVMax").size(), 0u);
}

TEST(ShellMesh, setsAreCheckedAndFound)
{
    const Square square;
    ShellMesh mesh(square.nodes, square.triangles, {{"root", {3, 1, 3}}}, {{"front", {1}}});
    EXPECT_EQ(mesh.nodeSet("root"), (std::vector<int>{1, 3}));
    EXPECT_EQ(mesh.elementSet("front"), (std::vector<int>{1}));
    EXPECT_FALSE(mesh.hasNodeSet("front"));
    EXPECT_EQ
    (
        errorOf([&] { mesh.nodeSet("rot"); }), "shell mesh: no node set rot; there are: all root"
    );
    EXPECT_TRUE(holds(errorOf([&] { mesh.elementSet("x"); }), "no element set x"));
    EXPECT_TRUE(holds(errorOf([&] { mesh.addNodeSet("s", {16}); }), "node set s holds 16"));
    EXPECT_TRUE(holds(errorOf([&] { mesh.addElementSet("s", {-1}); }), "set s holds -1"));
}

TEST(ShellMesh, indicesAreChecked)
{
    Square outOfRange;
    outOfRange.triangles[1][4] = 99;
    EXPECT_TRUE(holds(outOfRange.error(), "element 1 has node 99, but there are 16 nodes"));

    Square twice;
    twice.triangles[0][4] = twice.triangles[0][3];
    EXPECT_TRUE(holds(twice.error(), "element 0 has node")) << twice.error();
    EXPECT_TRUE(holds(twice.error(), "twice"));

    Square unused;
    unused.nodes.push_back({5, 6, 7});
    EXPECT_TRUE(holds(unused.error(), "node 16 at (5 6 7) belongs to no triangle"));

    EXPECT_TRUE(holds(errorOf([] { ShellMesh({}, {}); }), "no triangles"));
}

TEST(ShellMesh, shapesAreChecked)
{
    Square folded;
    folded.nodes[folded.triangles[0][9]] += Vec3(0.9, 0.9, 0);
    EXPECT_TRUE(holds(folded.error(), "element 0 at")) << folded.error();
    EXPECT_TRUE(holds(folded.error(), "folded over"));

    // Reversed corners without the matching edge nodes
    Square turned;
    std::swap(turned.triangles[0][1], turned.triangles[0][2]);
    EXPECT_TRUE(holds(turned.error(), "folded over"));

    Square flat;
    for (Vec3& x : flat.nodes) x[1] = 0;
    EXPECT_TRUE(holds(flat.error(), "has no area"));
}

TEST(ShellMesh, neighboursAreChecked)
{
    Square against;
    const Triangle t = against.triangles[1];
    against.triangles[1] = {t[0], t[2], t[1], t[8], t[7], t[6], t[5], t[4], t[3], t[9]};
    EXPECT_TRUE(holds(against.error(), "element 0 and element 1 are oriented against each other"));

    Square torn;
    const int shared = torn.triangles[0][5];
    for (int& node : torn.triangles[1])
    {
        if (node == shared) node = int(torn.nodes.size());
    }
    torn.nodes.push_back(torn.nodes[shared]);
    EXPECT_TRUE(holds(torn.error(), "but not the two nodes between them")) << torn.error();

    Square branched;
    Triangle third = branched.triangles[1];
    for (int& node : third)
    {
        const double beyond = branched.nodes[node].head<2>().sum() - 1;
        if (beyond < 1e-9) continue;
        const Vec3 lifted = branched.nodes[node] + Vec3(0, 0, beyond);
        node = int(branched.nodes.size());
        branched.nodes.push_back(lifted);
    }
    branched.triangles.push_back(third);
    EXPECT_TRUE(holds(branched.error(), "branching shells are not supported"));
}

TEST(ShellMesh, directorsAreChecked)
{
    const Square square;
    std::vector<Vec3> directors(square.nodes.size(), Vec3(0, 0, 1));
    const auto error = [&]
    {
        return errorOf([&] { ShellMesh(square.nodes, square.triangles, {}, {}, directors); });
    };
    directors[3] = Vec3(0, 0, -1);
    EXPECT_TRUE(holds(error(), "the director of node 3 at (1 0 0) does not point"));
    directors.pop_back();
    EXPECT_TRUE(holds(error(), "15 directors for 16 nodes"));
}

TEST(ShellMesh, initialPositionsHoldNodesDirectorsAndNoThicknessStrain)
{
    const ShellMesh mesh = curvedPatch();
    const Vector q = mesh.initialPositions();
    ASSERT_EQ(q.size(), 7*mesh.nNodes());
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        EXPECT_EQ((q.segment<3>(fullIndex(i, Component::x)) - mesh.nodes()[i]).norm(), 0);
        EXPECT_EQ((q.segment<3>(fullIndex(i, Component::gx)) - mesh.directors()[i]).norm(), 0);
        EXPECT_EQ(q[fullIndex(i, Component::a)], 0);
    }
    EXPECT_EQ(mesh.nearestNode(mesh.nodes()[11] + Vec3(1e-3, 0, 0)), 11);
}
