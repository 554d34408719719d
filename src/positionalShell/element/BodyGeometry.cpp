// SPDX-License-Identifier: GPL-3.0-or-later

#include "BodyGeometry.hpp"
#include "CubicTriangle.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace positionalShell
{

AreaPoint areaPoint(double xi1, double xi2, double weight)
{
    const auto N = CubicTriangle::values(xi1, xi2);
    const auto dN = CubicTriangle::gradients(xi1, xi2);
    AreaPoint point;
    point.weight = weight;
    for (int j = 0; j < nodesPerElement; ++j)
    {
        point.phi[j][0] = N[j];
        point.phi[j][1] = dN(j, 0);
        point.phi[j][2] = dN(j, 1);
    }
    return point;
}

Mat3 baseVectors
(
    const Triangle& triangle,
    const Vector& q,
    double halfThickness,
    const AreaPoint& point,
    double zeta
)
{
    Vec3 m[2] = {Vec3::Zero(), Vec3::Zero()};
    Vec3 g = Vec3::Zero();
    Vec3 dg[2] = {Vec3::Zero(), Vec3::Zero()};
    double a = 0;
    double da[2] = {0, 0};
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const double* node = q.data() + dofsPerNode*triangle[j];
        const Eigen::Map<const Vec3> xj(node);
        const Eigen::Map<const Vec3> gj(node + 3);
        g += point.phi[j][0]*gj;
        a += point.phi[j][0]*node[6];
        for (int d = 0; d < 2; ++d)
        {
            m[d] += point.phi[j][1 + d]*xj;
            dg[d] += point.phi[j][1 + d]*gj;
            da[d] += point.phi[j][1 + d]*node[6];
        }
    }
    Mat3 base;
    for (int d = 0; d < 2; ++d)
    {
        base.col(d) = m[d] + halfThickness
            *((zeta + a*zeta*zeta)*dg[d] + zeta*zeta*da[d]*g);
    }
    base.col(2) = halfThickness*(1 + 2*a*zeta)*g;
    return base;
}

Mat3 materialAxes(const Mat3& G, const Section& section, double leastSine)
{
    const bool given = !section.axis.isZero();
    const Vec3 n = G.col(2).normalized();
    const Vec3 along = given ? section.axis : Vec3(G.col(0));
    const Vec3 projected = along - n*n.dot(along);
    if (given && projected.norm() < leastSine*along.norm()) return Mat3::Zero();

    const Vec3 t = projected.normalized();
    Mat3 axes;
    axes.col(2) = n;
    axes.col(0) =
        std::cos(section.angle)*t + std::sin(section.angle)*n.cross(t);
    axes.col(1) = n.cross(axes.col(0));
    return axes;
}

ElasticMatrix strainTransform(const Mat3& G, const Mat3& axes)
{
    // B(i, c): contravariant base vector i along local axis c
    const Mat3 B = G.inverse()*axes;
    ElasticMatrix T;
    for (int u = 0; u < 6; ++u)
    {
        const int c = voigt[u][0];
        const int d = voigt[u][1];
        const double shear = c == d ? 1 : 2;
        for (int v = 0; v < 6; ++v)
        {
            const int i = voigt[v][0];
            const int j = voigt[v][1];
            T(u, v) = 0.5*shear*(B(i, c)*B(j, d) + B(j, c)*B(i, d));
        }
    }
    return T;
}

} // namespace positionalShell
