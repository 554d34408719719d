// SPDX-License-Identifier: GPL-3.0-or-later

#include "CubicTriangle.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

Vec3 onSphere(double u, double v)
{
    const double a = 2*M_PI*u;
    const double b = M_PI*(v - 0.5);
    return {std::cos(b)*std::cos(a), std::cos(b)*std::sin(a), std::sin(b)};
}

StructuredLayout wholeSphere(int nU, int nV)
{
    StructuredLayout layout = StructuredLayout::even(nU, nV);
    layout.closedU = layout.poleVMin = layout.poleVMax = true;
    return layout;
}

//- Largest distance of the triangles from the unit sphere
double offSphere(const ShellMesh& mesh)
{
    double largest = 0;
    for (const Triangle& t : mesh.triangles())
    {
        for (int i = 0; i <= 12; ++i)
        {
            for (int j = 0; i + j <= 12; ++j)
            {
                const auto N = CubicTriangle::values(i/12., j/12.);
                Vec3 x = Vec3::Zero();
                for (int k = 0; k < nodesPerElement; ++k) x += N[k]*mesh.nodes()[t[k]];
                largest = std::max(largest, std::abs(x.norm() - 1));
            }
        }
    }
    return largest;
}

} // namespace

TEST(StructuredMesh, wholeSphere)
{
    const ShellMesh mesh = structuredMesh(wholeSphere(6, 4), onSphere, onSphere);

    // 6 triangles at each pole, 2 x 6 x 2 between
    EXPECT_EQ(mesh.nElements(), 6 + 24 + 6);
    // Euler: corners - edges + triangles = 2; two nodes per edge, one inside
    const int corners = 2 + 6*3;
    const int edges = corners + mesh.nElements() - 2;
    EXPECT_EQ(mesh.nNodes(), corners + 2*edges + mesh.nElements());
    EXPECT_EQ(mesh.edgesOf("all").size(), std::size_t(edges));

    EXPECT_EQ(mesh.nodeSet("vMin").size(), 1u);
    EXPECT_EQ(mesh.nodeSet("vMax"), mesh.nodeSet("uMinVMax"));
    EXPECT_EQ(mesh.nodeSet("uMin"), mesh.nodeSet("uMax"));
    EXPECT_EQ(mesh.nodeSet("uMin").size(), 13u);
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        EXPECT_LT((mesh.directors()[i] - mesh.nodes()[i]).norm(), 1e-15);
    }
}

TEST(StructuredMesh, trianglesAtThePoleConverge)
{
    const double coarse = offSphere(structuredMesh(wholeSphere(8, 4), onSphere));
    const double fine = offSphere(structuredMesh(wholeSphere(16, 8), onSphere));
    EXPECT_LT(fine, 1.5e-4);
    EXPECT_GT(std::log2(coarse/fine), 3.5);
}

TEST(StructuredMesh, gradedLines)
{
    StructuredLayout layout = StructuredLayout::even(1, 1);
    layout.u = {0, 0.1, 0.4, 1};
    const ShellMesh mesh = structuredMesh
    (
        layout, [](double u, double v) -> Vec3 { return {u, v, 0}; }
    );
    std::vector<double> x;
    for (int node : mesh.nodeSet("vMin")) x.push_back(mesh.nodes()[node][0]);
    const std::vector<double> expected{0, 0.1/3, 0.2/3, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1};
    ASSERT_EQ(x.size(), expected.size());
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-15);
}

TEST(StructuredMesh, layoutIsChecked)
{
    const auto error = [](const StructuredLayout& layout)
    {
        return errorOf([&] { structuredMesh(layout, onSphere); });
    };
    EXPECT_NE(error(wholeSphere(2, 4)).find("needs 3"), std::string::npos);
    EXPECT_NE(error(wholeSphere(3, 1)).find("from pole to pole"), std::string::npos);
    StructuredLayout falling = wholeSphere(3, 2);
    falling.v = {0, 1.1, 1};
    EXPECT_NE(error(falling).find("lines of v do not ascend"), std::string::npos);
}
