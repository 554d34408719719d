// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nearest point of one cubic triangle to a point in space, in the initial state.

#ifndef positionalShell_ElementProjection_hpp
#define positionalShell_ElementProjection_hpp

#include "CubicTriangle.hpp"
#include "SurfaceLocator.hpp"

#include <Eigen/LU>

namespace positionalShell
{

class ElementProjection
{
public:

    ElementProjection(const ShellModel& model, int element);

    Projection project(const Vec3& X) const;

private:

    //- A place on the mid-surface and its squared distance from X
    struct Candidate
    {
        Eigen::Vector2d xi;
        double squaredDistance;
    };

    using NodalVectors = Eigen::Matrix<double, 3, nodesPerElement>;

    int element_;
    double halfThickness_;
    NodalVectors X_;
    NodalVectors directors_;

    Vec3 surface(const Eigen::Vector2d& xi) const;
    Candidate candidate(const Vec3& X, const Eigen::Vector2d& xi) const;

    //- Newton from the nearest node over the whole plane of (xi1, xi2)
    Candidate interior(const Vec3& X) const;

    //- Nearest point of an edge, ends included
    Candidate onEdge(const Vec3& X, int edge) const;

    //- Solve X = map(xi1, xi2, xi3), starting from p; false when it leads away
    //  from the element
    bool refine(const Vec3& X, SurfacePoint& p) const;
};

} // namespace positionalShell

#endif
