// SPDX-License-Identifier: GPL-3.0-or-later

#include "StrainFit.hpp"
#include "CubicTriangle.hpp"

#include <Eigen/LU>

namespace positionalShell
{

namespace
{

constexpr int nQuadratic = 6;

using Quadratic = Eigen::Matrix<double, 1, nQuadratic>;

//- About the centroid, which keeps the normal equations well conditioned
Quadratic quadratics(double xi1, double xi2)
{
    const double x = xi1 - 1.0/3;
    const double y = xi2 - 1.0/3;
    Quadratic values;
    values << 1, x, y, x*x, x*y, y*y;
    return values;
}

} // namespace

StrainFit strainFit(const std::vector<TrianglePoint>& rule)
{
    using Square = Eigen::Matrix<double, nQuadratic, nQuadratic>;

    Eigen::Matrix<double, nQuadratic, Eigen::Dynamic> weighted
    (
        nQuadratic, rule.size()
    );
    Square normal = Square::Zero();
    for (std::size_t p = 0; p < rule.size(); ++p)
    {
        const Quadratic values = quadratics(rule[p].xi1, rule[p].xi2);
        weighted.col(p) = rule[p].weight*values.transpose();
        normal += weighted.col(p)*values;
    }

    Eigen::Matrix<double, nodesPerElement, nQuadratic> atNodes;
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const Eigen::Vector2d& xi = CubicTriangle::nodePoints()[j];
        atNodes.row(j) = quadratics(xi[0], xi[1]);
    }
    return atNodes*normal.inverse()*weighted;
}

} // namespace positionalShell
