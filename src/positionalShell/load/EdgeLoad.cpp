// SPDX-License-Identifier: GPL-3.0-or-later

#include "EdgeLoad.hpp"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"

#include <stdexcept>

namespace positionalShell
{

namespace
{

//- Integral of the four functions of an edge over its initial length
Eigen::Vector4d lengthWeights(const ShellMesh& mesh, const CubicEdge& edge)
{
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();
    for (const LinePoint& p : gaussRule(8))
    {
        const double s = 0.5*(1 + p.xi);
        const Eigen::Vector4d dN = CubicTriangle::edgeDerivatives(s);
        Vec3 tangent = Vec3::Zero();
        for (int i = 0; i < 4; ++i) tangent += dN[i]*mesh.nodes()[edge[i]];
        weights += 0.5*p.weight*tangent.norm()*CubicTriangle::edgeValues(s);
    }
    return weights;
}

} // namespace

EdgeLoad::EdgeLoad
(
    const ShellModel& model,
    const std::string& nodeSet,
    const Vec3& forcePerLength,
    TimeFunctionPtr factor,
    const Vec3& directorForcePerLength
)
:
    unitForce_(Vector::Zero(model.dofs().nFull())),
    factor_(std::move(factor))
{
    const std::vector<CubicEdge> edges = model.mesh().edgesOf(nodeSet);
    if (edges.empty())
    {
        throw std::invalid_argument
        (
            "edge load: node set " + nodeSet
          + " contains no whole edge of an element"
        );
    }
    for (const CubicEdge& edge : edges)
    {
        const Eigen::Vector4d weights = lengthWeights(model.mesh(), edge);
        for (int i = 0; i < 4; ++i)
        {
            unitForce_.segment<3>(fullIndex(edge[i], Component::x)) +=
                weights[i]*forcePerLength;
            unitForce_.segment<3>(fullIndex(edge[i], Component::gx)) +=
                weights[i]*directorForcePerLength;
        }
    }
}

void EdgeLoad::addForce
(
    const ShellModel&,
    const Vector&,
    double time,
    Vector& force
) const
{
    force += factor_->value(time)*unitForce_;
}

} // namespace positionalShell
