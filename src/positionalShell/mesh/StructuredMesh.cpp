// SPDX-License-Identifier: GPL-3.0-or-later

#include "StructuredMesh.hpp"
#include "CubicTriangle.hpp"

#include <stdexcept>

namespace positionalShell
{

namespace
{

//- Lattice of (3 nU + 1) x (3 nV + 1) nodes, u running fastest
struct Lattice
{
    int nU;
    int nV;

    int countU() const { return 3*nU + 1; }
    int countV() const { return 3*nV + 1; }
    int node(int i, int j) const { return j*countU() + i; }
};

//- The two triangles of the quadrilateral with lower corner (i0, j0): the second
//  is the first turned by half a turn
void addTriangles
(
    const Lattice& lattice,
    int i0,
    int j0,
    std::vector<Triangle>& triangles
)
{
    Triangle lower;
    Triangle upper;
    const auto& places = CubicTriangle::nodePoints();
    for (int k = 0; k < nodesPerElement; ++k)
    {
        const int di = static_cast<int>(3*places[k][0] + 0.5);
        const int dj = static_cast<int>(3*places[k][1] + 0.5);
        lower[k] = lattice.node(i0 + di, j0 + dj);
        upper[k] = lattice.node(i0 + 3 - di, j0 + 3 - dj);
    }
    triangles.push_back(lower);
    triangles.push_back(upper);
}

NamedSets edgeSets(const Lattice& lattice)
{
    NamedSets sets;
    const int lastU = lattice.countU() - 1;
    const int lastV = lattice.countV() - 1;
    for (int j = 0; j <= lastV; ++j)
    {
        sets["uMin"].push_back(lattice.node(0, j));
        sets["uMax"].push_back(lattice.node(lastU, j));
    }
    for (int i = 0; i <= lastU; ++i)
    {
        sets["vMin"].push_back(lattice.node(i, 0));
        sets["vMax"].push_back(lattice.node(i, lastV));
    }
    sets["uMinVMin"] = {lattice.node(0, 0)};
    sets["uMaxVMin"] = {lattice.node(lastU, 0)};
    sets["uMinVMax"] = {lattice.node(0, lastV)};
    sets["uMaxVMax"] = {lattice.node(lastU, lastV)};
    return sets;
}

} // namespace

ShellMesh structuredMesh
(
    int nU,
    int nV,
    const SurfaceMap& position,
    const SurfaceMap& normal
)
{
    if (nU < 1 || nV < 1)
    {
        throw std::invalid_argument
        (
            "structured mesh: " + std::to_string(nU) + " x "
          + std::to_string(nV) + " quadrilaterals; both must be at least 1"
        );
    }

    const Lattice lattice{nU, nV};
    std::vector<Vec3> nodes;
    std::vector<Vec3> directors;
    for (int j = 0; j < lattice.countV(); ++j)
    {
        for (int i = 0; i < lattice.countU(); ++i)
        {
            const double u = double(i)/(lattice.countU() - 1);
            const double v = double(j)/(lattice.countV() - 1);
            nodes.push_back(position(u, v));
            if (normal) directors.push_back(normal(u, v));
        }
    }

    std::vector<Triangle> triangles;
    for (int j = 0; j < nV; ++j)
    {
        for (int i = 0; i < nU; ++i)
        {
            addTriangles(lattice, 3*i, 3*j, triangles);
        }
    }
    return ShellMesh
    (
        std::move(nodes), std::move(triangles), edgeSets(lattice), {},
        std::move(directors)
    );
}

ShellMesh rectangleMesh
(
    int nU,
    int nV,
    const Vec3& origin,
    const Vec3& sideU,
    const Vec3& sideV
)
{
    return structuredMesh
    (
        nU, nV,
        [&](double u, double v) -> Vec3 { return origin + u*sideU + v*sideV; }
    );
}

} // namespace positionalShell
