// SPDX-License-Identifier: GPL-3.0-or-later

#include "RigidTie.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <stdexcept>

namespace positionalShell
{

namespace
{

Vec3 position(const Vector& full, int node)
{
    return full.segment<3>(fullIndex(node, Component::x));
}

Vec3 director(const Vector& full, int node)
{
    return full.segment<3>(fullIndex(node, Component::gx));
}

RigidTie::Mat3 inertiaOf(const Vec3& r)
{
    return r.squaredNorm()*RigidTie::Mat3::Identity() - r*r.transpose();
}

} // namespace

Vec3 TieForce::momentAboutCentre() const
{
    return moment + arm.cross(force);
}

RigidTie::RigidTie
(
    const ShellMesh& mesh,
    const std::string& nodeSet,
    const Vec3& point
)
:
    nodeSet_(nodeSet),
    nodes_(mesh.nodeSet(nodeSet)),
    initial_(mesh.initialPositions())
{
    const Vec3 c = centre(initial_);
    point_ = point - c;
    double squares = 0;
    for (int node : nodes_) squares += (position(initial_, node) - c).squaredNorm();
    weight_ = squares/double(nodes_.size());

    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia(initial_));
    const Vec3 moments = principal.eigenvalues();
    if (!(moments[0] > 1e-10*moments[2]))
    {
        throw std::invalid_argument
        (
            "rigid tie of node set " + nodeSet + ": its nodes are at one place; "
            "a rotation needs two or more"
        );
    }
}

Vec3 RigidTie::centre(const Vector& q) const
{
    Vec3 sum = Vec3::Zero();
    for (int node : nodes_) sum += position(q, node);
    return sum/double(nodes_.size());
}

RigidTie::Mat3 RigidTie::inertia(const Vector& q) const
{
    const Vec3 c = centre(q);
    Mat3 sum = Mat3::Zero();
    for (int node : nodes_)
    {
        sum += inertiaOf(position(q, node) - c)
            + weight_*inertiaOf(director(q, node));
    }
    return sum;
}

RigidTie::Mat3 RigidTie::rotation(const Vector& q) const
{
    const Vec3 c0 = centre(initial_);
    const Vec3 c = centre(q);
    Mat3 sum = Mat3::Zero();
    for (int node : nodes_)
    {
        sum += (position(q, node) - c)*(position(initial_, node) - c0).transpose()
            + weight_*director(q, node)*director(initial_, node).transpose();
    }
    const Eigen::JacobiSVD<Mat3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 U = svd.matrixU();
    const Mat3 V = svd.matrixV();
    if ((U*V.transpose()).determinant() < 0) U.col(2) *= -1;
    return U*V.transpose();
}

Vec3 RigidTie::point(const Vector& q) const
{
    return centre(q) + rotation(q)*point_;
}

RigidTie::Six RigidTie::resultant(const Vector& q, const Vector& force) const
{
    const Vec3 c = centre(q);
    Six sum;
    for (int node : nodes_)
    {
        const Vec3 f = position(force, node);
        sum.linear += f;
        sum.angular += (position(q, node) - c).cross(f)
            + director(q, node).cross(director(force, node));
    }
    return sum;
}

void RigidTie::spread(const Vector& q, const Six& force, Vector& full) const
{
    const Vec3 c = centre(q);
    const Vec3 w = inertia(q).inverse()*force.angular;
    const Vec3 each = force.linear/double(nodes_.size());
    for (int node : nodes_)
    {
        full.segment<3>(fullIndex(node, Component::x)) +=
            each + w.cross(position(q, node) - c);
        full.segment<3>(fullIndex(node, Component::gx)) +=
            weight_*w.cross(director(q, node));
    }
}

RigidTie::Six RigidTie::rigidPart(const Vector& q, const Vector& rate) const
{
    const Vec3 c = centre(q);
    Six motion;
    Vec3 sum = Vec3::Zero();
    for (int node : nodes_)
    {
        sum += (position(q, node) - c).cross(position(rate, node))
            + weight_*director(q, node).cross(director(rate, node));
    }
    motion.linear = centre(rate);
    motion.angular = inertia(q).inverse()*sum;
    return motion;
}

void RigidTie::move(const Vector& before, const Six& motion, Vector& q) const
{
    const Vec3 c = centre(before);
    const double angle = motion.angular.norm();
    const Mat3 turn = angle > 0
        ? Eigen::AngleAxisd(angle, motion.angular/angle).toRotationMatrix()
        : Mat3(Mat3::Identity());
    for (int node : nodes_)
    {
        q.segment<3>(fullIndex(node, Component::x)) =
            c + motion.linear + turn*(position(before, node) - c);
        q.segment<3>(fullIndex(node, Component::gx)) = turn*director(before, node);
    }
}

void RigidTie::addCentripetal
(
    const Vector& velocity,
    const Vec3& omega,
    Vector& a
) const
{
    const Vec3 c = centre(velocity);
    for (int node : nodes_)
    {
        a.segment<3>(fullIndex(node, Component::x)) +=
            omega.cross(position(velocity, node) - c);
        a.segment<3>(fullIndex(node, Component::gx)) +=
            omega.cross(director(velocity, node));
    }
}

} // namespace positionalShell
