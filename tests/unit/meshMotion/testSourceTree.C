/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sourceTree.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace Foam;

namespace
{

pointField randomPoints(const label n, const unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<scalar> uniform(-1, 1);
    pointField points(n);
    for (point& p : points)
    {
        p = point(uniform(random), uniform(random), uniform(random));
    }
    return points;
}


scalarField randomStrengths(const label n, const unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<scalar> uniform(0.1, 3);
    scalarField strengths(n);
    for (scalar& s : strengths)
    {
        s = uniform(random);
    }
    return strengths;
}


template<int dim>
scalar distance
(
    const typename multipole<dim>::coordinates& x,
    const typename multipole<dim>::coordinates& y
)
{
    return std::sqrt
    (
        multipole<dim>::square(multipole<dim>::difference(x, y))
    );
}

} // End namespace


TEST(sourceTree, halvesShareOutTheirClusterDownToLeaves)
{
    const sourceTree<3> tree(randomPoints(501, 1), scalarField(501, 1.0), 10);

    ASSERT_EQ(tree.clusters()[0].size(), 501);
    label nInLeaves = 0;
    for (const auto& c : tree.clusters())
    {
        if (c.isLeaf())
        {
            EXPECT_LE(c.size(), 10);
            nInLeaves += c.size();
            continue;
        }
        const auto& first = tree.clusters()[c.firstHalf];
        const auto& second = tree.clusters()[c.secondHalf];
        EXPECT_EQ(first.begin, c.begin);
        EXPECT_EQ(first.end, second.begin);
        EXPECT_EQ(second.end, c.end);
        EXPECT_LE(std::abs(first.size() - second.size()), 1);
    }
    EXPECT_EQ(nInLeaves, 501);
}


TEST(sourceTree, clustersAreMeasuredAboutTheirCentreOfMass)
{
    const sourceTree<2> tree
    (
        randomPoints(200, 2), randomStrengths(200, 3), 6
    );

    forAll(tree.clusters(), clusteri)
    {
        const auto& c = tree.clusters()[clusteri];
        const auto& m = tree.moments()[clusteri];
        scalar radius = 0, mean = 0, third = 0;
        for (label i = c.begin; i < c.end; ++i)
        {
            const scalar r = distance<2>(tree.positions()[i], c.centre);
            radius = std::max(radius, r);
            mean += tree.strengths()[i]*r/c.mass;
            third += tree.strengths()[i]*r*r*r;
        }
        EXPECT_NEAR(c.radius, radius, 1e-14);
        EXPECT_NEAR(c.meanRadius, mean, 1e-13);
        EXPECT_NEAR(c.thirdMoment, third, 1e-11);
        EXPECT_NEAR(m[0], c.mass, 1e-12);
        EXPECT_NEAR(m[1], 0, 1e-12);
        EXPECT_NEAR(m[2], 0, 1e-12);
    }
}


TEST(sourceTree, rowsHoldValuesAndTheirMoments)
{
    const pointField points(randomPoints(60, 4));
    const scalarField strengths(randomStrengths(60, 5));
    const pointField values(randomPoints(60, 6));
    const sourceTree<3> tree(points, strengths, 10);
    const auto rows = tree.rows(values);

    std::set<scalar> delivered;
    for (label i = 0; i < 60; ++i)
    {
        delivered.insert(rows[i][0]);
    }
    std::set<scalar> given;
    for (const vector& v : values)
    {
        given.insert(v.x());
    }
    EXPECT_EQ(delivered, given);

    // The whole set: total and first moment, in the order of the input
    const auto& c = tree.clusters()[0];
    scalar total = 0, first = 0, mixed = 0;
    forAll(points, j)
    {
        const scalar sx = points[j].x() - c.centre[0];
        const scalar sy = points[j].y() - c.centre[1];
        total += strengths[j]*values[j].z();
        first += strengths[j]*sx*values[j].z();
        mixed += strengths[j]*sx*sy*values[j].z();
    }
    const label row = tree.momentRow(0);
    EXPECT_NEAR(rows[row][2], total, 1e-12);
    EXPECT_NEAR(rows[row + 1][2], first, 1e-12);
    EXPECT_NEAR(rows[row + 5][2], mixed, 1e-12);
}


TEST(sourceTree, pointsThatCoincideEndInOneLeaf)
{
    const sourceTree<2> tree
    (
        pointField(100, point(1, 2, 0)),
        scalarField(100, 1.0),
        6
    );
    ASSERT_EQ(tree.clusters().size(), 1);
    EXPECT_TRUE(tree.clusters()[0].isLeaf());
    EXPECT_EQ(tree.clusters()[0].radius, 0);
}
