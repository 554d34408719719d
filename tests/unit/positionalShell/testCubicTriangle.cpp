// SPDX-License-Identifier: GPL-3.0-or-later

#include "CubicTriangle.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace positionalShell;

namespace
{

const double points[][2] = {{0.2, 0.3}, {0.05, 0.9}, {1.0/3, 1.0/3}, {0.7, 0.01}};

} // namespace

TEST(CubicTriangle, functionsAreOneAtTheirNodeAndZeroAtTheOthers)
{
    const auto& nodes = CubicTriangle::nodePoints();
    for (int i = 0; i < nodesPerElement; ++i)
    {
        const auto N = CubicTriangle::values(nodes[i][0], nodes[i][1]);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            EXPECT_NEAR(N[j], i == j, 1e-15) << "function " << j << ", node " << i;
        }
    }
}

TEST(CubicTriangle, nodeOrderIsThatOfGmshAndVtk)
{
    const double expected[][2] =
    {
        {0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}
    };
    for (int i = 0; i < nodesPerElement; ++i)
    {
        EXPECT_NEAR(3*CubicTriangle::nodePoints()[i][0], expected[i][0], 1e-15) << i;
        EXPECT_NEAR(3*CubicTriangle::nodePoints()[i][1], expected[i][1], 1e-15) << i;
    }
}

TEST(CubicTriangle, partitionOfUnity)
{
    for (const auto& p : points)
    {
        EXPECT_NEAR(CubicTriangle::values(p[0], p[1]).sum(), 1, 1e-14);
        EXPECT_NEAR(CubicTriangle::gradients(p[0], p[1]).colwise().sum().norm(), 0, 1e-13);
        EXPECT_NEAR(CubicTriangle::secondDerivatives(p[0], p[1]).colwise().sum().norm(), 0, 1e-12);
    }
}

// Interpolating all cubics exactly, with both derivatives, fixes the basis
TEST(CubicTriangle, reproducesCubicPolynomials)
{
    const auto& nodes = CubicTriangle::nodePoints();
    for (int a = 0; a <= 3; ++a)
    {
        for (int b = 0; a + b <= 3; ++b)
        {
            const auto term = [](double x, int n, int derivative)
            {
                double factor = 1;
                for (int k = 0; k < derivative; ++k) factor *= n - k;
                return factor == 0 ? 0 : factor*std::pow(x, n - derivative);
            };
            Eigen::VectorXd nodal(nodesPerElement);
            for (int i = 0; i < nodesPerElement; ++i)
            {
                nodal[i] = term(nodes[i][0], a, 0)*term(nodes[i][1], b, 0);
            }
            for (const auto& p : points)
            {
                const double x = p[0];
                const double y = p[1];
                const auto dN = CubicTriangle::gradients(x, y);
                const auto ddN = CubicTriangle::secondDerivatives(x, y);
                EXPECT_NEAR
                (
                    CubicTriangle::values(x, y).dot(nodal), term(x, a, 0)*term(y, b, 0), 1e-14
                );
                EXPECT_NEAR(dN.col(0).dot(nodal), term(x, a, 1)*term(y, b, 0), 1e-13);
                EXPECT_NEAR(dN.col(1).dot(nodal), term(x, a, 0)*term(y, b, 1), 1e-13);
                EXPECT_NEAR(ddN.col(0).dot(nodal), term(x, a, 2)*term(y, b, 0), 1e-12);
                EXPECT_NEAR(ddN.col(1).dot(nodal), term(x, a, 0)*term(y, b, 2), 1e-12);
                EXPECT_NEAR(ddN.col(2).dot(nodal), term(x, a, 1)*term(y, b, 1), 1e-12);
            }
        }
    }
}

TEST(CubicTriangle, edgeFunctionsAreTheTraceOfTheTriangle)
{
    for (const auto& places : CubicTriangle::edgeNodes())
    {
        const Eigen::Vector2d from = CubicTriangle::nodePoints()[places[0]];
        const Eigen::Vector2d along = CubicTriangle::nodePoints()[places[3]] - from;
        for (double s : {0.0, 0.13, 0.5, 0.91})
        {
            const Eigen::Vector2d xi = from + s*along;
            const auto N = CubicTriangle::values(xi[0], xi[1]);
            const Eigen::VectorXd dN = CubicTriangle::gradients(xi[0], xi[1])*along;
            for (int i = 0; i < 4; ++i)
            {
                EXPECT_NEAR(CubicTriangle::edgeValues(s)[i], N[places[i]], 1e-14);
                EXPECT_NEAR(CubicTriangle::edgeDerivatives(s)[i], dN[places[i]], 1e-13);
            }
        }
    }
}
