// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ShellMesh demands of its input. Each check throws std::invalid_argument
// that names the node or element, in the words of names, and where it lies.

#ifndef positionalShell_ShellMeshChecks_hpp
#define positionalShell_ShellMeshChecks_hpp

#include "MeshNames.hpp"
#include "ShellMesh.hpp"

namespace positionalShell
{

namespace meshChecks
{
    //- Indices in range, none twice in a triangle, no node unused
    void indices
    (
        const std::vector<Vec3>& nodes,
        const std::vector<Triangle>& triangles,
        const MeshNames& names
    );

    //- Area vector of the same side everywhere in each triangle
    void shapes
    (
        const std::vector<Vec3>& nodes,
        const std::vector<Triangle>& triangles,
        const MeshNames& names
    );

    //- Common edges share their inner nodes, run against each other, and
    //  belong to two triangles at most
    void neighbours
    (
        const std::vector<Triangle>& triangles,
        const MeshNames& names
    );

    //- Finite, and on the side of the normal of every element at the node
    void directors
    (
        const std::vector<Vec3>& nodes,
        const std::vector<Triangle>& triangles,
        const std::vector<Vec3>& directors,
        const MeshNames& names
    );

    //- X,1 x X,2 at a node of the triangle
    Vec3 nodalNormal
    (
        const std::vector<Vec3>& nodes,
        const Triangle& triangle,
        int node
    );
}

} // namespace positionalShell

#endif
