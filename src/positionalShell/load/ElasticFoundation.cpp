// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElasticFoundation.hpp"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"

#include <Eigen/Geometry>

#include <stdexcept>

namespace positionalShell
{

ElasticFoundation::ElasticFoundation
(
    const ShellModel& model,
    const std::string& elementSet,
    double stiffness,
    const Vec3& direction,
    TimeFunctionPtr factor
)
:
    elements_(model.mesh().elementSet(elementSet)),
    factor_(std::move(factor))
{
    if (!(stiffness > 0))
    {
        throw std::invalid_argument
        (
            "stiffness of an elastic foundation is " + std::to_string(stiffness)
          + " N/m3, but must be positive"
        );
    }
    stiffness_ = stiffness*Eigen::Matrix3d::Identity();
    if (direction.norm() > 0)
    {
        const Vec3 d = direction.normalized();
        stiffness_ = stiffness*d*d.transpose();
    }

    for (int e : elements_)
    {
        const Triangle& triangle = model.mesh().triangle(e);
        ElementMass M = ElementMass::Zero();
        for (const TrianglePoint& p : triangleRuleOfDegree(10))
        {
            const auto N = CubicTriangle::values(p.xi1, p.xi2);
            const auto dN = CubicTriangle::gradients(p.xi1, p.xi2);
            Vec3 x1 = Vec3::Zero();
            Vec3 x2 = Vec3::Zero();
            for (int j = 0; j < nodesPerElement; ++j)
            {
                x1 += dN(j, 0)*model.mesh().nodes()[triangle[j]];
                x2 += dN(j, 1)*model.mesh().nodes()[triangle[j]];
            }
            const double dA = p.weight*x1.cross(x2).norm();
            for (int i = 0; i < nodesPerElement; ++i)
            {
                for (int j = 0; j < nodesPerElement; ++j)
                {
                    M(i, j) += dA*N[i]*N[j];
                }
            }
        }
        integrals_.push_back(M);
    }
}

void ElasticFoundation::addForce
(
    const ShellModel& model,
    const Vector& q,
    double time,
    Vector& force
) const
{
    const double factor = factor_->value(time);
    for (std::size_t n = 0; n < elements_.size(); ++n)
    {
        const Triangle& triangle = model.mesh().triangle(elements_[n]);
        Eigen::Matrix<double, 3, nodesPerElement> u;
        for (int j = 0; j < nodesPerElement; ++j)
        {
            u.col(j) =
                q.segment<3>(fullIndex(triangle[j], Component::x))
              - model.mesh().nodes()[triangle[j]];
        }
        const Eigen::Matrix<double, 3, nodesPerElement> f =
            -factor*stiffness_*u*integrals_[n];
        for (int j = 0; j < nodesPerElement; ++j)
        {
            force.segment<3>(fullIndex(triangle[j], Component::x)) += f.col(j);
        }
    }
}

void ElasticFoundation::addTangent
(
    const ShellModel&,
    const Vector&,
    double time,
    double factor,
    SystemMatrix& K
) const
{
    const Eigen::Matrix3d k = factor*factor_->value(time)*stiffness_;
    for (std::size_t n = 0; n < elements_.size(); ++n)
    {
        for (int i = 0; i < nodesPerElement; ++i)
        {
            for (int j = 0; j <= i; ++j)
            {
                for (int r = 0; r < 3; ++r)
                {
                    // The diagonal block's lower triangle stands for both
                    for (int c = 0; c < (i == j ? r + 1 : 3); ++c)
                    {
                        K.addSymmetricEntry
                        (
                            elements_[n], dofsPerNode*i + r, dofsPerNode*j + c,
                            integrals_[n](i, j)*k(r, c)
                        );
                    }
                }
            }
        }
    }
}

} // namespace positionalShell
