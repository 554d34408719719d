// SPDX-License-Identifier: GPL-3.0-or-later

#include "MotionMap.hpp"
#include "CubicTriangle.hpp"

#include <Eigen/Geometry>

namespace positionalShell
{

Vec3 MotionMap::combine(const SurfacePoint& p, const Vector& full) const
{
    const Triangle& triangle = model_.mesh().triangle(p.element);
    const double arm = 0.5*model_.thickness(p.element)*p.xi3;
    const auto N = CubicTriangle::values(p.xi1, p.xi2);
    Vec3 sum = Vec3::Zero();
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const auto node = full.segment<6>(dofsPerNode*triangle[j]);
        sum += N[j]*(node.head<3>() + arm*node.tail<3>());
    }
    return sum;
}

Vec3 MotionMap::position(const SurfacePoint& p, const Vector& q) const
{
    return combine(p, q);
}

Vec3 MotionMap::velocity(const SurfacePoint& p, const Vector& dqdt) const
{
    return combine(p, dqdt);
}

void MotionMap::addForce
(
    const SurfacePoint& p,
    const Vec3& force,
    Vector& generalisedForce
) const
{
    const Triangle& triangle = model_.mesh().triangle(p.element);
    const double arm = 0.5*model_.thickness(p.element)*p.xi3;
    const auto N = CubicTriangle::values(p.xi1, p.xi2);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        auto node = generalisedForce.segment<6>(dofsPerNode*triangle[j]);
        node.head<3>() += N[j]*force;
        node.tail<3>() += N[j]*arm*force;
    }
}

Vec3 MotionMap::normal(const SurfacePoint& p, const Vector& q) const
{
    const Triangle& triangle = model_.mesh().triangle(p.element);
    const double arm = 0.5*model_.thickness(p.element)*p.xi3;
    const auto dN = CubicTriangle::gradients(p.xi1, p.xi2);
    Vec3 y1 = Vec3::Zero();
    Vec3 y2 = Vec3::Zero();
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const auto node = q.segment<6>(dofsPerNode*triangle[j]);
        const Vec3 y = node.head<3>() + arm*node.tail<3>();
        y1 += dN(j, 0)*y;
        y2 += dN(j, 1)*y;
    }
    return y1.cross(y2).normalized();
}

} // namespace positionalShell
