// SPDX-License-Identifier: GPL-3.0-or-later

#include "RaisedTriangles.hpp"
#include "CubicTriangle.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

//- Two quadratic triangles over the unit square, z = xy + x^2/2, nodes out of
//  order; node 4 is of no triangle
struct Saddle
{
    std::vector<Vec3> nodes;
    std::vector<std::vector<int>> triangles
    {
        {3, 0, 2, 9, 6, 8}, {5, 2, 0, 7, 6, 1}
    };

    static double height(double x, double y) { return x*y + x*x/2; }

    Saddle()
    {
        const double xy[10][2] =
        {
            {1, 0}, {1, 0.5}, {0, 1}, {0, 0}, {7, 7}, {1, 1}, {0.5, 0.5}, {0.5, 1},
            {0, 0.5}, {0.5, 0}
        };
        for (const auto& p : xy) nodes.push_back({p[0], p[1], height(p[0], p[1])});
    }
};

} // namespace

TEST(RaisedTriangles, quadraticSurfacesAreKeptExactly)
{
    const Saddle saddle;
    const CubicTriangles raised = raisedTriangles(2, saddle.nodes, saddle.triangles);

    EXPECT_EQ(raised.nodes.size(), 16u);
    const ShellMesh mesh(raised.nodes, raised.triangles);
    for (const Triangle& t : mesh.triangles())
    {
        for (double xi1 : {0.1, 0.35, 0.6})
        {
            const auto N = CubicTriangle::values(xi1, 0.3);
            Vec3 x = Vec3::Zero();
            for (int j = 0; j < nodesPerElement; ++j) x += N[j]*raised.nodes[t[j]];
            EXPECT_NEAR(x[2], Saddle::height(x[0], x[1]), 1e-15);
        }
    }
}

TEST(RaisedTriangles, nodesKnowWhatTheyWere)
{
    const Saddle saddle;
    const CubicTriangles raised = raisedTriangles(2, saddle.nodes, saddle.triangles);
    int kept = 0;
    for (std::size_t i = 0; i < raised.nodes.size(); ++i)
    {
        if (raised.source[i] < 0) continue;
        ++kept;
        EXPECT_EQ(raised.nodes[i], saddle.nodes[raised.source[i]]);
    }
    // The corners; mid-edge nodes are at no node of the cubic triangle
    EXPECT_EQ(kept, 4);
}

TEST(RaisedTriangles, order3IsLeftAsItIs)
{
    const ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    std::vector<std::vector<int>> triangles;
    for (const Triangle& t : mesh.triangles()) triangles.emplace_back(t.begin(), t.end());
    const CubicTriangles same = raisedTriangles(3, mesh.nodes(), triangles);
    ASSERT_EQ(same.nodes.size(), mesh.nodes().size());
    for (int e = 0; e < mesh.nElements(); ++e)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            EXPECT_EQ(same.source[same.triangles[e][j]], triangles[e][j]);
        }
    }
}

TEST(RaisedTriangles, sidesWithDifferentMiddleNodesAreNotShared)
{
    Saddle saddle;
    saddle.triangles[1][4] = static_cast<int>(saddle.nodes.size());
    saddle.nodes.push_back(saddle.nodes[6]);
    const CubicTriangles raised = raisedTriangles(2, saddle.nodes, saddle.triangles);
    const std::string error = errorOf([&] { ShellMesh(raised.nodes, raised.triangles); });
    EXPECT_NE(error.find("but not the two nodes between them"), std::string::npos) << error;
}

TEST(RaisedTriangles, orderIsChecked)
{
    EXPECT_NE(errorOf([] { raisedTriangles(4, {}, {}); }).find("order 4"), std::string::npos);
}

TEST(RaisedTriangles, sagittaOfAPolygon)
{
    // A strip of flat facets on a circle, 6 degrees each: (SM2) is R(1 - cos 3
    // degrees) to second order inside, and half of it where the strip ends
    const double step = 6*M_PI/180;
    std::vector<Vec3> nodes;
    std::vector<std::vector<int>> triangles;
    for (int i = 0; i <= 10; ++i)
    {
        nodes.push_back({std::sin(i*step), 0, std::cos(i*step)});
        nodes.push_back({std::sin(i*step), 0.1, std::cos(i*step)});
        if (i == 0) continue;
        triangles.push_back({2*i - 2, 2*i, 2*i + 1});
        triangles.push_back({2*i - 2, 2*i + 1, 2*i - 1});
    }
    const CubicTriangles raised = raisedTriangles(1, nodes, triangles);
    const GeometricError error = geometricError(1, raised, M_PI/6);
    EXPECT_NEAR(error.distance, 1 - std::cos(step/2), 2e-3*error.distance);
    EXPECT_GT(error.element, 1);
    EXPECT_LT(error.element, 18);
    EXPECT_NEAR(error.angle, step/2, 1e-12);

    // Folds of 6 degrees that are meant
    EXPECT_LT(geometricError(1, raised, 0.9*step).distance, 1e-15);
}
