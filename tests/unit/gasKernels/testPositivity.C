/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The low order is positive up to Courant number 1 for any states, and the
// limiter keeps density within its bounds and every total: doc/theory/gas.md,
// section 5.3

#include "kernelScene.H"

#include <gtest/gtest.h>

using namespace kernelTest;

template<class Dim>
class Positivity
:
    public testing::Test
{};

using dims = testing::Types
<
    std::integral_constant<int, 1>,
    std::integral_constant<int, 2>,
    std::integral_constant<int, 3>
>;
TYPED_TEST_SUITE(Positivity, dims);


TYPED_TEST(Positivity, lowOrderUpToCourantNumberOne)
{
    constexpr int dim = TypeParam::value;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        for (const double mach : {0.1, 2.0, 30.0})
        {
            const scene<dim> s(100, mach, 4, seed);
            EXPECT_EQ(step(s, kernels, 0.999).unphysicalLow, -1)
                << "seed " << seed << ", Mach " << mach;
        }
    }
}


// The bound is not idle: far beyond it states do become unphysical
TYPED_TEST(Positivity, notFarBeyond)
{
    constexpr int dim = TypeParam::value;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    int unphysical = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        unphysical +=
            step(scene<dim>(100, 2, 4, seed), kernels, 3).unphysicalLow >= 0;
    }
    EXPECT_GT(unphysical, 10);
}


// The bounds are those of (G49) with (G56) and (G58)
TYPED_TEST(Positivity, limitedDensityStaysWithinItsBounds)
{
    constexpr int dim = TypeParam::value;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    int nSmooth = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const scene<dim> s(100, 1, 1, seed);
        const stepResult r = step(s, kernels, 0.8);
        std::vector<double> low(s.nNodes), high(s.nNodes);
        std::vector<double> leastOffer(s.nNodes), greatestOffer(s.nNodes);
        for (int a = 0; a < s.nNodes; ++a)
        {
            const double old = s.state[rowSize*a], now = r.low[rowSize*a];
            low[a] = std::min(old, now);
            high[a] = std::max(old, now);
            const double courant = r.deltaT*r.speed[a]/s.volume[a];
            bool isSmooth = courant < dim/std::sqrt(3.0);
            for (int k = 0; k < dim; ++k)
            {
                isSmooth = isSmooth && r.rate[rowSize*a + dim + 2 + k] == 0;
            }
            nSmooth += isSmooth;
            leastOffer[a] = isSmooth ? low[a] : now;
            greatestOffer[a] = isSmooth ? high[a] : now;
        }
        for (std::size_t e = 0; e < s.first.size(); ++e)
        {
            const int i = s.first[e], j = s.second[e];
            if (i == s.nNodes)
            {
                continue;
            }
            low[i] = std::min(low[i], leastOffer[j]);
            low[j] = std::min(low[j], leastOffer[i]);
            high[i] = std::max(high[i], greatestOffer[j]);
            high[j] = std::max(high[j], greatestOffer[i]);
        }
        // The least and greatest curvature of a neighbourhood
        std::vector<double> least(s.nNodes), greatest(s.nNodes);
        for (int a = 0; a < s.nNodes; ++a)
        {
            least[a] = greatest[a] = r.difference[rowSize*a];
        }
        for (std::size_t e = 0; e < s.first.size(); ++e)
        {
            const int i = s.first[e], j = s.second[e];
            if (i < s.nNodes)
            {
                const double ofI = r.difference[rowSize*i];
                const double ofJ = r.difference[rowSize*j];
                least[i] = std::min(least[i], ofJ);
                least[j] = std::min(least[j], ofI);
                greatest[i] = std::max(greatest[i], ofJ);
                greatest[j] = std::max(greatest[j], ofI);
            }
        }

        double moved = 0;
        for (int a = 0; a < s.nNodes; ++a)
        {
            low[a] -= std::min(std::max(2*least[a], 0.0), 0.5*low[a]);
            high[a] += std::max(-2*greatest[a], 0.0);
            const double change = r.sum[rowSize*a]/s.volume[a];
            const double rho = r.low[rowSize*a] + change;
            EXPECT_GE(rho, low[a]*(1 - 1e-12));
            EXPECT_LE(rho, high[a]*(1 + 1e-12));
            moved = std::max(moved, std::abs(change));
        }
        EXPECT_GT(moved, 0.01);
    }
    EXPECT_GT(nSmooth, 0);
}


// Against plain loops: what a node collects, (G48)
TYPED_TEST(Positivity, nodesCollectFromAllTheirEdges)
{
    constexpr int dim = TypeParam::value;
    using place = gasKernel::collectedPlace;
    for (const auto& kernels : gasKernel::gasKernels<dim>::available())
    {
        const scene<dim> s(100, 1, 1, 3);
        const stepResult r = step(s, kernels, 0.8);
        std::vector<double> expected(r.begun);
        for (std::size_t e = 0; e < s.first.size(); ++e)
        {
            for (const int sign : {-1, 1})
            {
                const int a = sign < 0 ? s.first[e] : s.second[e];
                const int b = sign < 0 ? s.second[e] : s.first[e];
                if (a == s.nNodes)
                {
                    continue;
                }
                const double rho = sign*r.flux[e];
                double* row = &expected[place::size*a];
                row[place::rho + (rho < 0)] += rho;
                double along = 0;
                for (int k = 0; k < dim; ++k)
                {
                    along -=
                        r.limited[rowSize*a + 2 + dim + k]
                       *r.limited[rowSize*b + 2 + k];
                }
                double& fastest = row[place::velocityBound];
                fastest = std::max(fastest, along);
                for (int k = 0; k < rowSize; ++k)
                {
                    double& bound = row[place::bounds + k];
                    bound = std::max(bound, r.bounds[rowSize*b + k]);
                }
            }
        }
        for (int a = 0; a < s.nNodes; ++a)
        {
            for (int k = 0; k < place::size; ++k)
            {
                if (k != place::energy && k != place::energy + 1
                 && k != place::velocity)
                {
                    EXPECT_NEAR
                    (
                        r.collected[place::size*a + k],
                        expected[place::size*a + k], 1e-12
                    )   << kernels.name << ", node " << a << ", entry " << k;
                }
            }
        }
    }
}


TYPED_TEST(Positivity, totalsStay)
{
    constexpr int dim = TypeParam::value;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    scene<dim> s(200, 1, 1, 5);
    s.gas.pRef = 0;
    const stepResult r = step(s, kernels, 0.8);
    for (int k = 0; k < scene<dim>::n; ++k)
    {
        double before = 0, after = 0, size = 0;
        for (int a = 0; a < s.nNodes; ++a)
        {
            before += s.volume[a]*s.state[rowSize*a + k];
            after += s.volume[a]*r.low[rowSize*a + k] + r.sum[rowSize*a + k];
            size += s.volume[a]*std::abs(s.state[rowSize*a + k]);
        }
        EXPECT_LE(std::abs(after - before), 1e-12*size) << "component " << k;
    }
}
