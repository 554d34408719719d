/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasDynamics/ShockRelations.hpp"
#include "planarShock.H"
#include "stateScene.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

std::string shock(const std::string& numbers)
{
    return
        "machNumber 2.3; point (0.4 0.3 0.5); normal (3 4 0); "
        "ahead { p 1e5; T 290; " + numbers + " }";
}

} // End namespace


// Mass, momentum and energy across the front, in the frame that goes with it
TEST(PlanarShock, jumpConditions)
{
    const gasDynamics::PerfectGas air(stateScene::air());
    stateScene scene(randomMesh(3, 4));
    const vector n(0.6, 0.8, 0);
    const vector Uahead(30, -70, 20);
    const planarShock state
    (
        scene.mesh(),
        dictionary(IStringStream(shock("U (30 -70 20);"))())
    );
    const gasNodes::State one = conservedState(air, 1e5, Uahead, 290);
    const gasNodes::State two = state.behind(air);
    const scalar speed =
        (Uahead & n) + 2.3*air.soundSpeed(1e5, air.density(1e5, 290));

    auto flux = [&](const gasNodes::State& s) -> gasNodes::State
    {
        const vector U(s[1]/s[0], s[2]/s[0], s[3]/s[0]);
        const scalar p = gasDynamics::pressure<3>(air, s);
        gasNodes::State f = ((U & n) - speed)*s;
        for (int d = 0; d < 3; ++d)
        {
            f[d + 1] += p*n[d];
        }
        f[4] += p*(U & n);
        return f;
    };
    const gasNodes::State f1 = flux(one);
    const gasNodes::State f2 = flux(two);
    EXPECT_NEAR(f1[0]/f2[0], 1, 1e-12);
    EXPECT_NEAR((f1 - f2).segment<3>(1).norm()/air.soundSpeed(1, 1)/f1[0], 0,
        1e-10);
    EXPECT_NEAR(f1[4]/f2[4], 1, 1e-12);
    EXPECT_GT(two[0]/one[0], 2);
}


// source: Rankine-Hugoniot relations for Mach 1.21 into air of 1e5 Pa, 293 K
// (R = 287 J/(kg K), gamma = 1.4), the shock tube of Giordano et al. (2005)
TEST(PlanarShock, machOnePointTwoOne)
{
    stateScene scene(boxMesh::plane(10, 3));
    scene.set
    (
        "planarShock",
        "machNumber 1.21; point (0.35 0 0); normal (1 0 0); "
        "ahead { p 1e5; T 293; }"
    );
    const gasNodes& nodes = scene.nodes();
    for (label i = 0; i < nodes.size(); ++i)
    {
        const bool behind = nodes.x(i).x() < 0.35;
        EXPECT_NEAR(nodes.p()[i], behind ? 154145 : 1e5, behind ? 1 : 0);
        EXPECT_NEAR(nodes.U()[i].x(), behind ? 109.669 : 0, 1e-3);
        EXPECT_EQ(nodes.U()[i].y(), 0);
        EXPECT_NEAR
        (
            nodes.T()[i], behind ? 332.3405 : stateScene::T0, 1e-3
        );
    }
}


// Nodes that rounding puts a little in front of the plane are behind it too
TEST(PlanarShock, nodesOnThePlane)
{
    boxMesh box(boxMesh::plane(12, 12));
    stateScene scene(box);
    scene.set
    (
        "planarShock",
        "machNumber 2; point (0.5 0.5 0); normal (1 1 0); "
        "ahead { p 1e5; T 290; }"
    );
    const gasNodes& nodes = scene.nodes();
    label onPlane = 0;
    for (label i = 0; i < nodes.size(); ++i)
    {
        if (mag(nodes.x(i).x() + nodes.x(i).y() - 1) < 1e-6)
        {
            ++onPlane;
            EXPECT_GT(nodes.p()[i], 4e5);
        }
    }
    EXPECT_EQ(onPlane, 13);
}


TEST(PlanarShock, machOneIsNoShock)
{
    stateScene scene(boxMesh::lines(10));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "planarShock",
        "machNumber 1; point (0.5 0 0); normal (1 0 0); "
        "ahead { p 1e5; T 290; }"
    );
    EXPECT_NEAR
    (
        (scene.nodes().total() - before).norm()/before.norm(), 0, 1e-13
    );
}
