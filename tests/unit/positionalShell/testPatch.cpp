// SPDX-License-Identifier: GPL-3.0-or-later
//
// Patch tests: states of constant strain or curvature that the element must hold
// exactly on a distorted mesh.

#include "CubicTriangle.hpp"
#include "LinearSolver.hpp"
#include "ShellTestModels.hpp"
#include "StaticSolver.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shellTest;

namespace
{

constexpr double E = 200;
constexpr double nu = 0.3;
constexpr double h = 0.05;

//- Unit square of 2 x 2 quadrilaterals, its middle corner moved and the elements
//  straight-sided; curved: inner edge nodes moved as well
ShellMesh distortedSquare(bool curved)
{
    const ShellMesh regular = rectangleMesh(2, 2, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    std::vector<Vec3> nodes = regular.nodes();
    nodes[regular.nearestNode({0.5, 0.5, 0})] += Vec3(0.13, -0.09, 0);
    for (const Triangle& t : regular.triangles())
    {
        for (int j = 3; j < nodesPerElement; ++j)
        {
            const auto& xi = CubicTriangle::nodePoints()[j];
            nodes[t[j]] = nodes[t[0]] + xi[0]*(nodes[t[1]] - nodes[t[0]])
                + xi[1]*(nodes[t[2]] - nodes[t[0]]);
        }
    }
    for (std::size_t i = 0; curved && i < nodes.size(); ++i)
    {
        const Vec3& x = nodes[i];
        const double bubble = x[0]*(1 - x[0])*x[1]*(1 - x[1]);
        nodes[i] += bubble*Vec3(0.3*std::sin(7*double(i)), 0.3*std::cos(5*double(i)), 0);
    }
    ShellMesh mesh(nodes, regular.triangles(), regular.nodeSets());
    std::vector<int> rim;
    for (const char* edge : {"uMin", "uMax", "vMin", "vMax"})
    {
        const auto& nodesOfEdge = mesh.nodeSet(edge);
        rim.insert(rim.end(), nodesOfEdge.begin(), nodesOfEdge.end());
    }
    mesh.addNodeSet("rim", rim);
    return mesh;
}

class Patch : public testing::TestWithParam<ElementForm>
{};

const auto allForms = testing::Values(ElementForm::displacement, ElementForm::assumedStrain);

INSTANTIATE_TEST_SUITE_P
(
    Forms, Patch, allForms,
    [](const auto& form) { return elementFormName(form.param); }
);

//- Greatest error of the unknowns when the rim of the square is driven to a finite
//  stretch and shear in its plane; the inner nodes, all directors and the thickness are
//  to find the state of plane stress
double membraneError(const ShellMesh& mesh, ElementForm form)
{
    Eigen::Matrix2d F;
    F << 1.1, 0.07, -0.02, 0.95;
    const Eigen::Matrix2d strain = 0.5*(F.transpose()*F - Eigen::Matrix2d::Identity());

    // One function of time per driven unknown
    ShellMesh named = mesh;
    for (int node : mesh.nodeSet("rim")) named.addNodeSet("n" + std::to_string(node), {node});
    Constraints constraints(named);
    for (int node : mesh.nodeSet("rim"))
    {
        const std::string set = "n" + std::to_string(node);
        const Vec3& X = mesh.nodes()[node];
        const Eigen::Vector2d u = F*X.head<2>() - X.head<2>();
        constraints.prescribed(set, Component::x, linearInTime(0, u[0]));
        constraints.prescribed(set, Component::y, linearInTime(0, u[1]));
        constraints.fixed(set, {Component::z});
    }
    const ShellModel model
    (
        named, {{"all", h, material(E, nu)}}, constraints.dofMap(), {}, form
    );
    NewtonOptions tight;
    tight.residualTolerance = 1e-12;
    StaticSolver solver(model, tight);
    const StaticStep end = solver.run(model.initialState(), 1, 2, {});
    EXPECT_TRUE(end.converged) << end.report.describe();

    // S33 = 0: E33 = -nu/(1-nu) (E11 + E22), and |g| is the stretch across
    const double E33 = -nu/(1 - nu)*strain.trace();
    const double stretch = std::sqrt(1 + 2*E33);
    double worst = 0;
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const Eigen::Vector2d x = F*mesh.nodes()[i].head<2>();
        const auto q = end.state.position.segment<7>(7*i);
        Eigen::Matrix<double, 7, 1> exact;
        exact << x[0], x[1], 0, 0, 0, stretch, 0;
        worst = std::max(worst, (q - exact).cwiseAbs().maxCoeff());
    }

    // Plane-stress energy of the exact state
    const double factor = E/(1 - nu*nu);
    const double W = 0.5*factor
       *(
            (1 - nu)*strain.squaredNorm() + nu*strain.trace()*strain.trace()
        );
    const double energy = model.strainEnergy(end.state.position)/(W*h);
    return std::max(worst, std::abs(energy - 1));
}

} // namespace

TEST_P(Patch, constantMembraneStrain)
{
    EXPECT_LT(membraneError(distortedSquare(false), GetParam()), 1e-12);
}

// Elements with curved sides: exact for the displacement form only. The assumed strains
// are quadratic, the covariant components of a constant strain there are not.
TEST(CurvedSides, constantMembraneStrain)
{
    const ShellMesh mesh = distortedSquare(true);
    EXPECT_LT(membraneError(mesh, ElementForm::displacement), 1e-12);
    const double error = membraneError(mesh, ElementForm::assumedStrain);
    EXPECT_LT(error, 2e-3);
    EXPECT_GT(error, 1e-6);
}

// Small constant curvatures (bending both ways and twist): the exact 3D solution is
// u_alpha = -z k_ab x_b, w = k_ab x_a x_b/2 + nu/(2(1-nu)) tr(k) z^2, so that
// a = nu h/(4(1-nu)) tr(k): the element must hold it, with plate moments
void checkConstantCurvature(ElementForm form, double nu)
{
    const ShellMesh mesh = distortedSquare(false);
    Eigen::Matrix2d k;
    k << 0.8, 0.3, 0.3, -0.2;
    const double a = nu*h/(4*(1 - nu))*k.trace();

    Vector exact = Vector::Zero(7*mesh.nNodes());
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const Eigen::Vector2d X = mesh.nodes()[i].head<2>();
        const Eigen::Vector2d slope = k*X;
        exact[7*i + 2] = 0.5*X.dot(slope);
        exact.segment<2>(7*i + 3) = -slope;
        exact[7*i + 6] = a;
    }

    // Linear problem: known values at the rim go to the right-hand side
    const std::vector<Section> sections{{"all", h, material(E, nu)}};
    const ShellModel whole(mesh, sections, Constraints(mesh).dofMap(), {}, form);
    const DofMap inner = Constraints(mesh).clamped("rim").dofMap();
    const SparseMatrix K = whole.tangent(mesh.initialPositions());
    Vector known = exact;
    for (int i = 0; i < inner.nFull(); ++i)
    {
        if (inner.equation(i) >= 0) known[i] = 0;
    }
    const ShellModel model(mesh, sections, inner, {}, form);
    LinearSolver solver;
    solver.factoriseSymmetric(model.tangent(mesh.initialPositions()));
    const Vector u =
        known + inner.expand(solver.solve(Vector(inner.reduce(-(K*known)))));
    EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-11);

    // Energy of Kirchhoff's plate: the bending stiffness is D, not D (1-nu)^2/(1-2nu)
    const double D = E*h*h*h/(12*(1 - nu*nu));
    const double energy = 0.5*D*((1 - nu)*k.squaredNorm() + nu*k.trace()*k.trace());
    EXPECT_NEAR(0.5*u.dot(K*u), energy, 1e-10*energy);
}

// Full 3D law, no thickness locking: exact near the incompressible limit too
TEST_P(Patch, constantCurvature)
{
    checkConstantCurvature(GetParam(), 0);
    checkConstantCurvature(GetParam(), 0.3);
    checkConstantCurvature(GetParam(), 0.49);
}

// The detector of a missing linear thickness strain: with a held at zero, bending is
// stiffer by (1-nu)^2/(1-2nu), 1.225 here
TEST_P(Patch, withoutThicknessStrainBendingLocks)
{
    const ShellMesh mesh = distortedSquare(false);
    const ShellModel model
    (
        mesh, {{"all", h, material(E, nu)}}, Constraints(mesh).dofMap(), {}, GetParam()
    );
    const SparseMatrix K = model.tangent(mesh.initialPositions());
    Vector u = Vector::Zero(7*mesh.nNodes());
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const double x = mesh.nodes()[i][0];
        u[7*i + 2] = 0.5*x*x;
        u[7*i + 3] = -x;
    }
    const double D = E*h*h*h/(12*(1 - nu*nu));
    EXPECT_NEAR(0.5*u.dot(K*u)/(0.5*D), (1 - nu)*(1 - nu)/(1 - 2*nu), 1e-10);
}
