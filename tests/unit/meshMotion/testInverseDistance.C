/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pointClouds.H"

#include <gtest/gtest.h>

using namespace pointClouds;

namespace
{

const shape shapes[] = {shape::uniform, shape::clustered, shape::surface};

vectorField apply(const inverseDistanceOperator& op, const vectorField& values)
{
    vectorField result;
    op.apply(values, result);
    return result;
}


scalar largest(const vectorField& f)
{
    return f.empty() ? 0 : max(mag(f));
}

} // End namespace


TEST(inverseDistance, withoutToleranceIsTheDirectSum)
{
    for (const int dim : {1, 2, 3})
    {
        for (const shape s : shapes)
        {
            const setUp cloud(s, dim, 150, 300, 100);
            const vectorField values(randomValues(150, dim, 1));
            const vectorField expected(direct(cloud, values));

            const auto op = cloud.make(0);
            EXPECT_LE(largest(apply(op(), values) - expected), 1e-13)
                << name(s) << ", dim " << dim;
            EXPECT_EQ(op->statistics().worstBound, 0);
            EXPECT_EQ(op->statistics().nWeights, 150*100);
        }
    }
}


// The largest error that values of magnitude 1 can cause at a target is the
// sum of the errors of its weights. Unit values deliver the weights.
TEST(inverseDistance, errorIsWithinTheBoundForTheWorstValues)
{
    for (const int dim : {2, 3})
    {
        for (const shape s : shapes)
        {
            const label n = 400;
            const setUp cloud(s, dim, n, 800, 60);

            for (const scalar tolerance : {0.3, 1e-2, 1e-4})
            {
                const auto op = cloud.make(tolerance);
                scalarField error(cloud.targets.size(), Zero);
                List<std::vector<scalar>> exact(cloud.targets.size());
                forAll(exact, k)
                {
                    exact[k] = directWeights(cloud, cloud.targets[k]);
                }
                for (label j = 0; j < n; ++j)
                {
                    vectorField unit(n, Zero);
                    unit[j].x() = 1;
                    const vectorField weights(apply(op(), unit));
                    forAll(weights, k)
                    {
                        error[k] += mag(weights[k].x() - exact[k][j]);
                        EXPECT_GE(weights[k].x(), 0);
                    }
                }

                const scalar bound = op->statistics().worstBound;
                EXPECT_LE(bound, tolerance);
                EXPECT_LE(max(error), bound)
                    << name(s) << ", dim " << dim << ", " << tolerance;

                // Something has been approximated, and not much too well
                EXPECT_LT(op->statistics().nWeights, int64_t(60)*n);
                EXPECT_GT(max(error), 1e-3*tolerance)
                    << name(s) << ", dim " << dim << ", " << tolerance;
            }
        }
    }
}


TEST(inverseDistance, boundHoldsForAnyExponentsAndStrengths)
{
    for (const scalar e : {0.5, 1.0, 2.0, 3.0, 5.5, 20.0})
    {
        setUp cloud(shape::surface, 3, 500, 1000, 100);
        cloud.settings.e1 = e;
        cloud.settings.e2 = e;
        forAll(cloud.moving.strengths, j)
        {
            cloud.moving.strengths[j] = 1 + j % 5;
        }
        const vectorField values(randomValues(500, 3, 2));
        const vectorField expected(direct(cloud, values));

        for (const scalar tolerance : {1e-1, 1e-3})
        {
            const auto op = cloud.make(tolerance);
            EXPECT_LE
            (
                largest(apply(op(), values) - expected),
                op->statistics().worstBound
            ) << "exponent " << e;
            EXPECT_LE(op->statistics().worstBound, tolerance);
        }
    }
}


TEST(inverseDistance, isLinear)
{
    const setUp cloud(shape::surface, 3, 2000, 1000, 100);
    const auto op = cloud.make(0.1);
    const vectorField u(randomValues(2000, 3, 3)), v(randomValues(2000, 3, 4));

    const vectorField sum(apply(op(), 2.5*u - 0.7*v));
    const vectorField parts(2.5*apply(op(), u) - 0.7*apply(op(), v));
    EXPECT_LE(largest(sum - parts), 1e-14*3.2);
}


TEST(inverseDistance, translationOfAllBoundariesTranslatesEverything)
{
    for (const int dim : {1, 2, 3})
    {
        for (const scalar tolerance : {0.5, 1e-2, 0.0})
        {
            const setUp cloud(shape::surface, dim, 3000, 0, 300);
            vector shift(1.7, -0.3, 0.9);
            for (int a = dim; a < 3; ++a)
            {
                shift[a] = 0;
            }
            const vectorField moved
            (
                apply(cloud.make(tolerance)(), vectorField(3000, shift))
            );
            EXPECT_LE(largest(moved - shift), 1e-13)
                << "dim " << dim << ", tolerance " << tolerance;
        }
    }
}


TEST(inverseDistance, ignoresComponentsOutsideTheScene)
{
    setUp cloud(shape::surface, 2, 50, 50, 20);
    const vectorField values(randomValues(50, 3, 5));
    const vectorField flat(apply(cloud.make(1e-3)(), values));

    for (point& p : cloud.targets)
    {
        p.z() = 7;
    }
    EXPECT_LE(largest(apply(cloud.make(1e-3)(), values) - flat), 0);
    EXPECT_EQ(max(mag(flat.component(vector::Z)())), 0);
}


// Eq. (M5): with equal exponents the unit of length does not matter; with
// different ones it does not if the reference length changes with it
TEST(inverseDistance, doesNotDependOnTheUnitOfLength)
{
    for (const scalar scale : {1e-6, 1e6})
    {
        setUp cloud(shape::surface, 3, 300, 600, 100);
        cloud.settings.e1 = 3;
        cloud.settings.e2 = 4;
        cloud.settings.referenceLength = 0.2;
        const vectorField values(randomValues(300, 3, 6));
        const vectorField expected(direct(cloud, values));

        cloud.moving.positions *= scale;
        cloud.fixed.positions *= scale;
        cloud.targets *= scale;
        cloud.settings.referenceLength *= scale;
        EXPECT_LE
        (
            largest(apply(cloud.make(0)(), values) - expected),
            1e-12
        );

        cloud.settings.referenceLength *= 2;
        EXPECT_GT
        (
            largest(apply(cloud.make(0)(), values) - expected),
            1e-3
        );
    }
}


TEST(inverseDistance, strengthsCountAsThatManyPoints)
{
    const setUp once(shape::surface, 2, 100, 200, 50);
    const vectorField values(randomValues(100, 2, 7));

    setUp strong(once);
    strong.moving.strengths = 3;
    setUp thrice(once);
    vectorField thriceValues(values);
    for (label i = 0; i < 2; ++i)
    {
        thrice.moving.positions.append(once.moving.positions);
        thriceValues.append(values);
    }
    thrice.moving.strengths = scalarField(300, 1.0);

    EXPECT_LE
    (
        largest
        (
            apply(strong.make(0)(), values)
          - apply(thrice.make(0)(), thriceValues)
        ),
        1e-13
    );
}


TEST(inverseDistance, targetOnASourceTakesItsValue)
{
    for (const scalar tolerance : {0.0, 1e-2})
    {
        setUp cloud(shape::surface, 2, 500, 500, 3);
        cloud.targets[0] = cloud.moving.positions[123];
        cloud.targets[1] = cloud.fixed.positions[45];
        const vectorField values(randomValues(500, 2, 8));

        const vectorField moved(apply(cloud.make(tolerance)(), values));
        EXPECT_LE(mag(moved[0] - values[123]), 1e-12);
        EXPECT_LE(mag(moved[1]), 1e-12);
    }
}


TEST(inverseDistance, doesNotDependOnTheOtherTargets)
{
    const setUp all(shape::surface, 3, 1500, 1500, 200);
    const vectorField values(randomValues(1500, 3, 9));
    const vectorField moved(apply(all.make(1e-2)(), values));

    setUp half(all);
    half.targets = pointField(SubList<point>(all.targets, 100, 100));
    const vectorField movedHalf(apply(half.make(1e-2)(), values));
    forAll(movedHalf, k)
    {
        EXPECT_EQ(movedHalf[k], moved[100 + k]);
    }
}


TEST(inverseDistance, acceptsTheSmallestSets)
{
    const setUp one(shape::uniform, 3, 1, 0, 5);
    const vectorField value(1, vector(1, 2, 3));
    const vectorField moved(apply(one.make(1e-3)(), value));
    EXPECT_LE(largest(moved - value[0]), 1e-14);

    const setUp none(shape::uniform, 3, 10, 10, 0);
    EXPECT_TRUE(apply(none.make(1e-3)(), vectorField(10, Zero)).empty());
}
