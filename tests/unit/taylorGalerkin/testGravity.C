/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The mean density of the gas' weight, (G83)

#include "gravityTerms.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Mean of rho in a column of one temperature, whose logarithm is linear:
//  integral of rho exp(z log(rhoB/rhoA)) over z from 0 to 1, by many points
double columnMean(const double rhoA, const double rhoB)
{
    constexpr int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        sum += rhoA*std::exp(std::log(rhoB/rhoA)*(i + 0.5)/n);
    }
    return sum/n;
}

} // End namespace


// On both sides of the change from the series to the quotient, at f^2 = 1e-3
TEST(Gravity, meanDensityIsThatOfAColumnOfOneTemperature)
{
    for
    (
        const double ratio
      : {0.2, 0.93, 0.939, 0.99, 1 + 1e-9, 1.065, 1.066, 4.0}
    )
    {
        EXPECT_NEAR
        (
            gravityTerms<3>::meanDensity(1.2, 1.2*ratio)
           /columnMean(1.2, 1.2*ratio),
            1, 1e-9
        )   << ratio;
    }
}


TEST(Gravity, meanDensityHasNoJump)
{
    const double f = std::sqrt(1e-3);
    auto mean = [](const double f)
    {
        return gravityTerms<3>::meanDensity(1 - f, 1 + f);
    };
    EXPECT_NEAR(mean(f*(1 - 1e-12))/mean(f*(1 + 1e-12)), 1, 1e-14);
}


TEST(Gravity, meanDensityOfEqualOnesIsTheirs)
{
    EXPECT_EQ(gravityTerms<3>::meanDensity(0.7, 0.7), 0.7);
}
