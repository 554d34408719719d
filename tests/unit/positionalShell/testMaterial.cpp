// SPDX-License-Identifier: GPL-3.0-or-later

#include "LinearProblems.hpp"
#include "Orthotropic.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

using namespace shellTest;

namespace
{

constexpr OrthotropicConstants lamina{40, 10, 8, 0.25, 0.3, 0.2, 5, 3, 4};

void checkDerivatives(const Material& material)
{
    for (int seed : {1, 2, 3})
    {
        const Strain E = 0.1*randomVector(6, seed);
        const Strain d = randomVector(6, 100 + seed);
        const double dW = polynomialDerivative<double>
        (
            [&](double s) { return material.energyDensity(E + s*d); }
        );
        EXPECT_NEAR(dW, material.stress(E).dot(d), 1e-12*material.stress(E).norm());
        const Stress dS = polynomialDerivative<Stress>
        (
            [&](double s) -> Stress { return material.stress(E + s*d); }
        );
        const ElasticMatrix C = material.tangent(E);
        EXPECT_LT((dS - C*d).norm(), 1e-12*C.norm());
        EXPECT_LT((C - C.transpose()).norm(), 1e-15*C.norm());
    }
}

} // namespace

TEST(Material, stressIsTheDerivativeOfEnergyAndTangentThatOfStress)
{
    checkDerivatives(SaintVenantKirchhoff(3, 0.3, 1));
    checkDerivatives(CubicMaterial(3, 0.3, 5));
    checkDerivatives(Orthotropic(lamina, 1));
}

// E = 210, nu = 0.25 give G = 84, lambda = 84: stresses by hand
TEST(SaintVenantKirchhoff, followsHookesLaw)
{
    const SaintVenantKirchhoff steel(210, 0.25, 1);
    Strain E;
    E << 0.01, 0, 0, 0.02, 0, 0;
    Stress expected;
    expected << 84*0.01 + 2*84*0.01, 84*0.01, 84*0.01, 84*0.02, 0, 0;
    EXPECT_LT((steel.stress(E) - expected).norm(), 1e-14);

    // Uniaxial stress: strain -nu times as large across
    E << 0.01, -0.0025, -0.0025, 0, 0, 0;
    expected << 2.1, 0, 0, 0, 0, 0;
    EXPECT_LT((steel.stress(E) - expected).norm(), 1e-14);
}

TEST(Material, isCreatedByName)
{
    const Material::Parameters parameters
    {
        {"youngsModulus", 210}, {"poissonRatio", 0.25}, {"density", 7800}
    };
    const MaterialPtr made = Material::create("SaintVenantKirchhoff", parameters);
    EXPECT_EQ(made->name(), "SaintVenantKirchhoff");
    EXPECT_EQ(made->density(), 7800);
    EXPECT_TRUE(made->linear());
    EXPECT_LT
    (
        (made->tangent(Strain::Zero()) - SaintVenantKirchhoff(210, 0.25, 1).tangent(Strain::Zero()))
       .norm(),
        1e-12
    );
}

TEST(Material, errorsNameWhatIsWrongAndTheValidChoices)
{
    Material::Parameters p{{"youngsModulus", 210}, {"poissonRatio", 0.25}, {"density", 1}};
    const auto error = [&](const std::string& name)
    {
        return errorOf([&] { Material::create(name, p); });
    };
    EXPECT_EQ(error("rubber"), "unknown material rubber; valid: SaintVenantKirchhoff orthotropic");

    p.erase("density");
    EXPECT_EQ
    (
        error("SaintVenantKirchhoff"),
        "material SaintVenantKirchhoff: parameter density is missing; needed: youngsModulus "
        "poissonRatio density"
    );
    p["density"] = 1;
    p["yield"] = 3;
    EXPECT_NE(error("SaintVenantKirchhoff").find("unknown parameter yield"), std::string::npos);
    p.erase("yield");
    p["poissonRatio"] = 0.5;
    EXPECT_NE(error("SaintVenantKirchhoff").find("poissonRatio must lie"), std::string::npos);
    p["poissonRatio"] = 0.3;
    p["youngsModulus"] = 0;
    EXPECT_NE(error("SaintVenantKirchhoff").find("youngsModulus must be"), std::string::npos);
    p["youngsModulus"] = 1;
    p["density"] = -1;
    EXPECT_NE(error("SaintVenantKirchhoff").find("density must be positive"), std::string::npos);
}

// Stress along one axis: extension by its modulus, contraction by the ratios
TEST(Orthotropic, engineeringConstantsAreThoseOfUniaxialStress)
{
    const Orthotropic m(lamina, 1);
    const ElasticMatrix S = m.tangent(Strain::Zero()).inverse();
    EXPECT_NEAR(S(0, 0), 1/lamina.E1, 1e-15);
    EXPECT_NEAR(S(1, 1), 1/lamina.E2, 1e-15);
    EXPECT_NEAR(S(2, 2), 1/lamina.E3, 1e-15);
    EXPECT_NEAR(S(1, 0), -lamina.nu12/lamina.E1, 1e-15);
    EXPECT_NEAR(S(2, 0), -lamina.nu13/lamina.E1, 1e-15);
    EXPECT_NEAR(S(2, 1), -lamina.nu23/lamina.E2, 1e-15);
    EXPECT_NEAR(S(3, 3), 1/lamina.G12, 1e-15);
    EXPECT_NEAR(S(4, 4), 1/lamina.G23, 1e-15);
    EXPECT_NEAR(S(5, 5), 1/lamina.G13, 1e-15);
}

TEST(Orthotropic, equalConstantsGiveHookesLaw)
{
    const double G = 3/(2*1.3);
    const Orthotropic same({3, 3, 3, 0.3, 0.3, 0.3, G, G, G}, 1);
    const ElasticMatrix C = SaintVenantKirchhoff(3, 0.3, 1).tangent(Strain::Zero());
    EXPECT_LT((same.tangent(Strain::Zero()) - C).norm(), 1e-14*C.norm());
}

TEST(Orthotropic, errorsNameTheParameter)
{
    OrthotropicConstants c = lamina;
    c.G23 = 0;
    EXPECT_NE(errorOf([&] { Orthotropic(c, 1); }).find("shearModulus23"), std::string::npos);
    c = lamina;
    c.nu12 = 2.1;
    EXPECT_NE(errorOf([&] { Orthotropic(c, 1); }).find("nu12^2 < E1/E2"), std::string::npos);

    const ShellMesh mesh = strip(1, 1);
    const MaterialPtr m = std::make_shared<Orthotropic>(lamina, 1);
    const auto error = [&](const Section& section)
    {
        return errorOf([&] { ShellModel(mesh, {section}, Constraints(mesh).dofMap()); });
    };
    EXPECT_NE(error({"all", 0.1, m}).find("needs the axis"), std::string::npos);
    EXPECT_NE(error({"all", 0.1, m, {0, 0, 1}}).find("normal to element 0"), std::string::npos);
    EXPECT_EQ(error({"all", 0.1, m, {0, 1, 1}}), "no error");
}

// Square under tension along x at an angle to the fibres, free to contract and to shear:
// the compliance turned in the plane
TEST(Orthotropic, offAxisTensionFollowsTheTurnedCompliance)
{
    const ShellMesh mesh = rectangleMesh(2, 2, Vec3::Zero(), {1, 0, 0}, {0, 1, 0});
    const double h = 0.1;
    for (ElementForm form : {ElementForm::displacement, ElementForm::assumedStrain})
    {
        for (double degrees : {0.0, 30.0, 75.0, 90.0})
        {
            // Half of the angle by the axis, half by turning it
            const double angle = degrees*pi/180;
            Section section{"all", h, std::make_shared<Orthotropic>(lamina, 1)};
            section.axis = {std::cos(angle/2), std::sin(angle/2), 0.3};
            section.angle = angle/2;

            // Held as a rigid body only: the corner and the direction of one edge
            const DofMap dofs = Constraints(mesh)
                .fixed("uMinVMin", {Component::x, Component::y, Component::z})
                .fixed("uMinVMin", {Component::gx, Component::gy})
                .fixed("uMaxVMin", {Component::y})
                .dofMap();
            const ShellModel model(mesh, {section}, dofs, {}, form);
            Vector force = Vector::Zero(dofs.nFull());
            const double weights[4] = {1.0/8, 3.0/8, 3.0/8, 1.0/8};
            for (int e = 0; e < 2; ++e)
            {
                for (int k = 0; k < 4; ++k)
                {
                    force[7*mesh.nodeSet("uMax")[3*e + k]] += h*weights[k]/2;
                    force[7*mesh.nodeSet("uMin")[3*e + k]] -= h*weights[k]/2;
                }
            }
            const Vector u = linearSolution(model, force);
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            const double cross = 1/lamina.G12 - 2*lamina.nu12/lamina.E1;
            const double along = c*c*c*c/lamina.E1 + s*s*s*s/lamina.E2 + c*c*s*s*cross;
            const double shear = c*s*(2*c*c/lamina.E1 - 2*s*s/lamina.E2 - (c*c - s*s)*cross);
            EXPECT_NEAR(u[7*mesh.nodeSet("uMaxVMin")[0]], along, 1e-12) << degrees;
            // The lower edge stays on the axis: the left one leans by the shear strain
            EXPECT_NEAR(u[7*mesh.nodeSet("uMinVMax")[0]], shear, 1e-12) << degrees;
        }
    }
}
