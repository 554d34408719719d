// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geometry of the body at a point, for what is done once or at write times only:
// base vectors, material axes, covariant and local Cartesian components, (S6), (S9).

#ifndef positionalShell_BodyGeometry_hpp
#define positionalShell_BodyGeometry_hpp

#include "ElementBatch.hpp"
#include "Section.hpp"
#include "ShellMesh.hpp"

namespace positionalShell
{

using Mat3 = Eigen::Matrix3d;

//- Pairs of vectors of six in the order 11 22 33 12 23 13
constexpr int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};

//- Basis functions at a point of the parent triangle
AreaPoint areaPoint(double xi1, double xi2, double weight);

//- Base vectors dx/dxi_i as columns, in state q of the mesh, (S6)
Mat3 baseVectors
(
    const Triangle& triangle,
    const Vector& q,
    double halfThickness,
    const AreaPoint& point,
    double zeta
);

//- Material axes as columns, from the initial base vectors: 3 along the director, 1
//  along the projected direction of the section or, where it has none, of G_1.
//  Zero where the sine of the angle between a given direction and the director is
//  below leastSine.
Mat3 materialAxes
(
    const Mat3& G,
    const Section& section,
    double leastSine = 1e-3
);

//- Local Cartesian from covariant strain, (S9)
ElasticMatrix strainTransform(const Mat3& G, const Mat3& axes);

} // namespace positionalShell

#endif
