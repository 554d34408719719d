// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strains, stresses and section forces against closed forms, for both forms of the
// element.

#include "LinearProblems.hpp"
#include "Orthotropic.hpp"
#include "ShellResults.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

using namespace shellTest;

namespace
{

class Results : public testing::TestWithParam<ElementForm>
{};

INSTANTIATE_TEST_SUITE_P
(
    Forms, Results,
    testing::Values(ElementForm::displacement, ElementForm::assumedStrain),
    [](const auto& form) { return elementFormName(form.param); }
);

Mat3 tensorOf(const SymmTensor& v)
{
    Mat3 T;
    T << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
    return T;
}

//- x = A X for position and director of every node
Vector homogeneous(const ShellMesh& mesh, const Mat3& A)
{
    Vector q = mesh.initialPositions();
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        q.segment<3>(7*i) = A*Vec3(q.segment<3>(7*i));
        q.segment<3>(7*i + 3) = A*Vec3(q.segment<3>(7*i + 3));
    }
    return q;
}

Mat3 finiteStrain()
{
    Mat3 A;
    A << 1.1, 0.2, 0.05, -0.1, 0.9, 0.1, 0.3, 0.1, 0.95;
    return A;
}

Mat3 isotropicStress(const Mat3& E, double youngs, double nu)
{
    const double lambda = youngs*nu/((1 + nu)*(1 - 2*nu));
    return lambda*E.trace()*Mat3::Identity() + youngs/(1 + nu)*E;
}

} // namespace

// A doubly curved shell turned as a rigid body has neither strain nor stress
TEST_P(Results, vanishForRigidMotions)
{
    const ShellMesh mesh = curvedPatch();
    const ShellModel model
    (
        mesh, {{"all", 0.1, material(3, 0.3)}}, Constraints(mesh).dofMap(), {}, GetParam()
    );
    const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const ShellResults results(model);
    for (const PointResult& r : results.at(homogeneous(mesh, turn)))
    {
        for (const HeightResult& h : r.height)
        {
            EXPECT_LT(h.strain.norm(), 1e-12);
            EXPECT_LT(h.cauchy.norm(), 1e-12);
        }
        EXPECT_LT(r.section.N.norm() + r.section.Q.norm(), 1e-12);
    }
    for (const PointResult& r : results.at(mesh.initialPositions()))
    {
        for (const HeightResult& h : r.height) EXPECT_EQ(h.strain.norm(), 0);
    }
}

// Finite stretch, shear and rotation of a flat patch that is oblique in space
TEST_P(Results, areExactForHomogeneousStrain)
{
    const Vec3 side1(1, 0.2, 0.1);
    const Vec3 side2(-0.1, 0.7, 0.2);
    const ShellMesh mesh = rectangleMesh(2, 1, Vec3(1, 2, 3), side1, side2);
    const double h = 0.2;
    const double E = 70;
    const double nu = 0.3;
    const ShellModel model
    (
        mesh, {{"all", h, material(E, nu)}}, Constraints(mesh).dofMap(), {}, GetParam()
    );
    const Mat3 A = finiteStrain();
    const Mat3 strain = 0.5*(A.transpose()*A - Mat3::Identity());
    const Mat3 S = isotropicStress(strain, E, nu);
    const Mat3 cauchy = A*S*A.transpose()/A.determinant();
    const Mat3 deviator = cauchy - cauchy.trace()/3*Mat3::Identity();

    // Axis 1 is the projection of x
    const Vec3 n = side1.cross(side2).normalized();
    const Vec3 n1 = (Vec3::UnitX() - n*n[0]).normalized();
    const Vec3 normals[2] = {n1, n.cross(n1)};
    for (const PointResult& r : ShellResults(model).at(homogeneous(mesh, A)))
    {
        for (const HeightResult& z : r.height)
        {
            EXPECT_LT((tensorOf(z.strain) - strain).norm(), 1e-13);
            EXPECT_LT((tensorOf(z.secondPiola) - S).norm(), 1e-11);
            EXPECT_LT((tensorOf(z.cauchy) - cauchy).norm(), 1e-11);
            EXPECT_NEAR(z.vonMises(), std::sqrt(1.5)*deviator.norm(), 1e-11);
        }
        const Vec3 axis2 = r.axis3.cross(r.axis1);
        EXPECT_LT((r.axis3 - (A*n).normalized()).norm(), 1e-13);
        EXPECT_NEAR
        (
            (A*normals[0]).dot(axis2), (A*normals[1]).dot(r.axis1), 1e-13
        );
        for (int a = 0; a < 2; ++a)
        {
            // First Piola-Kirchhoff traction on the section
            const Vec3 force = h*(A*S*normals[a]);
            EXPECT_NEAR(r.section.N(a, 0), force.dot(r.axis1), 1e-11);
            EXPECT_NEAR(r.section.N(a, 1), force.dot(axis2), 1e-11);
            EXPECT_NEAR(r.section.Q[a], force.dot(r.axis3), 1e-11);
        }
        EXPECT_LT(r.section.M.norm(), 1e-11);
    }
}

// Section forces are the derivatives of the energy by the gradient of the mid-surface:
// found from the energy alone, in a state with shear across
TEST_P(Results, sectionForcesAreDerivativesOfTheEnergy)
{
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {1, 0, 0}, {0, 0.5, 0});
    const ShellModel model
    (
        mesh, {{"all", 0.2, material(50, 0.3)}}, Constraints(mesh).dofMap(), {}, GetParam()
    );
    const Vector q = homogeneous(mesh, finiteStrain());
    const PointResult r = ShellResults(model).at(q)[4];
    const Vec3 axes[3] = {r.axis1, r.axis3.cross(r.axis1), r.axis3};
    for (int a = 0; a < 2; ++a)
    {
        for (int b = 0; b < 3; ++b)
        {
            Vector direction = Vector::Zero(q.size());
            for (int i = 0; i < mesh.nNodes(); ++i)
            {
                direction.segment<3>(7*i) = mesh.nodes()[i][a]*axes[b];
            }
            const double rate = polynomialDerivative<double>
            (
                [&](double s) { return model.strainEnergy(q + s*direction); }
            );
            const double expected = b < 2 ? r.section.N(a, b) : r.section.Q[a];
            EXPECT_NEAR(rate, 0.5*expected, 1e-11) << a << b;
        }
    }
}

// A strip rolled up to 1.2 of a full turn: strains, and moments and forces of the section
// with all terms in h/R. Fibres on the upper face, inside the roll, are shortened
TEST_P(Results, rolledStripAtLargeRotation)
{
    const double length = 12;
    const double h = 0.1;
    const double E = 1.2e6;
    const double k = 1.2*2*pi/length;
    const ShellMesh mesh = strip(24, length);
    const ShellModel model
    (
        mesh, {{"all", h, material(E, 0)}}, Constraints(mesh).dofMap(), {}, GetParam()
    );
    Vector q = mesh.initialPositions();
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const double angle = k*mesh.nodes()[i][0];
        q[7*i] = std::sin(angle)/k;
        q[7*i + 2] = (1 - std::cos(angle))/k;
        q[7*i + 3] = -std::sin(angle);
        q[7*i + 5] = std::cos(angle);
    }
    const double M = -E*(k*std::pow(h, 3)/12 + std::pow(k, 3)*std::pow(h, 5)/160);
    const double N = E*k*k*std::pow(h, 3)/8;
    const double upper = 0.5*(std::pow(1 - 0.5*k*h, 2) - 1);
    const double lower = 0.5*(std::pow(1 + 0.5*k*h, 2) - 1);
    const std::vector<PointResult> results = ShellResults(model).at(q);
    double mean = 0;
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const PointResult& r = results[i];
        EXPECT_NEAR(r.at(Height::upper).strain[0], upper, 0.01*lower);
        EXPECT_NEAR(r.at(Height::lower).strain[0], lower, 0.01*lower);
        EXPECT_NEAR(r.at(Height::lower).secondPiola[0], E*lower, 0.012*E*lower);
        EXPECT_NEAR(r.section.M(0, 0), M, 0.005*std::abs(M));
        mean += r.section.N(0, 0)/mesh.nNodes();

        const double angle = k*mesh.nodes()[i][0];
        const Vec3 tangent(std::cos(angle), 0, std::sin(angle));
        EXPECT_LT((r.axis1 - tangent).norm(), 1e-6);

        // Uniaxial: von Mises is the Cauchy stress along the strip, S stretch^2 over
        // the volume ratio, which is the stretch
        const double stretch = 1 + 0.5*k*h;
        EXPECT_NEAR
        (
            r.at(Height::lower).vonMises(), E*lower*stretch, 0.012*E*lower
        );
    }
    EXPECT_NEAR(mean, N, 0.05*N);
}

// Clamped square plate under pressure, thin
// source: Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, Table 35 (nu 0.3):
// moments 0.0231 q a^2 in the middle, -0.0513 q a^2 at the middle of an edge
TEST_P(Results, momentsOfAClampedPlate)
{
    const double t = 0.01;
    const ShellMesh mesh = rectangleMesh(8, 8, Vec3::Zero(), {0.5, 0, 0}, {0, 0.5, 0});
    const ShellModel model
    (
        mesh, {{"all", t, material(1e7, 0.3)}},
        Constraints(mesh)
            .symmetryPlane("uMin", Axis::x).symmetryPlane("vMin", Axis::y)
            .clamped("uMax").clamped("vMax").dofMap(),
        {}, GetParam()
    );
    const double load = 1e-6;
    const Vector q = mesh.initialPositions()
        + linearSolution(model, uniformLoad(model, {0, 0, load}));
    const std::vector<PointResult> results = ShellResults(model).at(q);
    const PointResult& middle = results[mesh.nearestNode({0, 0, 0})];
    const PointResult& edge = results[mesh.nearestNode({0.5, 0, 0})];
    EXPECT_NEAR(middle.section.M(0, 0)/load, 0.0231, 0.0231*0.02);
    EXPECT_NEAR(middle.section.M(1, 1)/load, 0.0231, 0.0231*0.02);
    EXPECT_NEAR(edge.section.M(0, 0)/load, -0.0513, 0.0513*0.02);
    EXPECT_NEAR(edge.section.M(1, 1)/load, -0.3*0.0513, 0.3*0.0513*0.04);

    // Stress of the faces is that of the moment
    const double face = 6*middle.section.M(0, 0)/(t*t);
    EXPECT_NEAR(middle.at(Height::upper).cauchy[0], face, 0.02*std::abs(face));
    EXPECT_NEAR(middle.at(Height::lower).cauchy[0], -face, 0.02*std::abs(face));
    EXPECT_LT(std::abs(middle.at(Height::upper).cauchy[2]), 0.05*std::abs(face));
}

// Direction 1 of a section is that of its material; of others the given axis, or another
// where the shell is normal to it
TEST(SectionAxes, followMaterialOrGivenAxis)
{
    const double angle = 0.5;
    const ShellMesh mesh = rectangleMesh(1, 1, Vec3::Zero(), {0, 1, 0}, {0, 0, 1});
    const Section isotropic{"all", 0.1, material(3, 0.3)};
    Section orthotropic
    {
        "all", 0.1,
        std::make_shared<Orthotropic>
        (
            OrthotropicConstants{3, 2, 2, 0.1, 0.1, 0.1, 1, 1, 1}, 1
        )
    };
    orthotropic.axis = Vec3(0.3, 1, 0);
    orthotropic.angle = angle;
    const auto axis = [&](const Section& section, const Vec3& given)
    {
        const ShellModel model(mesh, {section}, Constraints(mesh).dofMap());
        ResultOptions options;
        options.axis = given;
        return ShellResults(model, options).at(mesh.initialPositions())[0].axis1;
    };
    EXPECT_LT((axis(isotropic, Vec3(1, 0, 0)) - Vec3(0, 1, 0)).norm(), 1e-14);
    EXPECT_LT((axis(isotropic, Vec3(1, 0, 2)) - Vec3(0, 0, 1)).norm(), 1e-14);
    EXPECT_LT
    (
        (axis(orthotropic, Vec3(0, 0, 1)) - Vec3(0, std::cos(angle), std::sin(angle))).norm(),
        1e-14
    );
}

// Two plates that meet at a right angle along x = 1, one of two thicknesses: results jump
// at the fold and between the sections, and nowhere else
TEST(ResultPoints, partsEndAtFoldsAndSections)
{
    const ShellMesh mesh = structuredMesh
    (
        4, 1,
        [](double u, double v) -> Vec3
        {
            return {std::min(2*u, 1.0), v, std::max(2*u - 1, 0.0)};
        },
        [](double u, double) -> Vec3
        {
            return Vec3(u > 0.49 ? -1 : 0, 0, u < 0.51 ? 1 : 0).normalized();
        }
    );
    ShellMesh named = mesh;
    named.addElementSet("thick", {0, 1});
    named.addElementSet("thin", {2, 3, 4, 5, 6, 7});
    const ShellModel model
    (
        named, {{"thick", 0.02, material(3, 0)}, {"thin", 0.01, material(3, 0)}},
        Constraints(named).dofMap()
    );
    const ResultPoints points(model, 0.35);
    ASSERT_EQ(points.size(), mesh.nNodes() + 8);
    for (int p = 0; p < mesh.nNodes(); ++p) EXPECT_EQ(points.node(p), p);
    for (int p = mesh.nNodes(); p < points.size(); ++p)
    {
        const double x = mesh.nodes()[points.node(p)][0];
        EXPECT_TRUE(std::abs(x - 0.5) < 1e-12 || std::abs(x - 1) < 1e-12) << x;
    }
    for (int e = 0; e < mesh.nElements(); ++e)
    {
        for (int j = 0; j < nodesPerElement; ++j)
        {
            EXPECT_EQ(points.node(points.ofElement(e)[j]), mesh.triangle(e)[j]);
        }
    }

    // The fold: stress of one side is not that of the other. One plate is stretched
    Vector q = mesh.initialPositions();
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        q[7*i] += 0.01*std::min(mesh.nodes()[i][0] - 1, 0.0);
    }
    const std::vector<PointResult> results = ShellResults(model).at(q);
    const int node = mesh.nearestNode({1, 0, 0});
    int other = -1;
    for (int p = mesh.nNodes(); p < points.size(); ++p)
    {
        if (points.node(p) == node) other = p;
    }
    ASSERT_GE(other, 0);
    EXPECT_NEAR(results[node].at(Height::middle).strain[0], 0.01005, 1e-9);
    EXPECT_LT(std::abs(results[other].at(Height::middle).strain[0]), 1e-9);
}

TEST(ShellResults, rejectsWrongOptions)
{
    const ShellMesh mesh = strip(1, 1);
    const ShellModel model(mesh, {{"all", 0.1, material(3, 0)}}, Constraints(mesh).dofMap());
    const auto with = [&](const Vec3& axis, double fold)
    {
        ResultOptions options;
        options.axis = axis;
        options.foldAngle = fold;
        return errorOf([&] { ShellResults(model, options); });
    };
    EXPECT_EQ(with(Vec3::Zero(), 0.3), "results: the axis is zero");
    EXPECT_NE(with(Vec3::UnitX(), 0).find("fold angle"), std::string::npos);
    EXPECT_EQ(with(Vec3::UnitX(), 0.3), "no error");
}
