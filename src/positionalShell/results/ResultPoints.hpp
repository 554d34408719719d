// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where results live: a point for each node, and one more for each further part of
// the shell that meets there. Parts are elements of one section whose normals are
// within the fold angle of each other, directly or through others of the node:
// stresses are averaged within a part, and jump between parts.
//
// The first points are the nodes in their order; those of further parts follow.

#ifndef positionalShell_ResultPoints_hpp
#define positionalShell_ResultPoints_hpp

#include "ShellModel.hpp"

namespace positionalShell
{

class ResultPoints
{
public:

    //- foldAngle [rad]: between normals in the initial state. Throws
    //  std::invalid_argument unless it is between 0 and pi.
    ResultPoints(const ShellModel& model, double foldAngle);

    int size() const { return int(node_.size()); }

    //- Node that a point lies at
    int node(int point) const { return node_[point]; }

    //- Points of an element in the order of its nodes
    const Triangle& ofElement(int element) const { return points_[element]; }

    //- Number of elements that have the point
    int nElements(int point) const { return nElements_[point]; }

private:

    std::vector<int> node_;
    std::vector<int> nElements_;
    std::vector<Triangle> points_;

    //- Node of an element, by its place in it
    struct Corner
    {
        int element;
        int place;
        Vec3 normal;
    };

    void addNode
    (
        const ShellModel& model,
        double leastCosine,
        int node,
        const std::vector<Corner>& corners
    );
};

} // namespace positionalShell

#endif
