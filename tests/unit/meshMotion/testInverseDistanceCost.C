/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pointClouds.H"

#include <gtest/gtest.h>

using namespace pointClouds;

namespace
{

//- Weights per target of an application, and fixed terms per target
std::pair<scalar, scalar> cost(const int dim, const label n)
{
    const label nTargets = 200;
    const setUp cloud(shape::surface, dim, n, 2*n, nTargets);
    const inverseDistanceStatistics s = cloud.make(1e-2)->statistics();
    return
    {
        scalar(s.nWeights)/nTargets,
        scalar(s.nFixedTerms)/nTargets
    };
}

} // End namespace


// Each doubling of the number of sources adds a few weights per target: N log N
// in all. It doubles the direct sum. Fixed points start from nearly the direct
// sum, since leaves are large.
TEST(inverseDistanceCost, growsWithTheLogarithmOfTheNumberOfSources)
{
    const label doublings = 6;
    const auto small = cost(2, 2000);
    const auto large = cost(2, 2000 << doublings);

    EXPECT_LE(small.first, 100);
    EXPECT_LE(large.first - small.first, 10*doublings);
    EXPECT_LE(large.second, small.second);
}


TEST(inverseDistanceCost, growsSlowlyInThreeDimensions)
{
    const auto medium = cost(3, 8000);
    const auto large = cost(3, 64000);

    EXPECT_LE(large.first, 2*medium.first);
    EXPECT_LE(large.second, 2*medium.second);
    EXPECT_LE(large.first, 64000/20);
}


TEST(inverseDistanceCost, neverExceedsTheDirectSum)
{
    for (const label n : {1, 5, 20, 100})
    {
        for (const scalar tolerance : {0.0, 1e-6, 1e-1})
        {
            const setUp cloud(shape::surface, 2, n, 20, 50);
            EXPECT_LE
            (
                cloud.make(tolerance)->statistics().nWeights,
                int64_t(n)*50
            );
        }
    }
}


TEST(inverseDistanceCost, memoryIsBoundedPerTarget)
{
    const label nTargets = 100;
    const setUp cloud(shape::surface, 3, 20000, 100, nTargets);
    for (const scalar tolerance : {0.0, 1e-3})
    {
        const auto s = cloud.make(tolerance)->statistics();
        EXPECT_LE(s.nStored, 512*nTargets);
        EXPECT_LE(s.nBytes, s.nWeights + 512*8*nTargets + 100*nTargets);
    }
}
