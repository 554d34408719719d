/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The part of each node that is in a body: (I1), (I2)

#include "bodyShare.H"
#include "stateScene.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const dictionary nothing;

class RoundBodies : public testing::TestWithParam<label>
{
protected:

    //- Volume of a ball of radius R in a scene's directions
    scalar volume(const scalar R) const
    {
        const scalar unit[] = {0, 2, M_PI, 4*M_PI/3};
        const label dim = GetParam();
        return unit[dim]*std::pow(R, dim)*depthOf(dim);
    }

    point middle() const
    {
        const label dim = GetParam();
        return point(0.52, dim > 1 ? 0.47 : 0, dim > 2 ? 0.5 : 0);
    }
};

} // End namespace


TEST_P(RoundBodies, nodesFillTheBox)
{
    stateScene scene(randomMesh(GetParam(), 5));
    const scalarField one(scene.nodes().size(), 1.0);
    EXPECT_NEAR
    (
        scene.nodes().integral(one)/depthOf(GetParam()), 1, 1e-13
    );
}


// The sum of the nodes' parts against the formula. A chord of the edge that is
// allowed takes 1e-4 of the volume
TEST_P(RoundBodies, volume)
{
    const scalar R = 0.31;
    stateScene scene(randomMesh(GetParam(), 9));
    const convexBody body(convexBody::round(scene.mesh(), middle(), R));
    const bodyShare share(scene.nodes(), body, nothing);

    EXPECT_EQ(share.part(), 1);
    EXPECT_NEAR(share.volume()/volume(R), 1, 1e-14);
    EXPECT_NEAR(share.correction(), 1, GetParam() == 1 ? 1e-13 : 2e-4);
}


// Smaller than a cell: the nodes around have it all the same
TEST_P(RoundBodies, smallerThanACell)
{
    const scalar R = 0.04;
    stateScene scene(randomMesh(GetParam(), 3));
    const convexBody body(convexBody::round(scene.mesh(), middle(), R));
    const bodyShare share(scene.nodes(), body, nothing);
    EXPECT_NEAR(share.correction(), 1, GetParam() == 1 ? 1e-13 : 2e-4);
    EXPECT_NEAR(share.volume()/volume(R), 1, 1e-14);
    EXPECT_LT(max(share.f()), 1);
}


// A corner of the box at the centre: a half, a quarter, an eighth
TEST_P(RoundBodies, symmetryPlanes)
{
    stateScene scene(randomMesh(GetParam(), 8));
    const convexBody body
    (
        convexBody::round(scene.mesh(), point(0, 0, 0), 0.6)
    );
    const bodyShare share(scene.nodes(), body, nothing);
    EXPECT_EQ(share.part(), std::pow(0.5, GetParam()));
}


// f is 1 a cell's diagonal inside the body, 0 outside, and never beyond; its
// centre is the body's (linear functions are exact) and it is round
TEST_P(RoundBodies, shape)
{
    const label n = 16;
    const label dim = GetParam();
    const scalar R = 0.36;
    boxMesh box(randomMesh(dim, n));
    box.map = [](const point& x) { return x; };
    stateScene scene(box);
    const convexBody body(convexBody::round(scene.mesh(), middle(), R));
    const bodyShare share(scene.nodes(), body, nothing);
    const scalar diagonal = std::sqrt(scalar(dim))/n;

    vector first(Zero);
    symmTensor second(Zero);
    forAll(share.f(), i)
    {
        const scalar f = share.f()[i];
        const scalar outside = body.outside(scene.nodes().x(i));
        EXPECT_GE(f, 0);
        EXPECT_LE(f, 1 + 1e-13);
        if (outside < -diagonal)
        {
            EXPECT_NEAR(f, 1, 1e-13);
        }
        if (outside > diagonal)
        {
            EXPECT_EQ(f, 0);
        }
        const vector d(scene.nodes().x(i) - middle());
        first += scene.nodes().volume()[i]*f*d;
        second += scene.nodes().volume()[i]*f*sqr(d);
    }

    const scalar part = share.volume()/share.correction();
    for (label d = 0; d < dim; ++d)
    {
        // The middle of a plane scene is not at the back, where nodes are
        EXPECT_NEAR(first[d]/(part*R), 0, 1e-4);
    }

    // Second moments R^2/(dim + 2), and at most the square of half a diagonal
    // from the shape functions, which have the direction of the mesh
    const scalar m = R*R/(dim + 2);
    const scalar spread = sqr(0.5*diagonal);
    EXPECT_NEAR(second.xx()/part, m, spread);
    if (dim > 1)
    {
        EXPECT_NEAR(second.yy()/part, m, spread);
        EXPECT_NEAR(second.xy()/part, 0, 0.5*spread);
    }
    if (dim > 2)
    {
        EXPECT_NEAR(second.zz()/part, m, spread);
        EXPECT_NEAR(second.yz()/part, 0, 0.5*spread);
    }
}


TEST(BodyShare, slabIsExact)
{
    stateScene scene(randomMesh(3, 5));
    const vector n(0.36, 0.48, 0.8);
    const convexBody body
    (
        convexBody::Slab(point(0.5, 0.5, 0.5), n, -0.1, 0.13)
    );
    // A second one beside it: both together against the whole
    const convexBody both
    (
        convexBody::Slab(point(0.5, 0.5, 0.5), n, -0.1, 0.4)
    );
    const convexBody rest
    (
        convexBody::Slab(point(0.5, 0.5, 0.5), n, 0.13, 0.4)
    );
    const scalar one = sum(volumeInside(scene.mesh(), body)());
    const scalar two = sum(volumeInside(scene.mesh(), rest)());
    EXPECT_NEAR(one + two, sum(volumeInside(scene.mesh(), both)()), 1e-13);
    EXPECT_GT(one, 0.2);
}


TEST(BodyShare, cylinderInSpace)
{
    stateScene scene(randomMesh(3, 8));
    const convexBody body
    (
        convexBody::Cylinder(point(0, 0.5, 0), vector(0, 0, 2), 0.4)
    );
    const bodyShare share(scene.nodes(), body, nothing);
    EXPECT_EQ(share.part(), 0.5);
    EXPECT_NEAR(share.volume(), 0.5*M_PI*0.16, 1e-12);
}


INSTANTIATE_TEST_SUITE_P(Dimensions, RoundBodies, testing::Values(1, 2, 3));
