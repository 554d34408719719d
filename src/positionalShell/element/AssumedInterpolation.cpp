// SPDX-License-Identifier: GPL-3.0-or-later

#include "AssumedInterpolation.hpp"
#include "CubicTriangle.hpp"

#include <Eigen/LU>

namespace positionalShell
{

namespace
{

constexpr int nQuadratic = 6;
constexpr int nShear = 2*nQuadratic;
constexpr int pointsPerEdge = AssumedInterpolation::pointsPerEdge;
constexpr int nEdgePoints = AssumedInterpolation::nEdgePoints;
constexpr int nMoments = AssumedInterpolation::nMoments;

using Vec2 = Eigen::Vector2d;
using Quadratic = Eigen::Matrix<double, 1, nQuadratic>;

//- Complete quadratics
Quadratic quadratics(const Vec2& x)
{
    Quadratic values;
    values << 1, x[0], x[1], x[0]*x[0], x[0]*x[1], x[1]*x[1];
    return values;
}

//- Linear functions that the moments are taken with
Eigen::Vector3d linears(const TrianglePoint& p)
{
    return {1, p.xi1 - 1.0/3, p.xi2 - 1.0/3};
}

Vec2 corner(int edge)
{
    return CubicTriangle::nodePoints()[edge%3];
}

Vec2 direction(int edge)
{
    return corner(edge + 1) - corner(edge);
}

Vec2 place(int edge, const LinePoint& g)
{
    return corner(edge) + 0.5*(1 + g.xi)*direction(edge);
}

EdgePoint edgePoint(int edge, const LinePoint& g)
{
    const double s = 0.5*(1 + g.xi);
    const Eigen::Vector4d N = CubicTriangle::edgeValues(s);
    const Eigen::Vector4d dN = CubicTriangle::edgeDerivatives(s);
    EdgePoint point;
    for (int k = 0; k < EdgePoint::nNodes; ++k)
    {
        point.nodes[k] = CubicTriangle::edgeNodes()[edge][k];
        point.N[k] = N[k];
        point.dN[k] = dN[k];
    }
    return point;
}

//- Membrane strain along one edge's direction, (A4): three values on that edge and
//  three moments to the six coefficients
Eigen::Matrix<double, nQuadratic, nQuadratic> membraneCoefficients
(
    int edge,
    const std::vector<TrianglePoint>& rule
)
{
    Eigen::Matrix<double, nQuadratic, nQuadratic> dofs;
    dofs.setZero();
    for (int s = 0; s < pointsPerEdge; ++s)
    {
        dofs.row(s) = quadratics(place(edge, gaussRule(pointsPerEdge)[s]));
    }
    for (const TrianglePoint& p : rule)
    {
        dofs.bottomRows<nMoments>() +=
            p.weight*linears(p)*quadratics({p.xi1, p.xi2});
    }
    return dofs.inverse();
}

//- Transverse shear, (A5): nine values along the edges and three moments to the
//  twelve coefficients
Eigen::Matrix<double, nShear, nShear> shearCoefficients
(
    const std::vector<TrianglePoint>& rule
)
{
    Eigen::Matrix<double, nShear, nShear> dofs;
    dofs.setZero();
    for (int edge = 0; edge < 3; ++edge)
    {
        const Vec2 t = direction(edge);
        for (int s = 0; s < pointsPerEdge; ++s)
        {
            const auto values =
                quadratics(place(edge, gaussRule(pointsPerEdge)[s]));
            dofs.row(pointsPerEdge*edge + s) << t[0]*values, t[1]*values;
        }
    }
    for (const TrianglePoint& p : rule)
    {
        const Eigen::Vector3d l = p.weight*linears(p);
        const auto values = quadratics({p.xi1, p.xi2});
        dofs.block<1, nQuadratic>(nEdgePoints, 0) += l[0]*values;
        dofs.block<1, nQuadratic>(nEdgePoints + 1, nQuadratic) += l[0]*values;
        dofs.block<1, nQuadratic>(nEdgePoints + 2, 0) += l[1]*values;
        dofs.block<1, nQuadratic>(nEdgePoints + 2, nQuadratic) += l[2]*values;
    }
    return dofs.inverse();
}

} // namespace

AssumedInterpolation assumedInterpolation
(
    const std::vector<TrianglePoint>& areaRule
)
{
    AssumedInterpolation result;
    for (int edge = 0; edge < 3; ++edge)
    {
        for (int s = 0; s < pointsPerEdge; ++s)
        {
            result.edge[pointsPerEdge*edge + s] =
                edgePoint(edge, gaussRule(pointsPerEdge)[s]);
        }
    }

    const auto shear = shearCoefficients(areaRule);
    for (const TrianglePoint& p : areaRule)
    {
        AssumedInterpolation::AtPoint point;
        const Quadratic values = quadratics({p.xi1, p.xi2});
        Eigen::Map<Eigen::Vector3d>(point.moment) = p.weight*linears(p);
        for (int edge = 0; edge < 3; ++edge)
        {
            const auto row = (values*membraneCoefficients(edge, areaRule)).eval();
            for (int k = 0; k < 3; ++k)
            {
                point.membraneEdge[edge][k] = row[k];
                point.membraneMoment[edge][k] = row[pointsPerEdge + k];
            }
        }
        for (int d = 0; d < 2; ++d)
        {
            const auto row =
                (values*shear.middleRows<nQuadratic>(nQuadratic*d)).eval();
            for (int k = 0; k < nEdgePoints; ++k) point.shearEdge[d][k] = row[k];
            for (int k = 0; k < nMoments; ++k)
            {
                point.shearMoment[d][k] = row[nEdgePoints + k];
            }
        }
        result.points.push_back(point);
    }
    return result;
}

} // namespace positionalShell
