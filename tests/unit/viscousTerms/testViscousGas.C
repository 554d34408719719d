/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The viscous gas as a whole: what is conserved, what stays uniform, its
// stable step, its walls

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

struct scheme
{
    const char* name;
    const char* entries;
};

const scheme schemes[] =
{
    {"none", "timeScheme twoStep; shockCapturing none;"},
    {"consistent",
        "timeScheme twoStep; twoStepCoeffs { massMatrix consistent; }"
        " shockCapturing none;"},
    {"pressureSwitch", "timeScheme twoStep; shockCapturing pressureSwitch;"},
    {"fluxCorrected", "timeScheme twoStep; shockCapturing fluxCorrected;"},
    {"threeStep", "timeScheme threeStep; shockCapturing none;"}
};

//- Cell Reynolds numbers of about one at the speed of sound
const std::string sticky = "mu 20; Pr 0.7;";

boxMesh boxes(const label dim)
{
    switch (dim)
    {
        case 1: return boxMesh::lines(30);
        case 2: return boxMesh::plane(10, 8).distort(0.15);
        default: return boxMesh::space(5, 4, 4).distort(0.1);
    }
}

primitive swirl(const point& x)
{
    return testGas::state
    (
        1e5*(1 + 0.1*std::sin(3*x.x() + x.y())),
        vector
        (
            40*std::cos(4*x.y()), 30*std::sin(3*x.x()), 20*std::cos(5*x.x())
        ),
        1.2*(1 + 0.1*std::cos(2*x.x() - x.z()))
    );
}

class ViscousBox
:
    public testing::TestWithParam<std::tuple<scheme, label>>
{
protected:

    gasSettings settings(const word& walls) const
    {
        gasSettings s;
        s.box = boxes(std::get<1>(GetParam()));
        s.schemes = std::get<0>(GetParam()).entries;
        s.start = swirl;
        s.transport = sticky;
        s.allPatches(walls);
        return s;
    }
};

} // End namespace


TEST_P(ViscousBox, keepsMassAndEnergyBetweenAdiabaticWalls)
{
    for (const word walls : {"wall", "noSlip"})
    {
        gasCase box(settings(walls));
        const gasTotals before = box.gas().totals();
        box.run(50, 0.5*box.gas().stable().deltaT);
        const gasTotals after = box.gas().totals();
        EXPECT_NEAR(after.mass/before.mass, 1, 1e-13) << walls;
        EXPECT_NEAR(after.energy/before.energy, 1, 1e-13) << walls;
    }
}


TEST_P(ViscousBox, sticksToItsWallsAndTakesTheirTemperature)
{
    gasSettings s(settings("noSlip"));
    s.boundary["left"] = "noSlipT";
    gasCase box(s);
    const gasTotals before = box.gas().totals();
    const scalarField start(box.scalars("T"));
    box.run(20, 0.5*box.gas().stable().deltaT);
    EXPECT_NEAR(box.gas().totals().mass/before.mass, 1, 1e-13);
    EXPECT_GT(mag(box.gas().totals().energy/before.energy - 1), 1e-9);

    const scalarField T(box.scalars("T"));
    const vectorField U(box.U());
    for (const label i : box.gas().mesh().patch("left").nodes)
    {
        EXPECT_NEAR(T[i]/start[i], 1, 1e-12);
        EXPECT_LE(mag(U[i]), 1e-12);
    }
    for (const label i : box.gas().mesh().patch("right").nodes)
    {
        EXPECT_LE(mag(U[i]), 1e-12);
    }
    EXPECT_GT(max(mag(U)), 1);
}


// The left wall goes in and out and takes the mesh along
TEST_P(ViscousBox, keepsMassWithAMovingWall)
{
    gasCase box(settings("noSlip"));
    const scalar mass = box.gas().totals().mass;
    const scalar dt = 0.3*box.gas().stable().deltaT;
    auto wall = [=](scalar t) { return 0.02*std::sin(t/(30*dt)); };
    box.run
    (
        60, dt,
        [=](const point& x, scalar t)
        {
            return point(x.x() + wall(t)*(1 - x.x()), x.y(), x.z());
        }
    );
    EXPECT_NEAR(box.gas().totals().mass/mass, 1, 1e-12);
    const scalar speed = (wall(60*dt) - wall(59*dt))/dt;
    const vectorField U(box.U());
    for (const label i : box.gas().mesh().patch("left").nodes)
    {
        EXPECT_NEAR(U[i].x()/speed, 1, 1e-9);
        EXPECT_LE(mag(U[i].y()) + mag(U[i].z()), 1e-9);
    }
}


// On a mesh all of whose points move at random
TEST_P(ViscousBox, uniformFlowStaysUniform)
{
    const primitive uniform(testGas::state(1e5, vector(150, -80, 60), 1.2));
    gasSettings s(settings("farField"));
    s.start = [&](const point&) { return uniform; };
    gasCase box(s);
    taylorGalerkinGas& gas = box.gas();
    const scalar dt = 0.2*gas.stable().deltaT;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-0.06, 0.06);
    const pointField x0(box.x());
    for (label step = 0; step < 20; ++step)
    {
        pointField x(x0);
        for (point& xi : x)
        {
            for (const direction axis : gas.mesh().axes())
            {
                xi[axis] += some(random)*s.box.size[axis]/s.box.n[axis];
            }
        }
        gas.advance(dt, x);
    }
    EXPECT_LE(largest(box.scalars("p")/uniform.p - 1), 1e-12);
    EXPECT_LE(largest(box.scalars("T")/uniform.T - 1), 1e-12);
}


INSTANTIATE_TEST_SUITE_P
(
    All, ViscousBox,
    testing::Combine(testing::ValuesIn(schemes), testing::Values(1, 2, 3)),
    [](const auto& info)
    {
        return
            std::string(std::get<0>(info.param).name) + "_"
          + std::to_string(std::get<1>(info.param)) + "d";
    }
);


// (G12) and (G66) on a line, by hand
TEST(ViscousStep, isThatOfALine)
{
    gasSettings s;
    s.box = boxMesh::lines(10);
    s.start = [](const point&)
    {
        return testGas::state(1e5, vector::zero, 1.2);
    };
    s.transport = "mu 20; Pr 0.7;";
    const scalar h = 0.1, c = std::sqrt(1.4*1e5/1.2);
    const scalar a = c/h, d = 2*(1.4*20/0.7/1.2)/sqr(h);
    gasCase none(s);
    EXPECT_NEAR
    (
        none.gas().stable().deltaT/(2/(d + std::sqrt(d*d + 4*a*a))), 1, 1e-12
    );
    s.schemes = "timeScheme twoStep; shockCapturing fluxCorrected;";
    gasCase limited(s);
    EXPECT_NEAR(limited.gas().stable().deltaT*(a + d), 1, 1e-12);
}


namespace
{

//- The error that a case stops with
std::string errorOf(const gasSettings& s)
{
    try
    {
        gasCase gas(s);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}

void expectError(const gasSettings& s, const std::string& part)
{
    const std::string message(errorOf(s));
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

} // End namespace


TEST(NoSlipWalls, refuseWhatDoesNotGoTogether)
{
    gasSettings s;
    s.box = boxMesh::plane(3, 3);
    s.start = [](const point&)
    {
        return testGas::state(1e5, vector(10, 0, 0), 1.2);
    };
    s.boundary["bottom"] = "noSlip";
    expectError(s, "the gas is inviscid");
    s.transport = sticky;
    EXPECT_EQ(errorOf(s), "");

    // On a patch of type wall fixedValue is no-slip, and p is free there
    s.boundary.clear();
    s.boundary["bottom"] = "fixedValue";
    EXPECT_EQ(errorOf(s), "");
    s.box.types[2] = "wall";
    expectError(s, "p is prescribed");
}
