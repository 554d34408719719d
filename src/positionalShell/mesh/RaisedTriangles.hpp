// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles of order 1 and 2 as cubic triangles of the same shape; equations (SM1),
// ... are those of doc/theory/shellMeshes.md.
//
// Node orders (gmsh's and VTK's): order 1: corners 0 1 2; order 2: also 3 on edge
// 0->1, 4 on 1->2, 5 on 2->0; order 3: see ShellMesh.hpp.

#ifndef positionalShell_RaisedTriangles_hpp
#define positionalShell_RaisedTriangles_hpp

#include "ShellMesh.hpp"

#include <array>
#include <map>
#include <vector>

namespace positionalShell
{

//- Number of nodes of a triangle of order 1 to 3: 3, 6, 10
int nodesOfOrder(int order);

struct CubicTriangles
{
    std::vector<Vec3> nodes;
    std::vector<Triangle> triangles;

    //- Node of the lower order at the place of each node, -1 where there is none
    std::vector<int> source;
};

//- Cubic triangles of exactly the given shape; neighbours share the nodes of
//  their common edge. Nodes that no triangle has are left out.
//  order: 1, 2 or 3; triangles: nodesOfOrder(order) indices each.
CubicTriangles raisedTriangles
(
    int order,
    const std::vector<Vec3>& nodes,
    const std::vector<std::vector<int>>& triangles
);

//- How far triangles of order 1 or 2 may be from the smooth surface they stand for
struct GeometricError
{
    //- Estimate of the largest distance [m] and the triangle it occurs at
    double distance = 0;
    int element = -1;

    //- Largest angle [rad] between a triangle's normal and the mean of the
    //  triangles at that corner: 0 for a flat shell
    double angle = 0;
};

//- Estimate (SM2) to (SM4). featureAngle [rad]: triangles whose normals differ by
//  more at a corner meet at a fold, which is no error.
GeometricError geometricError
(
    int order,
    const CubicTriangles& raised,
    double featureAngle
);

} // namespace positionalShell

#endif
