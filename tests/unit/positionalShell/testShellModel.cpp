// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energy, force and tangent against each other and against what any elastic body
// obeys; mass.

#include "ShellTestModels.hpp"

#include "AssumedInterpolation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace shellTest;

namespace
{

constexpr double thickness = 0.1;

std::unique_ptr<ShellModel> curvedModel
(
    MaterialPtr m,
    ElementForm form = ElementForm::displacement,
    IntegrationOptions rule = {}
)
{
    const ShellMesh mesh = curvedPatch();
    return std::make_unique<ShellModel>
    (
        mesh, std::vector<Section>{{"all", thickness, m}}, Constraints(mesh).dofMap(), rule, form
    );
}

//- What must hold for every element form
class ElementForms : public testing::TestWithParam<ElementForm>
{};

const auto allForms = testing::Values(ElementForm::displacement, ElementForm::assumedStrain);

std::string formName(const testing::TestParamInfo<ElementForm>& form)
{
    return elementFormName(form.param);
}

INSTANTIATE_TEST_SUITE_P(ShellModel, ElementForms, allForms, formName);

void checkForceAndTangent(const ShellModel& model, int seed)
{
    const Vector q = randomState(model.mesh(), 0.05, seed);
    const Vector d = randomVector(q.size(), 1000 + seed);
    const Vector f = model.internalForce(q);
    const double dU = polynomialDerivative<double>
    (
        [&](double s) { return model.strainEnergy(q + s*d); }
    );
    // Round-off: the stencil adds energies that grow as the eighth power of the step
    EXPECT_NEAR(dU, f.dot(d), 1e-10*f.norm()*d.norm()) << "seed " << seed;

    const Vector df = polynomialDerivative<Vector>
    (
        [&](double s) -> Vector { return model.internalForce(q + s*d); }
    );
    const Vector Kd = model.dofs().expand(model.tangent(q)*model.dofs().reduce(d));
    EXPECT_LT((df - Kd).norm(), 1e-10*Kd.norm()) << "seed " << seed;
}

Vector rotated(const Vector& q, const Eigen::Matrix3d& R, const Vec3& shift)
{
    Vector moved = q;
    for (Eigen::Index i = 0; i < q.size(); i += dofsPerNode)
    {
        moved.segment<3>(i) = R*q.segment<3>(i) + shift;
        moved.segment<3>(i + 3) = R*q.segment<3>(i + 3);
    }
    return moved;
}

Eigen::Matrix3d someRotation()
{
    return Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

} // namespace

TEST_P(ElementForms, forceIsTheDerivativeOfEnergyAndTangentThatOfForce)
{
    const auto model = curvedModel(material(3, 0.3), GetParam());
    for (int seed : {1, 2, 3}) checkForceAndTangent(*model, seed);
}

TEST_P(ElementForms, derivativesHoldForEveryIntegrationRule)
{
    for (int area : {6, 7, 12, 16, 25})
    {
        for (int through : {2, 3, 5})
        {
            checkForceAndTangent
            (
                *curvedModel(material(3, 0.3), GetParam(), {area, through}), area + through
            );
        }
    }
}

TEST_P(ElementForms, derivativesHoldForAMaterialThatIsNotLinear)
{
    const auto model = curvedModel(std::make_shared<CubicMaterial>(3, 0.3, 4), GetParam());
    for (int seed : {1, 2}) checkForceAndTangent(*model, seed);
}

// The general path with a linear law must give what the fast path gives
TEST_P(ElementForms, generalAndLinearMaterialPathsAgree)
{
    const auto fast = curvedModel(material(3, 0.3), GetParam());
    const auto general = curvedModel(std::make_shared<CubicMaterial>(3, 0.3, 0), GetParam());
    const Vector q = randomState(fast->mesh(), 0.05, 7);
    EXPECT_NEAR(fast->strainEnergy(q), general->strainEnergy(q), 1e-12*fast->strainEnergy(q));
    const Vector f = fast->internalForce(q);
    EXPECT_LT((f - general->internalForce(q)).norm(), 1e-12*f.norm());
    const SparseMatrix K = fast->tangent(q);
    EXPECT_LT((K - general->tangent(q)).norm(), 1e-12*K.norm());
}

TEST_P(ElementForms, vectorInstructionsGiveTheSameForces)
{
    const BatchKernel* fast = avx2Kernel(GetParam());
    if (!fast || &batchKernel(GetParam()) != fast)
    {
        GTEST_SKIP() << "no AVX2 here: nothing to compare";
    }

    ElementRule rule;
    rule.thickness = gaussRule(3);
    rule.area.resize(1);
    rule.area[0].weight = 0.5;
    const Vector random = randomVector(70 + 30, 5);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        for (int d = 0; d < 3; ++d) rule.area[0].phi[j][d] = random[70 + 3*j + d];
    }
    if (GetParam() == ElementForm::assumedStrain)
    {
        rule.assumed = assumedInterpolation(triangleRule(7));
        rule.assumed.points.resize(1);
    }
    ElementBatch batch{nullptr, 0.1, lanes, {0, 1, 2, 3}, {}, {}, {}};
    batch.points.resize(3);
    ElementVector q;
    for (int l = 0; l < lanes; ++l)
    {
        for (int k = 0; k < dofsPerElement; ++k) q.x[k].lane[l] = random[k] + 0.1*l;
        for (ReferencePoint& p : batch.points)
        {
            for (int k = 0; k < 6; ++k) p.metric[k].lane[l] = 0.1*k + l;
            for (int k = 0; k < 21; ++k) p.C[k].lane[l] = 1 + 0.01*k*l;
        }
    }
    ElementVector a;
    ElementVector b;
    fast->force(rule, batch, q, a);
    baselineKernel(GetParam()).force(rule, batch, q, b);
    double difference = 0;
    double size = 0;
    for (int k = 0; k < dofsPerElement; ++k)
    {
        for (int l = 0; l < lanes; ++l)
        {
            difference = std::max(difference, std::abs(a.x[k].lane[l] - b.x[k].lane[l]));
            size = std::max(size, std::abs(b.x[k].lane[l]));
        }
    }
    EXPECT_GT(size, 0);
    EXPECT_LT(difference, 1e-13*size);
}

TEST_P(ElementForms, theInitialStateIsFreeOfStress)
{
    const auto model = curvedModel(material(3, 0.3), GetParam());
    const Vector q = model->mesh().initialPositions();
    const double stiffness = 3*thickness;
    EXPECT_LT(model->strainEnergy(q), 1e-28*stiffness);
    EXPECT_LT(model->internalForce(q).norm(), 1e-13*stiffness);
    EXPECT_NEAR(model->minimumVolumeRatio(q), 1, 1e-12);
}

TEST_P(ElementForms, rigidMotionsGiveNoEnergyAndNoForce)
{
    const auto model = curvedModel(material(3, 0.3), GetParam());
    const Vector q = rotated(model->mesh().initialPositions(), someRotation(), {3, -2, 1});
    const double stiffness = 3*thickness;
    EXPECT_LT(model->strainEnergy(q), 1e-28*stiffness);
    EXPECT_LT(model->internalForce(q).norm(), 1e-13*stiffness);
}

TEST_P(ElementForms, energyAndForceTurnWithTheBody)
{
    const auto model = curvedModel(material(3, 0.3), GetParam());
    const Vector q = randomState(model->mesh(), 0.05, 11);
    const Eigen::Matrix3d R = someRotation();
    const Vector turned = rotated(q, R, {3, -2, 1});
    const double U = model->strainEnergy(q);
    EXPECT_NEAR(model->strainEnergy(turned), U, 1e-11*U);
    const Vector f = model->internalForce(q);
    EXPECT_LT
    (
        (model->internalForce(turned) - rotated(f, R, Vec3::Zero())).norm(), 1e-11*f.norm()
    );
}

TEST_P(ElementForms, tangentIsSymmetric)
{
    const auto model = curvedModel(material(3, 0.3), GetParam());
    const SparseMatrix K = model->tangent(randomState(model->mesh(), 0.05, 4));
    const SparseMatrix T = K.transpose();
    EXPECT_EQ((K - T).norm(), 0);
}

// Tied and fixed unknowns: P^T K P of the unconstrained matrix
TEST(ShellModel, constrainedMatricesAreTheReducedOnes)
{
    const ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {1, 0.2, 0}, {0, 0, 0.3});
    const std::vector<Section> sections{{"all", thickness, material(3, 0.3, 2)}};
    const ShellModel whole(mesh, sections, Constraints(mesh).dofMap());
    const DofMap dofs = Constraints(mesh).clamped("uMin").planeStrainStrip(Axis::z).dofMap();
    const ShellModel reduced(mesh, sections, dofs);

    Eigen::MatrixXd P = Eigen::MatrixXd::Zero(dofs.nFull(), dofs.nEquations());
    for (int i = 0; i < dofs.nFull(); ++i)
    {
        if (dofs.equation(i) >= 0) P(i, dofs.equation(i)) = 1;
    }
    const Vector q = randomState(mesh, 0.05, 9);
    const Eigen::MatrixXd K = P.transpose()*Eigen::MatrixXd(whole.tangent(q))*P;
    EXPECT_LT((Eigen::MatrixXd(reduced.tangent(q)) - K).norm(), 1e-13*K.norm());
    const Eigen::MatrixXd M = P.transpose()*Eigen::MatrixXd(whole.massMatrix())*P;
    EXPECT_LT((Eigen::MatrixXd(reduced.massMatrix()) - M).norm(), 1e-13*M.norm());
}

TEST(ShellModel, volumeRatioIsThatOfAUniformStretch)
{
    const auto model = curvedModel(material(3, 0.3));
    Vector q = model->mesh().initialPositions();
    q *= 1.1;
    EXPECT_NEAR(model->minimumVolumeRatio(q), 1.331, 1e-12);
    q = rotated(q, Eigen::Vector3d(1, 1, -1).asDiagonal(), Vec3::Zero());
    EXPECT_NEAR(model->minimumVolumeRatio(q), -1.331, 1e-12);
}

TEST(ShellModel, massOfAPlate)
{
    const double rho = 7600;
    const double h = 0.01;
    const ShellMesh mesh = rectangleMesh(3, 2, {1, 2, 3}, {0.5, 0, 0}, {0.1, 0.4, 0});
    const ShellModel model(mesh, {{"all", h, material(1, 0, rho)}}, Constraints(mesh).dofMap());
    const double mass = rho*h*0.5*0.4;
    EXPECT_NEAR(model.totalMass(), mass, 1e-13*mass);
    EXPECT_NEAR(model.area(mesh.initialPositions()), 0.2, 1e-14);
    const Vec3 centre = Vec3(1, 2, 3) + 0.5*Vec3(0.6, 0.4, 0);
    EXPECT_LT((model.centreOfMass(mesh.initialPositions()) - centre).norm(), 1e-13);
}

// Spin of a rectangular plate about its middle: momentum = inertia of the solid
// body times angular velocity, energy half of that times it, both exact
TEST(ShellModel, spinningPlateHasTheInertiaOfTheSolidBody)
{
    const double rho = 2;
    const double h = 0.3;
    const double a = 1.2;
    const double b = 0.8;
    const ShellMesh mesh = rectangleMesh(2, 2, {-a/2, -b/2, 0}, {a, 0, 0}, {0, b, 0});
    const ShellModel model(mesh, {{"all", h, material(1, 0, rho)}}, Constraints(mesh).dofMap());
    const double m = rho*h*a*b;
    // The mid-surface carries I of a lamina, the directors h^2/12 of both bending axes;
    // about the normal the plate has no rotary part
    const Vec3 inertia
    (
        m*(b*b + h*h)/12, m*(a*a + h*h)/12, m*(a*a + b*b)/12
    );
    const Vector q = mesh.initialPositions();
    const Vec3 omega(0.3, -0.7, 1.1);
    Vector v = Vector::Zero(q.size());
    for (Eigen::Index i = 0; i < q.size(); i += dofsPerNode)
    {
        v.segment<3>(i) = omega.cross(Vec3(q.segment<3>(i)));
        v.segment<3>(i + 3) = omega.cross(Vec3(q.segment<3>(i + 3)));
    }
    const Vec3 expected = inertia.cwiseProduct(omega);
    EXPECT_LT((model.angularMomentum(q, v) - expected).norm(), 1e-13*expected.norm());
    EXPECT_NEAR(model.kineticEnergy(v), 0.5*omega.dot(expected), 1e-13*omega.dot(expected));
    EXPECT_LT(model.linearMomentum(v).norm(), 1e-13);
}

TEST(ShellModel, onlyTheThicknessStrainIsMassless)
{
    const auto model = curvedModel(material(3, 0.3));
    for (int e = 0; e < model->dofs().nEquations(); ++e)
    {
        EXPECT_EQ(model->massless(e), model->dofs().firstUnknown(e)%dofsPerNode == 6);
    }
}

TEST(ShellModel, sectionsMayDiffer)
{
    ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    mesh.addElementSet("thin", {0, 1});
    mesh.addElementSet("thick", {2, 3});
    const ShellModel model
    (
        mesh, {{"thin", 0.1, material(1, 0, 3)}, {"thick", 0.2, material(1, 0, 5)}},
        Constraints(mesh).dofMap()
    );
    EXPECT_NEAR(model.totalMass(), 3*0.1 + 5*0.2, 1e-14);
    EXPECT_EQ(model.thickness(1), 0.1);
    EXPECT_EQ(model.thickness(2), 0.2);
    checkForceAndTangent(model, 3);
}

TEST(ShellModel, errorsNameSectionOrElement)
{
    ShellMesh mesh = rectangleMesh(2, 1, Vec3::Zero(), {2, 0, 0}, {0, 1, 0});
    mesh.addElementSet("left", {0, 1});
    const auto error = [&](std::vector<Section> sections)
    {
        return errorOf
        (
            [&] { ShellModel(mesh, sections, Constraints(mesh).dofMap()); }
        );
    };
    const MaterialPtr m = material(1, 0);
    EXPECT_EQ(error({{"left", 0.1, m}}), "shell model: element 2 belongs to no section");
    EXPECT_EQ
    (
        error({{"all", 0.1, m}, {"left", 0.1, m}}),
        "shell model: element 0 belongs to two sections, of the element sets all and left"
    );
    EXPECT_NE(error({{"all", 0, m}}).find("has thickness 0"), std::string::npos);
    EXPECT_NE(error({{"all", 0.1, nullptr}}).find("has no material"), std::string::npos);
    EXPECT_NE(error({{"al", 0.1, m}}).find("no element set al"), std::string::npos);

    const ShellMesh other = strip(1, 1);
    EXPECT_NE
    (
        errorOf([&] { ShellModel(mesh, {{"all", 0.1, m}}, Constraints(other).dofMap()); })
       .find("is for 16 nodes, the mesh has 28"),
        std::string::npos
    );

    // Radius 1, half thickness 1.1: the concave face is beyond the centre
    const ShellMesh arc = structuredMesh
    (
        2, 1, [](double u, double v) -> Vec3 { return {std::sin(u), v, std::cos(u)}; }
    );
    EXPECT_NE
    (
        errorOf([&] { ShellModel(arc, {{"all", 2.2, m}}, Constraints(arc).dofMap()); })
       .find("is too large for the curvature"),
        std::string::npos
    );
}
