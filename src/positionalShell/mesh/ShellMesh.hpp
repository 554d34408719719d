// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mid-surface mesh of 10-node cubic triangles with named sets.
//
// Node order of a triangle (the order of gmsh's order-3 triangle and of VTK's
// Lagrange triangle): corners 0 1 2; 3 4 on edge 0->1; 5 6 on edge 1->2; 7 8 on
// edge 2->0; 9 inside. Going round 0 1 2 anticlockwise about the normal defines
// the upper face (xi3 = +1).
//
// The set "all" exists from the start, for nodes and for elements.
//
// Initial directors (unit normals at nodes, e of (S1)) are the average of the unit
// normals of the elements that meet at the node, unless given.

#ifndef positionalShell_ShellMesh_hpp
#define positionalShell_ShellMesh_hpp

#include "MeshNames.hpp"
#include "ShellTypes.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace positionalShell
{

using Triangle = std::array<int, nodesPerElement>;
using NamedSets = std::map<std::string, std::vector<int>>;

//- Nodes of one cubic edge, from end to end
using CubicEdge = std::array<int, 4>;

class ShellMesh
{
public:

    //- Construct and check. names: what messages call nodes and elements.
    //  Throws std::invalid_argument, naming node, element or set, for: an index
    //  out of range, a node used by no triangle, a repeated node within a
    //  triangle, a triangle of zero or folded-over area, neighbours that do not
    //  share the inner nodes of their edge or that are oriented against each
    //  other, an edge of more than two triangles, a director that is not
    //  finite or does not point to the side of the normal.
    ShellMesh
    (
        std::vector<Vec3> nodes,
        std::vector<Triangle> triangles,
        NamedSets nodeSets = {},
        NamedSets elementSets = {},
        std::vector<Vec3> directors = {},
        const MeshNames& names = {}
    );

    int nNodes() const { return static_cast<int>(nodes_.size()); }
    int nElements() const { return static_cast<int>(triangles_.size()); }

    const std::vector<Vec3>& nodes() const { return nodes_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const Triangle& triangle(int element) const { return triangles_[element]; }

    //- Unit normals at the nodes in the initial state
    const std::vector<Vec3>& directors() const { return directors_; }

    //- Members of a set, ascending. A missing name throws
    //  std::invalid_argument that lists the sets there are.
    const std::vector<int>& nodeSet(const std::string& name) const;
    const std::vector<int>& elementSet(const std::string& name) const;
    bool hasNodeSet(const std::string& name) const;
    bool hasElementSet(const std::string& name) const;

    const NamedSets& nodeSets() const { return nodeSets_; }
    const NamedSets& elementSets() const { return elementSets_; }

    void addNodeSet(const std::string& name, std::vector<int> nodes);
    void addElementSet(const std::string& name, std::vector<int> elements);

    //- Every edge of the mesh whose four nodes belong to the set, once
    std::vector<CubicEdge> edgesOf(const std::string& nodeSet) const;

    //- Diagonal of the bounding box: the length that increments are judged by
    double lengthScale() const { return lengthScale_; }

    //- Initial state as a full vector: positions, directors, a = 0
    Vector initialPositions() const;

    //- Node nearest to a point in the initial state
    int nearestNode(const Vec3& point) const;

private:

    std::vector<Vec3> nodes_;
    std::vector<Triangle> triangles_;
    NamedSets nodeSets_;
    NamedSets elementSets_;
    std::vector<Vec3> directors_;
    double lengthScale_ = 0;

    void setDirectors(std::vector<Vec3> given, const MeshNames& names);
};

} // namespace positionalShell

#endif
