// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assumed strains: what their interpolation reproduces, that it frees no motion, and
// that thin shells do not lock.

#include "AssumedInterpolation.hpp"
#include "CubicTriangle.hpp"
#include "EdgeLoad.hpp"
#include "LinearProblems.hpp"
#include "StaticSolver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

using namespace shellTest;

namespace
{

using Interpolation = AssumedInterpolation;

//- Quadratic function with coefficients that are not special
double quadratic(int which, const Eigen::Vector2d& x)
{
    const double c = 1 + which;
    return c + 2*x[0] - c*x[1] + 0.3*c*x[0]*x[0] - x[0]*x[1] + (c - 4)*x[1]*x[1];
}

Eigen::Vector2d edgeDirection(int edge)
{
    const auto& nodes = CubicTriangle::nodePoints();
    return nodes[(edge + 1)%3] - nodes[edge];
}

//- Place of an edge point: from the functions of its nodes
Eigen::Vector2d placeOf(const EdgePoint& point)
{
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    for (int k = 0; k < EdgePoint::nNodes; ++k)
    {
        x += point.N[k]*CubicTriangle::nodePoints()[point.nodes[k]];
    }
    return x;
}

Eigen::Vector2d placeOf(const TrianglePoint& p)
{
    return {p.xi1, p.xi2};
}

Eigen::Vector2d shearField(const Eigen::Vector2d& x)
{
    return {quadratic(3, x), quadratic(4, x)};
}

//- Eigenvalues of a free shell, relative to the greatest, with unknowns scaled so that
//  those of positions and thickness weigh alike
Vector scaledSpectrum(const ShellMesh& mesh, double thickness, const ElementChoice& element)
{
    const ShellModel model
    (
        mesh, {{"all", thickness, material(1, 0.3)}}, Constraints(mesh).dofMap(), element.rule,
        element.form
    );
    const Eigen::MatrixXd K = model.tangent(mesh.initialPositions());
    const Vector scale = K.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal()*K*scale.asDiagonal();
    const Vector spectrum = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
    return spectrum/spectrum.maxCoeff();
}

//- Shell of two quadrilaterals, or one triangle
ShellMesh oneTriangle(const ShellMesh& mesh)
{
    std::vector<Vec3> nodes;
    Triangle triangle;
    for (int j = 0; j < nodesPerElement; ++j)
    {
        nodes.push_back(mesh.nodes()[mesh.triangle(0)[j]]);
        triangle[j] = j;
    }
    return ShellMesh(nodes, {triangle});
}

} // namespace

// Any quadratic strain is reproduced: the space is complete and the values are those of
// the space
TEST(AssumedInterpolation, reproducesQuadraticStrains)
{
    for (int nPoints : {6, 7, 12})
    {
        const auto& rule = triangleRule(nPoints);
        const Interpolation table = assumedInterpolation(rule);
        ASSERT_EQ(table.points.size(), rule.size());
        for (std::size_t p = 0; p < rule.size(); ++p)
        {
            const Interpolation::AtPoint& at = table.points[p];
            for (int c = 0; c < 3; ++c)
            {
                double value = 0;
                for (int k = 0; k < 3; ++k)
                {
                    const EdgePoint& edge = table.edge[3*c + k];
                    value += at.membraneEdge[c][k]*quadratic(c, placeOf(edge));
                    for (std::size_t q = 0; q < rule.size(); ++q)
                    {
                        value += at.membraneMoment[c][k]*table.points[q].moment[k]
                            *quadratic(c, placeOf(rule[q]));
                    }
                }
                EXPECT_NEAR(value, quadratic(c, placeOf(rule[p])), 1e-13);
            }
            for (int d = 0; d < 2; ++d)
            {
                double value = 0;
                for (int s = 0; s < Interpolation::nEdgePoints; ++s)
                {
                    value += at.shearEdge[d][s]
                        *edgeDirection(s/3).dot(shearField(placeOf(table.edge[s])));
                }
                for (std::size_t q = 0; q < rule.size(); ++q)
                {
                    const double* l = table.points[q].moment;
                    const Eigen::Vector2d g = shearField(placeOf(rule[q]));
                    value += at.shearMoment[d][0]*l[0]*g[0] + at.shearMoment[d][1]*l[0]*g[1]
                        + at.shearMoment[d][2]*(l[1]*g[0] + l[2]*g[1]);
                }
                EXPECT_NEAR(value, shearField(placeOf(rule[p]))[d], 1e-13);
            }
        }
    }
}

// What is tied along an edge depends on that edge's nodes alone, so that two elements
// agree on it
TEST(AssumedInterpolation, edgesAreTiedByTheirOwnNodes)
{
    const Interpolation table = assumedInterpolation(triangleRule(7));
    for (int s = 0; s < Interpolation::nEdgePoints; ++s)
    {
        const EdgePoint& point = table.edge[s];
        const Eigen::Vector2d x = placeOf(point);
        const auto N = CubicTriangle::values(x[0], x[1]);
        const auto dN = CubicTriangle::gradients(x[0], x[1]);
        const Vector along = dN*edgeDirection(s/3);
        double others = 0;
        for (int j = 0; j < nodesPerElement; ++j) others += std::abs(N[j]) + std::abs(along[j]);
        for (int k = 0; k < EdgePoint::nNodes; ++k)
        {
            const int j = point.nodes[k];
            EXPECT_NEAR(point.N[k], N[j], 1e-14);
            EXPECT_NEAR(point.dN[k], along[j], 1e-13);
            others -= std::abs(N[j]) + std::abs(along[j]);
        }
        EXPECT_NEAR(others, 0, 1e-13);
    }
}

// Six rigid motions and nothing else, single elements and a patch, flat and curved, thick
// and thin. The next eigenvalue is that of bending, which falls with the square of the
// thickness.
TEST(AssumedStrain, onlyRigidMotionsHaveNoEnergy)
{
    const ShellMesh flat = rectangleMesh(2, 1, Vec3::Zero(), {1, 0, 0}, {0.2, 0.6, 0});
    const ShellMesh meshes[] = {oneTriangle(flat), oneTriangle(curvedPatch()), flat, curvedPatch()};
    for (const ShellMesh& mesh : meshes)
    {
        for (int points : {6, 7, 12})
        {
            for (double h : {0.1, 0.01})
            {
                const Vector s = scaledSpectrum(mesh, h, assumedStrain(points));
                EXPECT_LT(s.head<6>().cwiseAbs().maxCoeff(), 1e-13);
                EXPECT_GT(s[6], 1e-3*h*h) << points << " points, thickness " << h;
                const Vector d = scaledSpectrum(mesh, h, displacementForm(points));
                EXPECT_GT(s[6], 0.3*d[6]) << points << " points, thickness " << h;
            }
        }
    }
}

// Hemisphere with a hole, radius over thickness 2500: 42 % of the answer for the
// displacement form with 12 points on 8 quadrilaterals a side.
// source: 0.0930 Ko, Lee and Bathe (2017); 0.0915 to 0.0917 is what both this element and
// quadratic bricks converge to, so that 2 % of the lower value bounds the answer
TEST(AssumedStrain, thinHemisphereDoesNotLock)
{
    const double thin = hemisphere(0.004, 2e-3, 8, assumedStrain());
    EXPECT_NEAR(thin/0.0930, 1, 0.02);
    EXPECT_NEAR(thin/0.0916, 1, 0.002);
    EXPECT_GT(hemisphere(0.004, 2e-3, 4, assumedStrain())/0.0916, 0.98);
    EXPECT_GT(hemisphere(0.004, 2e-3, 2, assumedStrain())/0.0916, 0.93);

    // source: 0.093715, quadratic bricks 48 x 48
    EXPECT_NEAR(hemisphere(0.04, 2, 4, assumedStrain())/0.093715, 0.9954, 0.001);
    EXPECT_NEAR(hemisphere(0.04, 2, 8, assumedStrain())/0.093715, 0.9967, 0.001);
}

// The same coarse mesh serves any thickness
TEST(AssumedStrain, clampedPlateHasTheSameErrorAtEveryThickness)
{
    // source: Kirchhoff, Timoshenko and Woinowsky-Krieger (1959): 0.00126532
    const double exact[] = {0.00126743, 0.00126534, 0.00126532};
    int i = 0;
    for (double t : {1e-2, 1e-3, 1e-4})
    {
        EXPECT_NEAR(plate("plate_C", t, 2, assumedStrain())/exact[i], 1.005, 0.001) << t;
        EXPECT_NEAR(plate("plate_C", t, 4, assumedStrain())/exact[i++], 1.0005, 0.0003) << t;
    }
}

// The matrix of a plate of thickness 1e-4 of its side is conditioned as 1e11, and scaling its
// unknowns takes a factor of fifty from that. It takes nothing from the error of the solution:
// what is left is far below that of any mesh.
TEST(AssumedStrain, thinPlatesNeedNoScalingOfTheUnknowns)
{
    const double t = 1e-4;
    const ShellMesh mesh = rectangleMesh(2, 2, Vec3::Zero(), {0.5, 0, 0}, {0, 0.5, 0});
    const DofMap dofs = Constraints(mesh)
        .symmetryPlane("uMax", Axis::x)
        .symmetryPlane("vMax", Axis::y)
        .clamped("uMin")
        .clamped("vMin")
        .dofMap();
    const ShellModel model
    (
        mesh, {{"all", t, material(1e4, 0.3)}}, dofs, {}, ElementForm::assumedStrain
    );
    const SparseMatrix K = model.tangent(mesh.initialPositions());
    const Vector load = dofs.reduce(uniformLoad(model, {0, 0, t*t*t}));
    const Vector scale = K.diagonal().cwiseSqrt().cwiseInverse();

    LinearSolver plain;
    LinearSolver scaled;
    plain.factoriseSymmetric(K);
    scaled.factoriseSymmetric(SparseMatrix(scale.asDiagonal()*K*scale.asDiagonal()));
    const Vector u = plain.solve(load);
    const Vector v = scale.asDiagonal()*scaled.solve(Vector(scale.asDiagonal()*load));
    EXPECT_LT((u - v).cwiseAbs().maxCoeff(), 1e-6*u.cwiseAbs().maxCoeff());

    const Eigen::MatrixXd dense(K);
    const Vector spectrum = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
    EXPECT_GT(spectrum.maxCoeff()/spectrum.minCoeff(), 1e10);
    EXPECT_LT(spectrum.maxCoeff()/spectrum.minCoeff(), 1e12);
}

// Cantilever of thickness from 1e-2 to 1e-4 of its length under P L^2/EI = 1, ten load
// steps: the same answer, and Newton's iterations per step stay within twice
TEST(AssumedStrain, largeDeflectionsOfThinStrips)
{
    // source: elastica, Mattiasson (1981): 0.30172
    for (double h : {1e-2, 1e-3, 1e-4})
    {
        const double width = 0.1;
        const double EI = 1.2e6*width*h*h*h/12;
        const ShellMesh mesh = strip(8, 1, width);
        const ShellModel model
        (
            mesh, {{"all", h, material(1.2e6, 0)}}, Constraints(mesh).clamped("uMin").dofMap(),
            {}, ElementForm::assumedStrain
        );
        const Loads loads
        {
            std::make_shared<EdgeLoad>
            (
                model, "uMax", Vec3(0, 0, EI/width), linearInTime(0, 1)
            )
        };
        StaticSolver solver(model);
        int iterations = 0;
        const StaticStep end = solver.run
        (
            model.initialState(), 1, 10, loads,
            [&](const StaticStep& step) { iterations += step.report.iterations; }
        );
        ASSERT_TRUE(end.converged) << h << '\n' << end.report.describe();
        EXPECT_NEAR(end.state.position[7*mesh.nodeSet("uMax")[0] + 2], 0.30172, 1e-4) << h;
        EXPECT_LT(iterations, 100) << h;
    }
}
