// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementProjection.hpp"

#include <algorithm>
#include <cmath>

namespace positionalShell
{

namespace
{

constexpr int maxIterations = 50;

//- Newton increments below this are round-off of coordinates of order one
constexpr double smallStep = 1e-14;

bool inside(const Eigen::Vector2d& xi, double margin)
{
    return xi[0] >= -margin && xi[1] >= -margin && xi.sum() <= 1 + margin;
}

} // namespace

ElementProjection::ElementProjection(const ShellModel& model, int element)
:
    element_(element),
    halfThickness_(0.5*model.thickness(element))
{
    const ShellMesh& mesh = model.mesh();
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const int node = mesh.triangle(element)[j];
        X_.col(j) = mesh.nodes()[node];
        directors_.col(j) = mesh.directors()[node];
    }
}

Vec3 ElementProjection::surface(const Eigen::Vector2d& xi) const
{
    return X_*CubicTriangle::values(xi[0], xi[1]);
}

ElementProjection::Candidate ElementProjection::candidate
(
    const Vec3& X,
    const Eigen::Vector2d& xi
) const
{
    return {xi, (X - surface(xi)).squaredNorm()};
}

ElementProjection::Candidate ElementProjection::interior(const Vec3& X) const
{
    Candidate best = candidate(X, CubicTriangle::nodePoints()[0]);
    for (const auto& xi : CubicTriangle::nodePoints())
    {
        const Candidate node = candidate(X, xi);
        if (node.squaredDistance < best.squaredDistance) best = node;
    }

    Eigen::Vector2d xi = best.xi;
    for (int k = 0; k < maxIterations; ++k)
    {
        const Eigen::Matrix<double, 3, 2> d1 =
            X_*CubicTriangle::gradients(xi[0], xi[1]);
        const Eigen::Matrix<double, 3, 3> d2 =
            X_*CubicTriangle::secondDerivatives(xi[0], xi[1]);
        const Vec3 gap = X - surface(xi);

        // Half the gradient and the Hessian of the squared distance
        const Eigen::Vector2d slope = -d1.transpose()*gap;
        const Eigen::Matrix2d gaussNewton = d1.transpose()*d1;
        const Eigen::Vector3d bend = d2.transpose()*gap;
        Eigen::Matrix2d H = gaussNewton;
        H(0, 0) -= bend[0];
        H(1, 1) -= bend[1];
        H(0, 1) -= bend[2];
        H(1, 0) -= bend[2];
        // Away from a minimum the Hessian may lead uphill
        if (!(H(0, 0) > 0 && H.determinant() > 0)) H = gaussNewton;

        Eigen::Vector2d step = -H.inverse()*slope;
        const double length = step.norm();
        if (length > 0.5) step *= 0.5/length;
        xi += step;
        if (length < smallStep || !inside(xi, 1)) break;
    }
    return candidate(X, xi);
}

ElementProjection::Candidate ElementProjection::onEdge
(
    const Vec3& X,
    int edge
) const
{
    const auto& places = CubicTriangle::edgeNodes()[edge];
    const Eigen::Vector2d from = CubicTriangle::nodePoints()[places[0]];
    const Eigen::Vector2d along =
        CubicTriangle::nodePoints()[places[3]] - from;
    const auto at = [&](double s) -> Eigen::Vector2d { return from + s*along; };

    double s = 0;
    Candidate best = candidate(X, at(0));
    for (double start : {1.0/6, 1.0/3, 0.5, 2.0/3, 5.0/6, 1.0})
    {
        const Candidate other = candidate(X, at(start));
        if (other.squaredDistance < best.squaredDistance)
        {
            best = other;
            s = start;
        }
    }
    for (int k = 0; k < maxIterations; ++k)
    {
        const Eigen::Vector2d xi = at(s);
        const Vec3 d1 =
            X_*(CubicTriangle::gradients(xi[0], xi[1])*along);
        const Eigen::Vector3d squares
        (
            along[0]*along[0], along[1]*along[1], 2*along[0]*along[1]
        );
        const Vec3 d2 =
            X_*(CubicTriangle::secondDerivatives(xi[0], xi[1])*squares);
        const Vec3 gap = X - surface(xi);
        const double gaussNewton = d1.squaredNorm();
        const double full = gaussNewton - gap.dot(d2);
        const double step = gap.dot(d1)/(full > 0 ? full : gaussNewton);
        const double next = std::clamp(s + step, 0.0, 1.0);
        const double moved = std::abs(next - s);
        s = next;
        if (moved < smallStep) break;
    }
    const Candidate end = candidate(X, at(s));
    return end.squaredDistance < best.squaredDistance ? end : best;
}

bool ElementProjection::refine(const Vec3& X, SurfacePoint& p) const
{
    // A point just beyond an edge is better carried by the smooth continuation
    // of the element than clamped to its edge
    constexpr double margin = 0.01;

    SurfacePoint r = p;
    for (int k = 0; k < maxIterations; ++k)
    {
        const auto N = CubicTriangle::values(r.xi1, r.xi2);
        const auto dN = CubicTriangle::gradients(r.xi1, r.xi2);
        const NodalVectors carried = X_ + halfThickness_*r.xi3*directors_;
        Eigen::Matrix3d J;
        J.leftCols<2>() = carried*dN;
        J.col(2) = halfThickness_*directors_*N;
        const Vec3 step = J.inverse()*(X - carried*N);
        r.xi1 += step[0];
        r.xi2 += step[1];
        r.xi3 += step[2];
        if (!inside({r.xi1, r.xi2}, 1) || !step.allFinite()) return false;
        if (step.head<2>().norm() < smallStep) break;
    }
    const NodalVectors carried = X_ + halfThickness_*r.xi3*directors_;
    const double miss =
        (X - carried*CubicTriangle::values(r.xi1, r.xi2)).norm();
    const double size = (X_.colwise() - X_.col(0)).norm();
    if (!inside({r.xi1, r.xi2}, margin) || miss > 1e-10*size) return false;
    p = r;
    return true;
}

Projection ElementProjection::project(const Vec3& X) const
{
    Candidate best = onEdge(X, 0);
    for (int edge : {1, 2})
    {
        const Candidate other = onEdge(X, edge);
        if (other.squaredDistance < best.squaredDistance) best = other;
    }
    const Candidate within = interior(X);
    if
    (
        inside(within.xi, 0)
     && within.squaredDistance <= best.squaredDistance
    )
    {
        best = within;
    }

    const auto N = CubicTriangle::values(best.xi[0], best.xi[1]);
    const Vec3 onSurface = X_*N;
    const Vec3 director = directors_*N;
    Projection result;
    result.distance = std::sqrt(best.squaredDistance);
    result.point.element = element_;
    result.point.xi1 = best.xi[0];
    result.point.xi2 = best.xi[1];
    result.point.xi3 = (X - onSurface).dot(director)
        /(halfThickness_*director.squaredNorm());
    refine(X, result.point);

    const SurfacePoint& p = result.point;
    const NodalVectors carried = X_ + halfThickness_*p.xi3*directors_;
    result.offset = X - carried*CubicTriangle::values(p.xi1, p.xi2);
    return result;
}

} // namespace positionalShell
