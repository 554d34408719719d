/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "expansionRemainder.H"
#include "multipole.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace Foam;

namespace
{

const scalar exponents[] = {0.5, 1, 2, 3, 4, 7.5, 20};

template<int dim>
typename multipole<dim>::coordinates randomDirection(std::mt19937& random)
{
    std::normal_distribution<scalar> normal;
    typename multipole<dim>::coordinates d;
    for (int a = 0; a < dim; ++a)
    {
        d[a] = normal(random);
    }
    const scalar length = std::sqrt(multipole<dim>::square(d));
    for (int a = 0; a < dim; ++a)
    {
        d[a] /= length;
    }
    return d;
}


//- |r - s|^-e by its expansion, for |r| = 1
template<int dim>
scalar expanded
(
    const scalar e,
    const typename multipole<dim>::coordinates& r,
    const typename multipole<dim>::coordinates& s
)
{
    const auto w = multipole<dim>::weights(e, r, 1);
    const auto m = multipole<dim>::monomials(s);
    scalar sum = 0;
    for (int k = 0; k < multipole<dim>::nTerms; ++k)
    {
        sum += w[k]*m[k];
    }
    return sum;
}


template<int dim>
void expectRemainderWithinBound(const scalar e, const scalar ratio)
{
    std::mt19937 random(dim);
    const scalar bound =
        expansionRemainder::series(e, ratio)*std::pow(ratio, 3);

    for (int trial = 0; trial < 200; ++trial)
    {
        const auto r = randomDirection<dim>(random);
        auto s = randomDirection<dim>(random);
        for (int a = 0; a < dim; ++a)
        {
            s[a] *= ratio;
        }
        const scalar distance =
            std::sqrt(multipole<dim>::square(multipole<dim>::difference(r, s)));
        const scalar remainder =
            std::pow(distance, -e) - expanded<dim>(e, r, s);

        ASSERT_LE(std::fabs(remainder), bound*(1 + 1e-9) + 1e-13)
            << "dim " << dim << ", exponent " << e << ", ratio " << ratio;
    }
}

} // End namespace


TEST(expansion, remainderIsWithinItsBound)
{
    for (const scalar e : exponents)
    {
        for (const scalar ratio : {0.01, 0.1, 0.3, 0.6, 0.85})
        {
            expectRemainderWithinBound<1>(e, ratio);
            expectRemainderWithinBound<2>(e, ratio);
            expectRemainderWithinBound<3>(e, ratio);
        }
    }
}


// A source straight towards the target makes the bound an equality
TEST(expansion, boundIsSharp)
{
    for (const scalar e : exponents)
    {
        for (const scalar ratio : {0.05, 0.3, 0.8})
        {
            const multipole<1>::coordinates r(1.0), s(ratio);
            const scalar remainder =
                std::pow(1 - ratio, -e) - expanded<1>(e, r, s);
            const scalar bound =
                expansionRemainder::series(e, ratio)*std::pow(ratio, 3);

            EXPECT_NEAR(remainder/bound, 1, 1e-9)
                << "exponent " << e << ", ratio " << ratio;
        }
    }
}


TEST(expansion, tableBoundsTheSeriesClosely)
{
    for (const scalar e : exponents)
    {
        const expansionRemainder table(e);
        for (scalar ratio = 0; ratio <= table.maxRatio(); ratio += 0.0007)
        {
            const scalar exact = expansionRemainder::series(e, ratio);
            ASSERT_GE(table(ratio), exact);
            ASSERT_LE
            (
                table(ratio),
                expansionRemainder::series(e, ratio + 1.0/512)*(1 + 1e-12)
            );
        }
        EXPECT_GE(table(table.maxRatio()), table(0));
    }
}


TEST(expansion, weightsArePositiveUpToTheLargestRatioAndNotBeyond)
{
    for (const scalar e : {2.0, 4.0, 7.5, 20.0})
    {
        const scalar ratio = expansionRemainder(e).maxRatio();
        ASSERT_LT(ratio, 0.9);

        const auto least = [e](const scalar rho)
        {
            scalar result = GREAT;
            for (scalar angle = 0; angle < 3.15; angle += 0.001)
            {
                multipole<2>::coordinates r, s;
                r[0] = 1;
                r[1] = 0;
                s[0] = rho*std::cos(angle);
                s[1] = rho*std::sin(angle);
                result = std::min(result, expanded<2>(e, r, s));
            }
            return result;
        };

        EXPECT_GE(least(ratio), -1e-12) << "exponent " << e;
        EXPECT_LT(least(ratio), 1e-4) << "exponent " << e;
        EXPECT_LT(least(1.01*ratio), 0) << "exponent " << e;
    }
}
