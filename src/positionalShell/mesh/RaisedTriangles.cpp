// SPDX-License-Identifier: GPL-3.0-or-later

#include "RaisedTriangles.hpp"
#include "CubicTriangle.hpp"
#include "ShellMeshChecks.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace positionalShell
{

namespace
{

//- Values at (xi1, xi2) of the linear or quadratic basis, by area coordinates
std::vector<double> lowerValues(int order, const Eigen::Vector2d& xi)
{
    const double L[3] = {1 - xi[0] - xi[1], xi[0], xi[1]};
    if (order == 1) return {L[0], L[1], L[2]};
    return
    {
        L[0]*(2*L[0] - 1), L[1]*(2*L[1] - 1), L[2]*(2*L[2] - 1),
        4*L[0]*L[1], 4*L[1]*L[2], 4*L[2]*L[0]
    };
}

//- Numbers the nodes of the cubic triangles as they come up
class Numbering
{
public:

    Numbering(int nNodes) : numberOf_(nNodes, -1) {}

    CubicTriangles result;

    //- The cubic node at a node of the lower order
    int kept(int node, const Vec3& x)
    {
        if (numberOf_[node] < 0) numberOf_[node] = added(x, node);
        return numberOf_[node];
    }

    //- The node of an edge nearer to its corner a. mid: the edge's own node of
    //  order 2: triangles that do not share it do not share the edge
    int onEdge(int a, int b, int mid, const Vec3& x)
    {
        const auto [found, isNew] = edges_.try_emplace({a, b, mid}, 0);
        if (isNew) found->second = added(x, -1);
        return found->second;
    }

    int added(const Vec3& x, int source)
    {
        result.nodes.push_back(x);
        result.source.push_back(source);
        return static_cast<int>(result.nodes.size()) - 1;
    }

private:

    std::vector<int> numberOf_;
    std::map<std::tuple<int, int, int>, int> edges_;
};

Vec3 point
(
    int order,
    const Eigen::Vector2d& xi,
    const std::vector<Vec3>& nodes,
    const std::vector<int>& triangle
)
{
    Vec3 x = Vec3::Zero();
    const std::vector<double> N = lowerValues(order, xi);
    for (std::size_t j = 0; j < N.size(); ++j) x += N[j]*nodes[triangle[j]];
    return x;
}

Triangle raised
(
    int order,
    const std::vector<Vec3>& nodes,
    const std::vector<int>& low,
    Numbering& numbering
)
{
    const auto& places = CubicTriangle::nodePoints();
    Triangle t;
    for (int i = 0; i < 3; ++i) t[i] = numbering.kept(low[i], nodes[low[i]]);
    for (int side = 0; side < 3; ++side)
    {
        const int a = low[side];
        const int b = low[(side + 1) % 3];
        const int mid = order == 2 ? low[3 + side] : -1;
        const auto& edge = CubicTriangle::edgeNodes()[side];
        const auto at = [&](int place)
        {
            return point(order, places[place], nodes, low);
        };
        t[edge[1]] = numbering.onEdge(a, b, mid, at(edge[1]));
        t[edge[2]] = numbering.onEdge(b, a, mid, at(edge[2]));
    }
    t[9] = numbering.added(point(order, places[9], nodes, low), -1);
    return t;
}

//- Normal at the corners of one triangle, length the angle between its edges
std::array<Vec3, 3> cornerNormals
(
    const std::vector<Vec3>& nodes,
    const Triangle& t
)
{
    std::array<Vec3, 3> normals;
    for (int i = 0; i < 3; ++i)
    {
        const Vec3 a = (nodes[t[(i + 1) % 3]] - nodes[t[i]]).normalized();
        const Vec3 b = (nodes[t[(i + 2) % 3]] - nodes[t[i]]).normalized();
        normals[i] = std::atan2(a.cross(b).norm(), a.dot(b))
           *meshChecks::nodalNormal(nodes, t, i).normalized();
    }
    return normals;
}

double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

int nodesOfOrder(int order)
{
    return (order + 1)*(order + 2)/2;
}

CubicTriangles raisedTriangles
(
    int order,
    const std::vector<Vec3>& nodes,
    const std::vector<std::vector<int>>& triangles
)
{
    if (order < 1 || order > 3)
    {
        throw std::invalid_argument
        (
            "triangles of order " + std::to_string(order)
          + " cannot be made cubic; 1, 2 and 3 can"
        );
    }

    Numbering numbering(static_cast<int>(nodes.size()));
    for (const std::vector<int>& low : triangles)
    {
        Triangle t;
        if (order < 3)
        {
            t = raised(order, nodes, low, numbering);
        }
        else
        {
            for (int j = 0; j < nodesPerElement; ++j)
            {
                t[j] = numbering.kept(low[j], nodes[low[j]]);
            }
        }
        numbering.result.triangles.push_back(t);
    }
    return std::move(numbering.result);
}

GeometricError geometricError
(
    int order,
    const CubicTriangles& raised,
    double featureAngle
)
{
    // (SM2) for straight edges, (SM3) for quadratic ones
    const double perSlope = order == 1 ? 0.125 : std::sqrt(3.0)/18;

    const auto& triangles = raised.triangles;
    std::vector<std::array<Vec3, 3>> normals;
    std::vector<std::vector<std::pair<int, int>>> around(raised.nodes.size());
    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        normals.push_back(cornerNormals(raised.nodes, triangles[e]));
        for (int i = 0; i < 3; ++i)
        {
            around[triangles[e][i]].emplace_back(static_cast<int>(e), i);
        }
    }

    GeometricError error;
    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        const Triangle& t = triangles[e];
        Vec3 tilt[3];
        for (int i = 0; i < 3; ++i)
        {
            Vec3 mean = Vec3::Zero();
            for (const auto& [other, place] : around[t[i]])
            {
                const Vec3& n = normals[other][place];
                if (angleBetween(normals[e][i], n) <= featureAngle) mean += n;
            }
            tilt[i] = mean.normalized() - normals[e][i].normalized();
            error.angle = std::max(error.angle, angleBetween(mean, normals[e][i]));
        }

        double bumps = 0;
        double largest = 0;
        for (int i = 0; i < 3; ++i)
        {
            const int j = (i + 1) % 3;
            const Vec3 along = raised.nodes[t[j]] - raised.nodes[t[i]];
            const double bump = order == 1
                ? perSlope*(tilt[j] - tilt[i]).dot(along)
                : perSlope*std::max
                  (
                      std::abs(tilt[i].dot(along)), std::abs(tilt[j].dot(along))
                  );
            bumps += bump;
            largest = std::max(largest, std::abs(bump));
        }
        // Straight edges: the quadratic (SM4) is largest inside where it is convex
        if (order == 1) largest = std::max(largest, std::abs(bumps)*4/9);
        if (largest > error.distance || error.element < 0)
        {
            error.distance = largest;
            error.element = static_cast<int>(e);
        }
    }
    return error;
}

} // namespace positionalShell
