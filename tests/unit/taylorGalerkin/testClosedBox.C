/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Mass and energy in boxes with slip walls, at rest and in motion

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
    {"lumped", "timeScheme twoStep; shockCapturing pressureLaplacian;"},
    {"consistent",
        "timeScheme twoStep; twoStepCoeffs { massMatrix consistent; }"
        " shockCapturing pressureLaplacian;"},
    {"pressureSwitch", "timeScheme twoStep; shockCapturing pressureSwitch;"},
    {"fluxCorrected", "timeScheme twoStep; shockCapturing fluxCorrected;"},
    {"threeStep", "timeScheme threeStep; shockCapturing pressureLaplacian;"}
};

boxMesh boxes(const label dim)
{
    switch (dim)
    {
        case 1: return boxMesh::lines(30);
        case 2: return boxMesh::plane(12, 10).distort(0.15);
        default: return boxMesh::space(6, 5, 4).distort(0.1);
    }
}

//- A smooth blast off the centre
primitive blast(const point& x)
{
    const point centre(0.3, 0.4, 0.6);
    const scalar r2 =
        sqr(x.x() - centre.x())
      + (x.y() > 0.11 || x.z() > 0.11 ? magSqr(x - centre) : 0);
    const scalar bump = std::exp(-r2/0.02);
    return testGas::state(1e5*(1 + 2*bump), vector::zero, 1.2*(1 + bump));
}

class ClosedBox
:
    public testing::TestWithParam<std::tuple<scheme, label>>
{
protected:

    gasSettings settings() const
    {
        gasSettings s;
        s.box = boxes(std::get<1>(GetParam()));
        s.schemes = std::get<0>(GetParam()).entries;
        s.start = blast;
        s.allPatches("wall");
        return s;
    }
};

} // End namespace


TEST_P(ClosedBox, keepsMassAndEnergy)
{
    gasCase box(settings());
    const gasTotals before = box.gas().totals();
    box.run(100, 0.3*box.gas().stable().deltaT);
    const gasTotals after = box.gas().totals();
    EXPECT_NEAR(after.mass/before.mass, 1, 1e-13);
    EXPECT_NEAR(after.energy/before.energy, 1, 1e-13);

    // The blast has moved the gas
    EXPECT_GT(max(mag(box.U())), 5);
}


// The end wall oscillates at up to half the speed of sound and takes the mesh
// along
TEST_P(ClosedBox, keepsMassWithAMovingWall)
{
    gasCase box(settings());
    const scalar mass = box.gas().totals().mass;
    const scalar dt = 0.2*box.gas().stable().deltaT;
    const scalar period = 200*dt;
    box.run
    (
        260, dt,
        [=](const point& x, scalar t)
        {
            const scalar s = 0.1*std::sin(2*M_PI*t/period);
            return point(x.x()*(1 - s), x.y(), x.z());
        }
    );
    EXPECT_NEAR(box.gas().totals().mass/mass, 1, 1e-12);
    EXPECT_GT(max(mag(box.U())), 10);
}


// Compressed slowly by a tenth: p V^gamma and the energy that goes with it
TEST_P(ClosedBox, compressedSlowlyIsIsentropic)
{
    gasSettings s(settings());
    s.start = [](const point&)
    {
        return testGas::state(1e5, vector::zero, 1.2);
    };
    gasCase box(s);
    const gasTotals before = box.gas().totals();
    const scalar dt = 0.4*box.gas().stable().deltaT;
    const label n = 1500;
    const scalar last = n*dt;
    box.run
    (
        n, dt,
        [=](const point& x, scalar t)
        {
            // starts and ends at rest
            const scalar s = t/last;
            const scalar done = s*s*(3 - 2*s);
            return point(x.x()*(1 - 0.1*done), x.y(), x.z());
        }
    );
    const scalar ratio = std::pow(0.9, -testGas::gamma);
    EXPECT_LE(largest(box.scalars("p")/(1e5*ratio) - 1), 2e-3);
    EXPECT_NEAR
    (
        box.gas().totals().energy/before.energy, 0.9*ratio, 1e-3
    );
}


INSTANTIATE_TEST_SUITE_P
(
    All, ClosedBox,
    testing::Combine(testing::ValuesIn(schemes), testing::Values(1, 2, 3)),
    [](const auto& info)
    {
        return
            std::string(std::get<0>(info.param).name) + "_"
          + std::to_string(std::get<1>(info.param)) + "d";
    }
);
