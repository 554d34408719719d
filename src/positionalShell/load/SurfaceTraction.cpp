// SPDX-License-Identifier: GPL-3.0-or-later

#include "SurfaceTraction.hpp"
#include "CubicTriangle.hpp"
#include "Quadrature.hpp"

#include <Eigen/Geometry>

namespace positionalShell
{

namespace
{

//- Integral over the initial mid-surface of N_i times a traction that is a
//  function of the area vector X,1 x X,2
template<class Traction>
Vector integrate
(
    const ShellModel& model,
    const std::string& elementSet,
    const Traction& traction
)
{
    const ShellMesh& mesh = model.mesh();
    Vector force = Vector::Zero(model.dofs().nFull());
    for (int e : mesh.elementSet(elementSet))
    {
        const Triangle& triangle = mesh.triangle(e);
        for (const TrianglePoint& p : triangleRuleOfDegree(10))
        {
            const auto N = CubicTriangle::values(p.xi1, p.xi2);
            const auto dN = CubicTriangle::gradients(p.xi1, p.xi2);
            Vec3 x1 = Vec3::Zero();
            Vec3 x2 = Vec3::Zero();
            for (int j = 0; j < nodesPerElement; ++j)
            {
                x1 += dN(j, 0)*mesh.nodes()[triangle[j]];
                x2 += dN(j, 1)*mesh.nodes()[triangle[j]];
            }
            const Vec3 f = p.weight*traction(x1.cross(x2));
            for (int j = 0; j < nodesPerElement; ++j)
            {
                force.segment<3>(fullIndex(triangle[j], Component::x)) +=
                    N[j]*f;
            }
        }
    }
    return force;
}

} // namespace

SurfaceTraction::SurfaceTraction
(
    const ShellModel& model,
    const std::string& elementSet,
    const Vec3& traction,
    TimeFunctionPtr factor
)
:
    unitForce_
    (
        integrate
        (
            model, elementSet,
            [&](const Vec3& area) -> Vec3 { return area.norm()*traction; }
        )
    ),
    factor_(std::move(factor))
{}

SurfaceTraction::SurfaceTraction(Vector unitForce, TimeFunctionPtr factor)
:
    unitForce_(std::move(unitForce)),
    factor_(std::move(factor))
{}

LoadPtr SurfaceTraction::deadPressure
(
    const ShellModel& model,
    const std::string& elementSet,
    double pressure,
    TimeFunctionPtr factor
)
{
    Vector force = integrate
    (
        model, elementSet,
        [&](const Vec3& area) -> Vec3 { return -pressure*area; }
    );
    return LoadPtr
    (
        new SurfaceTraction(std::move(force), std::move(factor))
    );
}

void SurfaceTraction::addForce
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
