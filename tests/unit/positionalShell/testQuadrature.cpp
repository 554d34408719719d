// SPDX-License-Identifier: GPL-3.0-or-later

#include "CubicTriangle.hpp"
#include "Quadrature.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace shellTest;

namespace
{

//- Integral of x^a y^b over the triangle: a! b!/(a + b + 2)!
double monomialIntegral(int a, int b)
{
    return std::tgamma(a + 1)*std::tgamma(b + 1)/std::tgamma(a + b + 3);
}

double ruleIntegral(const std::vector<TrianglePoint>& rule, int a, int b)
{
    double sum = 0;
    for (const TrianglePoint& p : rule)
    {
        sum += p.weight*std::pow(p.xi1, a)*std::pow(p.xi2, b);
    }
    return sum;
}


ShellMesh flatTriangle()
{
    std::vector<Vec3> nodes;
    Triangle triangle;
    for (const auto& p : CubicTriangle::nodePoints())
    {
        triangle[nodes.size()] = int(nodes.size());
        nodes.push_back({p[0] + 0.3*p[1], p[1], 0});
    }
    return ShellMesh(nodes, {triangle});
}

Vector stiffnessSpectrum(int areaPoints, int thicknessPoints)
{
    const ShellMesh mesh = flatTriangle();
    const ShellModel model
    (
        mesh, {{"all", 0.05, material(1, 0.3)}}, Constraints(mesh).dofMap(),
        {areaPoints, thicknessPoints}
    );
    const Eigen::MatrixXd K = model.tangent(mesh.initialPositions());
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
}

int nZero(const Vector& spectrum)
{
    return int((spectrum.array().abs() < 1e-12*spectrum.maxCoeff()).count());
}

} // namespace

TEST(Quadrature, triangleRulesAreExactToTheirDegree)
{
    const std::pair<int, int> pointsAndDegree[] = {{6, 4}, {7, 5}, {12, 6}, {16, 8}, {25, 10}};
    for (const auto& [nPoints, degree] : pointsAndDegree)
    {
        const auto& rule = triangleRule(nPoints);
        EXPECT_EQ(int(rule.size()), nPoints);
        double worstBeyond = 0;
        for (int a = 0; a <= degree + 1; ++a)
        {
            for (int b = 0; a + b <= degree + 1; ++b)
            {
                const double error =
                    std::abs(ruleIntegral(rule, a, b) - monomialIntegral(a, b));
                if (a + b <= degree) EXPECT_LT(error, 5e-16) << nPoints << ": " << a << b;
                else worstBeyond = std::max(worstBeyond, error);
            }
        }
        // The test can tell: the next degree is not exact
        EXPECT_GT(worstBeyond, 1e-9) << nPoints;
        for (const TrianglePoint& p : rule) EXPECT_GT(p.weight, 0);
    }
}

TEST(Quadrature, ruleOfDegreeIsTheSmallestThatIsExact)
{
    EXPECT_EQ(triangleRuleOfDegree(4).size(), 6u);
    EXPECT_EQ(triangleRuleOfDegree(5).size(), 7u);
    EXPECT_EQ(triangleRuleOfDegree(7).size(), 16u);
    EXPECT_EQ(triangleRuleOfDegree(10).size(), 25u);
}

TEST(Quadrature, gaussRulesAreExactToTheirDegree)
{
    for (int n = 1; n <= 10; ++n)
    {
        for (int a = 0; a <= 2*n - 1; ++a)
        {
            double sum = 0;
            for (const LinePoint& p : gaussRule(n)) sum += p.weight*std::pow(p.xi, a);
            EXPECT_NEAR(sum, a%2 ? 0 : 2.0/(a + 1), 2e-15) << n << " points, degree " << a;
        }
    }
}

TEST(Quadrature, anUnknownRuleIsAnErrorThatListsTheValidOnes)
{
    EXPECT_EQ
    (
        errorOf([] { triangleRule(9); }),
        "no triangle rule with 9 points; valid numbers: 6 7 12 16 25"
    );
    EXPECT_NE(errorOf([] { triangleRuleOfDegree(11); }).find("highest is 10"), std::string::npos);
    EXPECT_NE(errorOf([] { gaussRule(0); }).find("1 to 10"), std::string::npos);
}

// The default rule leaves the six rigid motions without energy and nothing else;
// one point less through the thickness or in the area does not
TEST(Quadrature, theDefaultRuleLeavesNoSpuriousMode)
{
    const IntegrationOptions standard;
    EXPECT_EQ(standard.areaPoints, 7);
    EXPECT_EQ(standard.thicknessPoints, 3);
    EXPECT_EQ(nZero(stiffnessSpectrum(7, 3)), 6);
    EXPECT_EQ(nZero(stiffnessSpectrum(12, 3)), 6);
    EXPECT_EQ(nZero(stiffnessSpectrum(7, 2)), 9);
    EXPECT_EQ(nZero(stiffnessSpectrum(6, 2)), 10);
}

// Small strains of a flat element are quadratic through the thickness: three
// points are exact. Twelve points are exact over its area.
TEST(Quadrature, exactRulesAgreeForAFlatElement)
{
    const Vector exact = stiffnessSpectrum(25, 5);
    EXPECT_LT((stiffnessSpectrum(12, 3) - exact).norm(), 1e-13*exact.norm());
    EXPECT_LT((stiffnessSpectrum(16, 3) - exact).norm(), 1e-13*exact.norm());
    EXPECT_GT((stiffnessSpectrum(12, 2) - exact).norm(), 1e-6*exact.norm());
}
