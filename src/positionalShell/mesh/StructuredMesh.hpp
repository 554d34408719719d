// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of a parametrised surface: nU x nV quadrilaterals, each split into two
// cubic triangles, nodes placed exactly on the surface.
//
// Node sets: uMin uMax vMin vMax (edges), and the corners uMinVMin uMaxVMin
// uMinVMax uMaxVMax. Normals follow du x dv.

#ifndef positionalShell_StructuredMesh_hpp
#define positionalShell_StructuredMesh_hpp

#include "ShellMesh.hpp"

#include <functional>

namespace positionalShell
{

//- Point of the surface for u, v in [0, 1]
using SurfaceMap = std::function<Vec3(double u, double v)>;

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
