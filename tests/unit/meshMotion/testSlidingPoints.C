/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Points that slide in planes, eqs. (M13) to (M15) of doc/theory/meshMotion.md

#include "pointClouds.H"
#include "SubField.H"
#include "symmTensor.H"

#include <gtest/gtest.h>

using namespace pointClouds;

namespace
{

//- Points of the plane through base, a square of size 1 about it
slidingPoints plane
(
    const int dim,
    const point& base,
    vector normal,
    const label n,
    const unsigned seed
)
{
    if (dim == 2)
    {
        normal.z() = 0;
    }
    normal /= mag(normal);
    std::mt19937 random(seed);
    std::uniform_real_distribution<scalar> uniform(-0.5, 0.5);

    slidingPoints s;
    s.normal = normal;
    s.strengths = scalarField(n, 1.0);
    s.positions.setSize(n);
    for (point& p : s.positions)
    {
        vector v(uniform(random), uniform(random), uniform(random));
        if (dim == 2)
        {
            v.z() = 0;
        }
        p = base + v - normal*(normal & v);
    }
    return s;
}


struct scene
:
    public setUp
{
    List<slidingPoints> sliding;

    scene(const int dim, const label n, const label nTargets)
    :
        setUp(shape::surface, dim, n, n, nTargets)
    {
        // Two planes that are not orthogonal, one of them steeper than 45
        // degrees; a corner of three in space
        sliding.append(plane(dim, {0.5, 0, 0}, {0.3, 1, 0.1}, n, 3));
        sliding.append(plane(dim, {0, 0.5, 0}, {1, 0.4, 0}, n, 4));
        if (dim == 3)
        {
            sliding.append(plane(dim, {0, 0, 0.2}, {0, 0.2, 1}, n, 5));
        }
    }

    vectorField apply(const scalar tolerance, const vectorField& values) const
    {
        inverseDistanceSettings s(settings);
        s.tolerance = tolerance;
        const auto op = inverseDistanceOperator::New
        (
            dim, moving, fixed, targets, s, sliding
        );
        bound = op->statistics().worstBound;
        nTerms = op->statistics().nFixedTerms;
        vectorField result;
        op->apply(values, result);
        return result;
    }

    mutable scalar bound;
    mutable int64_t nTerms;
};


//- The minimum of (M13) by its normal equations, term by term
vectorField direct(const scene& s, const vectorField& values)
{
    vectorField result(s.targets.size(), Zero);
    forAll(s.targets, k)
    {
        const auto weight = [&](const point& y, const scalar e)
        {
            return std::pow(mag(s.targets[k] - y), -e);
        };
        symmTensor M(Zero);
        vector sum(Zero);
        forAll(values, j)
        {
            const scalar a = weight(s.moving.positions[j], s.settings.e1);
            M += a*symmTensor::I;
            sum += a*values[j];
        }
        for (const point& y : s.fixed.positions)
        {
            M += weight(y, s.settings.e2)*symmTensor::I;
        }
        for (const slidingPoints& plane : s.sliding)
        {
            for (const point& y : plane.positions)
            {
                M += weight(y, s.settings.e2)*sqr(plane.normal);
            }
        }
        result[k] = inv(M) & sum;
    }
    return result;
}

} // End namespace


TEST(slidingPoints, withoutToleranceIsTheLeastSquaresMotion)
{
    for (const int dim : {2, 3})
    {
        scene s(dim, 200, 60);
        s.settings.e1 = 3;
        const vectorField values(randomValues(200, dim, 1));
        EXPECT_LE(max(mag(s.apply(0, values) - direct(s, values))), 1e-12)
            << "dim " << dim;
        EXPECT_EQ(s.bound, 0);
    }
}


TEST(slidingPoints, errorIsWithinTheBound)
{
    for (const int dim : {2, 3})
    {
        const scene s(dim, 3000, 60);
        vectorField values(3000, Zero);
        values = vector(0.6, -0.8, 0);
        const vectorField expected(direct(s, values));
        for (const scalar tolerance : {0.3, 1e-2, 1e-4})
        {
            const scalar error =
                max(mag(s.apply(tolerance, values) - expected));
            EXPECT_LE(error, s.bound) << "dim " << dim;
            EXPECT_LE(s.bound, tolerance);
            EXPECT_GT(error, 1e-5*tolerance);
            EXPECT_LT(s.nTerms, 60*(s.sliding.size() + 1)*3000);
        }
    }
}


// The point of the distance bound, and others very near
TEST(slidingPoints, targetsOnAPlaneStayInIt)
{
    for (const int dim : {2, 3})
    {
        scene s(dim, 200, 0);
        s.settings.e2 = 6;
        for (const slidingPoints& plane : s.sliding)
        {
            s.targets.append(SubList<point>(plane.positions, 50));
        }
        const vectorField moved(s.apply(1e-2, randomValues(200, dim, 2)));
        forAll(s.sliding, p)
        {
            for (label k = 50*p; k < 50*(p + 1); ++k)
            {
                EXPECT_LE(mag(s.sliding[p].normal & moved[k]), 1e-15);
                EXPECT_GT(mag(moved[k]), 0);
            }
            const SubField<vector> onPlane(moved, 50, 50*p);
            EXPECT_GT(max(mag(onPlane)), 1e-5) << "points slide";
        }
    }
}


TEST(slidingPoints, targetInACornerOfPlanesStays)
{
    for (const int dim : {2, 3})
    {
        scene s(dim, 200, 0);
        const point corner(0.1, 0.2, dim == 3 ? 0.3 : 0);
        for (slidingPoints& plane : s.sliding)
        {
            plane.positions.append(corner);
            plane.strengths.append(1);
        }
        s.targets = pointField(1, corner);
        const vectorField moved(s.apply(1e-2, randomValues(200, dim, 2)));
        EXPECT_LE(mag(moved[0]), 1e-15);
    }
}


// Along an edge of two planes in space, motion is along the edge
TEST(slidingPoints, targetOnAnEdgeSlidesAlongIt)
{
    scene s(3, 200, 0);
    s.sliding.setSize(2);
    s.targets = pointField(1, point(0.2, 0.1, 0.3));
    for (slidingPoints& plane : s.sliding)
    {
        plane.positions.append(s.targets[0]);
        plane.strengths.append(1);
    }
    vector edge(s.sliding[0].normal ^ s.sliding[1].normal);
    edge /= mag(edge);
    const vectorField values(200, vector(1, 2, 3));
    s.fixed.positions.clear();
    s.fixed.strengths.clear();

    // Without fixed points nothing holds it back there
    const vectorField moved(s.apply(1e-3, values));
    EXPECT_LE(mag(moved[0] - edge*(edge & values[0])), 1e-13);
}


TEST(slidingPoints, motionAlongAllPlanesIsKept)
{
    scene s(3, 1000, 100);
    s.sliding.setSize(2);
    s.fixed.positions.clear();
    s.fixed.strengths.clear();
    const vector along(s.sliding[0].normal ^ s.sliding[1].normal);
    const vectorField moved(s.apply(1e-1, vectorField(1000, along)));
    EXPECT_LE(max(mag(moved - along)), 1e-13);
}


TEST(slidingPoints, emptySetsDoNothing)
{
    scene s(2, 100, 50);
    const vectorField values(randomValues(100, 2, 3));
    for (slidingPoints& plane : s.sliding)
    {
        plane.positions.clear();
        plane.strengths.clear();
    }
    vectorField expected;
    s.make(0)->apply(values, expected);
    EXPECT_LE(max(mag(s.apply(0, values) - expected)), 1e-14);
}
