/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Mass and energy of a charge on meshes of all kinds: (I3), (I4)

#include "sphericalCharge.H"
#include "stateScene.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Gain of the scene over what it should gain, less one; mass and energy
void expectGain
(
    stateScene& scene,
    const gasNodes::State& before,
    const scalar mass,
    const scalar energy
)
{
    const gasNodes::State gain = scene.nodes().total() - before;
    EXPECT_NEAR(gain[0]/mass, 1, 1e-11);
    EXPECT_NEAR(gain[4]/energy, 1, 1e-11);
    EXPECT_NEAR(gain.segment<3>(1).norm(), 0, 1e-9);
}

class Charges : public testing::TestWithParam<label>
{
protected:

    scalar volume(const scalar R) const
    {
        const scalar unit[] = {0, 2, M_PI, 4*M_PI/3};
        return
            unit[GetParam()]*std::pow(R, GetParam())*depthOf(GetParam());
    }
};

} // End namespace


TEST_P(Charges, stateAndRadius)
{
    stateScene scene(randomMesh(GetParam(), 8));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.48 0.53); radius 0.3; p 2967e3; T 1134.85;"
    );
    const gasNodes::State inside = conservedState
    (
        stateScene::air(), 2967e3, vector::zero, 1134.85
    );
    const gasNodes::State excess = inside - stateScene::still();
    expectGain(scene, before, excess[0]*volume(0.3), excess[4]*volume(0.3));

    // Nothing beyond the state given, but by the factor for exact totals
    EXPECT_LE(max(scene.nodes().p()), 2967e3*(1 + 2e-4));
    EXPECT_GE(min(scene.nodes().p()), stateScene::p0*(1 - 1e-12));
}


// An eighth (a half of a line, a quarter of a plane scene): mass and energy
// given are those of the whole
TEST_P(Charges, massAndEnergyOfAPart)
{
    stateScene scene(randomMesh(GetParam(), 7));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        "centre (0 0 0); radius 0.45; mass 2; energy 4e6;"
    );
    const scalar part = std::pow(0.5, GetParam());
    const gasNodes::State air = volume(0.45)*stateScene::still();
    expectGain(scene, before, part*(2 - air[0]), part*(4e6 - air[4]));
}


TEST_P(Charges, massAndDensity)
{
    const scalar R = 0.2;
    const scalar mass = 30*volume(R);
    stateScene scene(randomMesh(GetParam(), 6));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        "centre (0.4 0.5 0.5); density 30; energy 1e5; mass "
      + std::string(Foam::name(mass)) + ";"
    );
    // The dictionary has six digits of the mass
    const scalar given = readScalar(Foam::name(mass));
    const gasNodes::State air = given/30*stateScene::still();
    expectGain(scene, before, given - air[0], 1e5 - air[4]);
}


// In gas that is not uniform the charge takes the place of what is there
TEST_P(Charges, overAnotherCharge)
{
    stateScene scene(randomMesh(GetParam(), 8));
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); radius 0.4; p 5e5; T 400;"
    );
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); radius 0.15; p 1e4; T 300;"
    );
    const gasDynamics::PerfectGas air(stateScene::air());
    const scalar change =
        (1e4 - 5e5)/0.4*volume(0.15);
    // Only nodes of the first charge alone have been changed
    EXPECT_NEAR((scene.nodes().total() - before)[4]/change, 1, 3e-4);
    EXPECT_GT(min(scene.nodes().p()), 0);
}


// A uniform factor: nodes inside all have the same state
TEST(SphericalCharge, uniformInside)
{
    stateScene scene(randomMesh(3, 12));
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); radius 0.4; p 1e6; T 500; U (10 0 0);"
    );
    const gasNodes& nodes = scene.nodes();
    label inside = 0;
    for (label i = 0; i < nodes.size(); ++i)
    {
        if (mag(nodes.x(i) - point(0.5, 0.5, 0.5)) < 0.2)
        {
            ++inside;
            EXPECT_NEAR(nodes.p()[i]/1e6, 1, 3e-4);
            EXPECT_NEAR(nodes.p()[i]/max(nodes.p()), 1, 1e-11);
            EXPECT_NEAR(nodes.U()[i].x(), 10, 1e-2);
        }
    }
    EXPECT_GT(inside, 20);
}


// On a regular mesh, symmetric about the centre: opposite nodes see the same
TEST(SphericalCharge, symmetric)
{
    boxMesh box(boxMesh::space(10, 10, 10));
    box.kind = boxMesh::tetrahedra;
    stateScene scene(box);
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); radius 0.3; p 1e6; T 500;"
    );
    const gasNodes& nodes = scene.nodes();
    const labelList& nodeOfPoint = scene.mesh().nodeOfPoint();
    forAll(nodeOfPoint, i)
    {
        // Points of a box in memory are numbered from one corner to the other
        const label opposite = nodeOfPoint[nodeOfPoint.size() - 1 - i];
        EXPECT_NEAR(nodes.p()[nodeOfPoint[i]]/nodes.p()[opposite], 1, 1e-3);
    }
}


// A plane cuts the ball off the centre: the cap's volume, given as fraction
TEST(SphericalCharge, givenFraction)
{
    const scalar R = 0.4;
    const scalar d = 0.1;           // wall to centre
    const scalar cap = M_PI*sqr(R - d)*(2*R + d)/3;
    const scalar ball = 4*M_PI/3*pow3(R);
    const std::string charge
    (
        "centre (0.1 0.5 0.5); radius 0.4; p 1e6; T 500; "
    );

    stateScene scene(randomMesh(3, 8));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        charge + "fraction " + std::to_string(1 - cap/ball) + ";"
    );
    const gasNodes::State excess =
        conservedState(stateScene::air(), 1e6, vector::zero, 500)
      - stateScene::still();
    const gasNodes::State gain = scene.nodes().total() - before;
    EXPECT_NEAR(gain[0]/(excess[0]*(ball - cap)), 1, 1e-5);

    const std::string message = scene.errorOf("sphericalCharge", charge);
    EXPECT_NE(message.find("fraction"), std::string::npos) << message;
    EXPECT_NE(message.find("0.68"), std::string::npos) << message;
}


// (I8): the scene gains the charge's energy, and its mass less the air's, also
// by an eighth of it; the default radius is that of 1600 kg/m3
TEST(TntCharge, massAndEnergy)
{
    for (const bool eighth : {false, true})
    {
        stateScene scene(randomMesh(3, 10));
        const gasNodes::State before = scene.nodes().total();
        const std::string centre
        (
            eighth ? "centre (0 0 0);" : "centre (0.5 0.5 0.45);"
        );
        scene.set
        (
            "sphericalCharge", centre + "TNT { mass 2; radius 0.4; }"
        );
        const scalar part = eighth ? 0.125 : 1;
        const scalar air =
            4*M_PI/3*pow3(0.4)*stateScene::still()[0];
        expectGain(scene, before, part*(2 - air), part*2*4.52e6);
    }
}


TEST(TntCharge, radiusRule)
{
    const scalar mass = 80;
    const scalar radius = std::cbrt(3*mass/(4*M_PI*1600));
    stateScene scene(randomMesh(3, 8));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); TNT { mass 80; specificEnergy 1e6; }"
    );
    const scalar air =
        4*M_PI/3*pow3(radius)*stateScene::still()[0];
    expectGain(scene, before, mass - air, mass*1e6);
    const scalar p = 0.4*1600*1e6 + stateScene::p0;
    EXPECT_LE(max(scene.nodes().p()), p*(1 + 3e-4));
}


// (I9): gathered air for a compact charge, the radius for a large bulb
TEST(TntCharge, nearField)
{
    stateScene scene(randomMesh(3, 3));
    const auto least = [&](const std::string& entries)
    {
        return tntCharge
        (
            scene.mesh(), dictionary(IStringStream(entries)())
        ).leastScaledDistance(1.2);
    };
    EXPECT_NEAR(least("mass 8;"), std::cbrt(30/(4*M_PI*1.2)), 1e-12);
    EXPECT_NEAR(least("mass 8; radius 1;"), 2.5, 1e-12);
}


INSTANTIATE_TEST_SUITE_P(Dimensions, Charges, testing::Values(1, 2, 3));
