// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

using namespace shellTest;

namespace
{

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
    EXPECT_EQ(error("rubber"), "unknown material rubber; valid: SaintVenantKirchhoff");

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
