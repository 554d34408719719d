// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of a parametrised surface: nU x nV quadrilaterals, each split into two
// cubic triangles, nodes placed exactly on the surface. Between the lines of the
// quadrilaterals nodes divide u and v evenly.
//
// Node sets: uMin uMax vMin vMax (edges), and the corners uMinVMin uMaxVMin
// uMinVMax uMaxVMax. Normals follow du x dv. On a closed surface uMin and uMax are
// both the seam; an edge that is a pole holds one node, with one triangle per
// quadrilateral round it.

#ifndef positionalShell_StructuredMesh_hpp
#define positionalShell_StructuredMesh_hpp

#include "ShellMesh.hpp"

#include <functional>

namespace positionalShell
{

//- Point of the surface for u, v in [0, 1]
using SurfaceMap = std::function<Vec3(double u, double v)>;

struct StructuredLayout
{
    //- Parameters of the lines between quadrilaterals, from 0 to 1, ascending
    std::vector<double> u;
    std::vector<double> v;

    //- The lines u = 0 and u = 1 are the same
    bool closedU = false;

    //- The edge v = 0, v = 1 is a single point
    bool poleVMin = false;
    bool poleVMax = false;

    //- nU x nV quadrilaterals of equal size
    static StructuredLayout even(int nU, int nV);
};

//- Throws std::invalid_argument for lines that do not ascend from 0 to 1, less
//  than 3 quadrilaterals round a closed surface, poles at both ends of a single
//  quadrilateral
ShellMesh structuredMesh
(
    const StructuredLayout& layout,
    const SurfaceMap& position,
    const SurfaceMap& normal = nullptr
);

//- The unit normals may be given where they are known exactly
ShellMesh structuredMesh
(
    int nU,
    int nV,
    const SurfaceMap& position,
    const SurfaceMap& normal = nullptr
);

//- Flat rectangle origin + u*sideU + v*sideV
ShellMesh rectangleMesh
(
    int nU,
    int nV,
    const Vec3& origin,
    const Vec3& sideU,
    const Vec3& sideV
);

} // namespace positionalShell

#endif
