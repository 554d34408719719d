// SPDX-License-Identifier: GPL-3.0-or-later

#include "SectionForces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace positionalShell
{

namespace
{

//- Sine of the least angle between a direction and the director: well below, the
//  projection turns fast from node to node
constexpr double leastSine = 0.1;

//- Symmetric tensor of six contravariant components
Mat3 tensor(const Stress& S)
{
    Mat3 T;
    for (int v = 0; v < 6; ++v)
    {
        T(voigt[v][0], voigt[v][1]) = S[v];
        T(voigt[v][1], voigt[v][0]) = S[v];
    }
    return T;
}

} // namespace

Mat3 sectionAxes(const Mat3& G, const Section& section, const Vec3& direction)
{
    if (!section.axis.isZero()) return materialAxes(G, section);

    Section along;
    along.axis = direction;
    Mat3 axes = materialAxes(G, along, leastSine);
    for (int k = 0; k < 3 && axes.isZero(); ++k)
    {
        along.axis = Vec3::Unit(k);
        axes = materialAxes(G, along, leastSine);
    }
    return axes;
}

Mat3 presentAxes(const Mat3& G, const Mat3& now, const Mat3& axes)
{
    const Mat3 images = now*G.inverse()*axes;
    const Vec3 t = now.col(2).normalized();
    const Vec3 first = images.col(0);
    const Vec3 u = (first - t*t.dot(first)).normalized();
    const Vec3 v = t.cross(u);
    const double angle = std::atan2
    (
        images.col(0).dot(v) - images.col(1).dot(u),
        images.col(0).dot(u) + images.col(1).dot(v)
    );
    Mat3 present;
    present.col(0) = std::cos(angle)*u + std::sin(angle)*v;
    present.col(1) = t.cross(present.col(0));
    present.col(2) = t;
    return present;
}

void SectionSums::add
(
    const Stress& S,
    double weight,
    const Mat3& now,
    double lever
)
{
    // Tractions t^alpha, (S10)
    const Eigen::Matrix<double, 3, 2> t =
        weight*(now*tensor(S)).leftCols<2>();
    force_ += t;
    couple_ += lever*t;
}

SectionForces SectionSums::forces
(
    const Mat3& G,
    const Mat3& axes,
    const Mat3& present,
    double stretch
) const
{
    // Covariant components of the two normals, over the area element, (R6)
    const double area = G.col(0).cross(G.col(1)).norm();
    const Eigen::Matrix2d normals =
        (G.leftCols<2>().transpose()*axes.leftCols<2>())/area;
    const Eigen::Matrix<double, 3, 2> force = force_*normals;
    const Eigen::Matrix<double, 3, 2> couple = couple_*normals;

    SectionForces result;
    result.N = force.transpose()*present.leftCols<2>();
    result.M = stretch*couple.transpose()*present.leftCols<2>();
    result.Q = force.transpose()*present.col(2);
    return result;
}

} // namespace positionalShell
