// SPDX-License-Identifier: GPL-3.0-or-later
//
// Linear shell problems with published answers, on n x n quadrilaterals of a symmetric
// part, each split into two triangles.

#ifndef LinearProblems_hpp
#define LinearProblems_hpp

#include "LinearSolver.hpp"
#include "ShellTestModels.hpp"
#include "SurfaceTraction.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace shellTest
{

//- Element that a problem is solved with
struct ElementChoice
{
    IntegrationOptions rule;
    ElementForm form = ElementForm::displacement;
};

inline ElementChoice displacementForm(int areaPoints)
{
    return {{areaPoints, 3}, ElementForm::displacement};
}

inline ElementChoice assumedStrain(int areaPoints = 7)
{
    return {{areaPoints, 3}, ElementForm::assumedStrain};
}

inline const double pi = std::acos(-1.0);

inline Vector linearSolution(const ShellModel& model, const Vector& force)
{
    LinearSolver solver;
    solver.factoriseSymmetric(model.tangent(model.mesh().initialPositions()));
    return model.dofs().expand(solver.solve(model.dofs().reduce(force)));
}

inline Vector uniformLoad(const ShellModel& model, const Vec3& traction)
{
    Vector force = Vector::Zero(model.dofs().nFull());
    SurfaceTraction(model, "all", traction).addForce(model, force, 0, force);
    return force;
}

//- Quarter of a square plate of side 1, load D per area: deflection of its middle
inline double plate(const std::string& edge, double thickness, int n, const ElementChoice& element)
{
    const double nu = 0.3;
    const double E = 1e4;
    const double D = E*std::pow(thickness, 3)/(12*(1 - nu*nu));
    const ShellMesh mesh = rectangleMesh(n, n, Vec3::Zero(), {0.5, 0, 0}, {0, 0.5, 0});
    Constraints supports(mesh);
    supports.symmetryPlane("uMax", Axis::x).symmetryPlane("vMax", Axis::y);
    if (edge == "plate_Shard")
    {
        supports.fixed("uMin", {Component::z, Component::y, Component::gy});
        supports.fixed("vMin", {Component::z, Component::x, Component::gx});
    }
    else if (edge == "plate_Ssoft")
    {
        supports.fixed("uMin", {Component::z}).fixed("vMin", {Component::z});
    }
    else
    {
        supports.clamped("uMin").clamped("vMin");
    }
    if (edge == "plate_C_aclamped")
    {
        supports.fixed("uMin", {Component::a}).fixed("vMin", {Component::a});
    }
    const ShellModel model
    (
        mesh, {{"all", thickness, material(E, nu)}}, supports.dofMap(), element.rule, element.form
    );
    const Vector u = linearSolution(model, uniformLoad(model, {0, 0, D}));
    return u[7*mesh.nodeSet("uMaxVMax")[0] + 2];
}

inline double scordelisLo(int n, const ElementChoice& element)
{
    const auto normal = [](double u, double) -> Vec3
    {
        const double angle = 40*u*pi/180;
        return {std::sin(angle), 0, std::cos(angle)};
    };
    const ShellMesh mesh = structuredMesh
    (
        n, n, [&](double u, double v) -> Vec3 { return 25*normal(u, v) + Vec3(0, 25*v, 0); },
        normal
    );
    const DofMap dofs = Constraints(mesh)
        .fixed("vMin", {Component::x, Component::z, Component::gx, Component::gz})
        .symmetryPlane("vMax", Axis::y)
        .symmetryPlane("uMin", Axis::x)
        .dofMap();
    const ShellModel model
    (
        mesh, {{"all", 0.25, material(4.32e8, 0)}}, dofs, element.rule, element.form
    );
    const Vector u = linearSolution(model, uniformLoad(model, {0, 0, -90}));
    return -u[7*mesh.nodeSet("uMaxVMax")[0] + 2];
}

inline double hemisphere(double thickness, double load, int n, const ElementChoice& element)
{
    const auto normal = [](double u, double v) -> Vec3
    {
        const double latitude = 72*v*pi/180;
        const double longitude = 0.5*pi*u;
        return
        {
            std::cos(latitude)*std::cos(longitude), std::cos(latitude)*std::sin(longitude),
            std::sin(latitude)
        };
    };
    const ShellMesh mesh = structuredMesh
    (
        n, n, [&](double u, double v) -> Vec3 { return 10*normal(u, v); }, normal
    );
    const DofMap dofs = Constraints(mesh)
        .symmetryPlane("uMin", Axis::y)
        .symmetryPlane("uMax", Axis::x)
        .fixed("uMinVMin", {Component::z})
        .dofMap();
    const ShellModel model
    (
        mesh, {{"all", thickness, material(6.825e7, 0.3)}}, dofs, element.rule, element.form
    );
    const int A = mesh.nodeSet("uMinVMin")[0];
    const int B = mesh.nodeSet("uMaxVMin")[0];
    Vector force = Vector::Zero(dofs.nFull());
    force[7*A] = 0.5*load;
    force[7*B + 1] = -0.5*load;
    const Vector u = linearSolution(model, force);
    return 0.5*(u[7*A] - u[7*B + 1]);
}

//- Cylinder of radius 300, length 600 and thickness 3 with end diaphragms, pinched by two
//  forces of 1: displacement under one of them
inline double pinchedCylinder(int n, const ElementChoice& element)
{
    const auto normal = [](double u, double) -> Vec3
    {
        return {std::sin(0.5*pi*u), 0, std::cos(0.5*pi*u)};
    };
    const ShellMesh mesh = structuredMesh
    (
        n, n, [&](double u, double v) -> Vec3 { return 300*normal(u, v) + Vec3(0, 300*v, 0); },
        normal
    );
    const DofMap dofs = Constraints(mesh)
        .fixed("vMin", {Component::x, Component::z, Component::gx, Component::gz})
        .symmetryPlane("vMax", Axis::y)
        .symmetryPlane("uMin", Axis::x)
        .symmetryPlane("uMax", Axis::z)
        .dofMap();
    const ShellModel model
    (
        mesh, {{"all", 3, material(3e6, 0.3)}}, dofs, element.rule, element.form
    );
    const int A = mesh.nodeSet("uMinVMax")[0];
    Vector force = Vector::Zero(dofs.nFull());
    force[7*A + 2] = -0.25;
    return -linearSolution(model, force)[7*A + 2];
}

//- Cantilever of length 12 and width 1.1 twisted by a quarter turn, force on its end along
//  the axis: mean displacement of the end along it
inline double twistedBeam
(
    double thickness,
    double load,
    Component component,
    int nU,
    int nV,
    const ElementChoice& element
)
{
    const double twist = 0.5*pi/12;
    const auto across = [=](double x) -> Vec3
    {
        return {0, std::cos(twist*x), std::sin(twist*x)};
    };
    const auto position = [=](double u, double v) -> Vec3
    {
        return Vec3(12*u, 0, 0) + 1.1*(v - 0.5)*across(12*u);
    };
    const auto normal = [=](double u, double v) -> Vec3
    {
        const Vec3 turned(0, -std::sin(12*twist*u), std::cos(12*twist*u));
        const Vec3 along = Vec3(1, 0, 0) + 1.1*(v - 0.5)*twist*turned;
        return along.cross(across(12*u)).normalized();
    };
    const ShellMesh mesh = structuredMesh(nU, nV, position, normal);
    const DofMap dofs = Constraints(mesh).clamped("uMin").dofMap();
    const ShellModel model
    (
        mesh, {{"all", thickness, material(29e6, 0.22)}}, dofs, element.rule, element.form
    );
    // Consistent with a uniform line load: the mean displacement is its work
    const double weights[4] = {1.0/8, 3.0/8, 3.0/8, 1.0/8};
    Vector mean = Vector::Zero(dofs.nFull());
    const std::vector<int>& end = mesh.nodeSet("uMax");
    for (std::size_t i = 0; i + 1 < end.size(); i += 3)
    {
        for (int k = 0; k < 4; ++k)
        {
            mean[fullIndex(end[i + k], component)] += weights[k]/nV;
        }
    }
    return mean.dot(linearSolution(model, load*mean));
}

} // namespace shellTest

#endif
