// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the shell point that a point in space belongs to, in the initial state:
// Newton projection onto the cubic mid-surface, clamped to the triangle; search
// over elements in a tree of bounding spheres, O(log N) per point.
//
// Where the projection falls inside the surface, the three coordinates are
// refined until the motion map reproduces the point itself. Where it falls on the
// rim, xi3 is the component along the director and the rest is the offset.

#ifndef positionalShell_SurfaceLocator_hpp
#define positionalShell_SurfaceLocator_hpp

#include "MotionMap.hpp"

#include <vector>

namespace positionalShell
{

struct Projection
{
    SurfacePoint point;
    double distance = 0;    // from the mid-surface [m], not signed
    Vec3 offset;            // X - map(point): what the map does not reproduce
};

class SurfaceLocator
{
public:

    //- The model must live as long as the locator
    explicit SurfaceLocator(const ShellModel& model);

    //- Nearest over all elements. hint: an element likely to be near, e.g. that
    //  of the previous point; changes the cost, not the answer.
    Projection locate(const Vec3& X, int hint = -1) const;

    //- Projection onto one given element
    Projection project(const Vec3& X, int element) const;

private:

    struct Sphere
    {
        Vec3 centre;
        double radius;
    };

    //- Node of the tree: children for inner nodes, element for leaves
    struct TreeNode
    {
        Sphere sphere;
        int left = -1;
        int right = -1;
        int element = -1;
    };

    const ShellModel& model_;
    std::vector<Sphere> spheres_;
    std::vector<TreeNode> tree_;

    int build(std::vector<int>& elements, int begin, int end);
};

} // namespace positionalShell

#endif
