// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellMeshChecks.hpp"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace positionalShell
{

namespace meshChecks
{

namespace
{

[[noreturn]] void fail(const std::string& what)
{
    throw std::invalid_argument("shell mesh: " + what);
}

std::string at(const Vec3& x)
{
    std::ostringstream text;
    text << " at (" << x[0] << ' ' << x[1] << ' ' << x[2] << ')';
    return text.str();
}

Vec3 normal
(
    const std::vector<Vec3>& nodes,
    const Triangle& triangle,
    const CubicTriangle::Gradients& dN
)
{
    Vec3 x1 = Vec3::Zero();
    Vec3 x2 = Vec3::Zero();
    for (int j = 0; j < nodesPerElement; ++j)
    {
        x1 += dN(j, 0)*nodes[triangle[j]];
        x2 += dN(j, 1)*nodes[triangle[j]];
    }
    return x1.cross(x2);
}

//- Gradients at the nodes and at a rule fine enough to see a fold between them
const std::vector<CubicTriangle::Gradients>& checkPoints()
{
    static const std::vector<CubicTriangle::Gradients> all = []
    {
        std::vector<CubicTriangle::Gradients> made;
        for (const auto& p : CubicTriangle::nodePoints())
        {
            made.push_back(CubicTriangle::gradients(p[0], p[1]));
        }
        for (const TrianglePoint& p : triangleRule(16))
        {
            made.push_back(CubicTriangle::gradients(p.xi1, p.xi2));
        }
        return made;
    }();
    return all;
}

struct EdgeUse
{
    int element;
    CubicEdge nodes;
};

void compare
(
    const EdgeUse& first,
    const EdgeUse& second,
    const MeshNames& names
)
{
    const std::string both =
        names.element(first.element) + " and " + names.element(second.element);
    if (first.nodes[0] == second.nodes[0])
    {
        fail(both + " are oriented against each other: turn one round");
    }
    CubicEdge reversed = second.nodes;
    std::reverse(reversed.begin(), reversed.end());
    if (reversed != first.nodes)
    {
        fail
        (
            both + " share the corners " + names.node(first.nodes[0])
          + " and " + names.node(first.nodes[3])
          + " but not the two nodes between them"
        );
    }
}

} // namespace

Vec3 nodalNormal
(
    const std::vector<Vec3>& nodes,
    const Triangle& triangle,
    int node
)
{
    return normal(nodes, triangle, checkPoints()[node]);
}

void indices
(
    const std::vector<Vec3>& nodes,
    const std::vector<Triangle>& triangles,
    const MeshNames& names
)
{
    const int n = static_cast<int>(nodes.size());
    std::vector<bool> used(n, false);
    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        Triangle sorted = triangles[e];
        std::sort(sorted.begin(), sorted.end());
        if (sorted.front() < 0 || sorted.back() >= n)
        {
            const int wrong = sorted.front() < 0 ? sorted.front() : sorted.back();
            fail
            (
                names.element(e) + " has node " + std::to_string(wrong) + ", but there are "
              + std::to_string(n) + " nodes, counted from 0"
            );
        }
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end())
        {
            fail
            (
                names.element(e) + " has " + names.node(*twice) + " twice"
            );
        }
        for (int node : triangles[e]) used[node] = true;
    }
    for (int i = 0; i < n; ++i)
    {
        if (!used[i])
        {
            fail
            (
                names.node(i) + at(nodes[i])
              + " belongs to no triangle"
            );
        }
        if (!nodes[i].allFinite())
        {
            fail(names.node(i) + " has no finite position");
        }
    }
}

void shapes
(
    const std::vector<Vec3>& nodes,
    const std::vector<Triangle>& triangles,
    const MeshNames& names
)
{
    // Relative to the square of the size: below it round-off decides the side
    constexpr double least = 1e-10;

    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        const Triangle& t = triangles[e];
        double size = 0;
        for (int j = 1; j < nodesPerElement; ++j)
        {
            size = std::max(size, (nodes[t[j]] - nodes[t[0]]).norm());
        }
        const Vec3 flat = (nodes[t[1]] - nodes[t[0]]).cross
        (
            nodes[t[2]] - nodes[t[0]]
        );
        const std::string name =
            names.element(e) + at(nodes[t[nodesPerElement - 1]]);
        if (!(flat.norm() > least*size*size))
        {
            fail(name + " has no area: its corners lie on a line");
        }
        for (const auto& dN : checkPoints())
        {
            if (!(normal(nodes, t, dN).dot(flat.normalized()) > least*size*size))
            {
                fail
                (
                    name + " is folded over: its mapping is inverted in some "
                    "part; check the order and the places of its nodes"
                );
            }
        }
    }
}

void neighbours
(
    const std::vector<Triangle>& triangles,
    const MeshNames& names
)
{
    std::map<std::pair<int, int>, std::vector<EdgeUse>> edges;
    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        for (const auto& places : CubicTriangle::edgeNodes())
        {
            EdgeUse use{static_cast<int>(e), {}};
            for (int i = 0; i < 4; ++i) use.nodes[i] = triangles[e][places[i]];
            edges[std::minmax(use.nodes[0], use.nodes[3])].push_back(use);
        }
    }
    for (const auto& [ends, uses] : edges)
    {
        if (uses.size() > 2)
        {
            fail
            (
                "more than two triangles (" + names.element(uses[0].element)
              + ", " + names.element(uses[1].element) + ", "
              + names.element(uses[2].element) + ") meet at the edge of "
              + names.node(ends.first) + " and " + names.node(ends.second)
              + "; branching shells are not supported"
            );
        }
        if (uses.size() == 2) compare(uses[0], uses[1], names);
    }
}

void directors
(
    const std::vector<Vec3>& nodes,
    const std::vector<Triangle>& triangles,
    const std::vector<Vec3>& directors,
    const MeshNames& names
)
{
    for (std::size_t e = 0; e < triangles.size(); ++e)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            const int node = triangles[e][j];
            const Vec3& d = directors[node];
            if
            (
               !d.allFinite()
            || !(d.dot(nodalNormal(nodes, triangles[e], j)) > 0)
            )
            {
                fail
                (
                    "the director of " + names.node(node) + at(nodes[node])
                  + " does not point to the upper side of " + names.element(e)
                );
            }
        }
    }
}

} // namespace meshChecks

} // namespace positionalShell
