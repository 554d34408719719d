/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Uniform flow on a mesh all of whose nodes move at random in every step,
// boundary included, stays uniform to round-off

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
    {"threeStep", "timeScheme threeStep; shockCapturing pressureLaplacian;"},
    {"threeStepTheta1",
        "timeScheme threeStep; threeStepCoeffs { theta 1; }"
        " shockCapturing pressureLaplacian;"},
    {"threeStepPrinted",
        "timeScheme threeStep; threeStepCoeffs { energyFlux printed; }"
        " shockCapturing pressureLaplacian;"}
};

struct shape
{
    const char* name;
    boxMesh box;

    //- Largest displacement, in cells
    scalar amplitude;
};

boxMesh of(boxMesh b, boxMesh::cellKind kind)
{
    b.kind = kind;
    b.shuffle = 3;
    return b.distort(0.1);
}

const shape shapes[] =
{
    {"lines", of(boxMesh::lines(12), boxMesh::hexahedra), 0.25},
    {"triangles", of(boxMesh::plane(5, 6), boxMesh::hexahedra), 0.12},
    {"tetrahedra", of(boxMesh::space(3, 4, 3), boxMesh::hexahedra), 0.06}
};

class FreeStream
:
    public testing::TestWithParam<std::tuple<scheme, shape, const char*>>
{};

} // End namespace


TEST_P(FreeStream, staysUniform)
{
    const shape& s = std::get<1>(GetParam());
    const primitive uniform(testGas::state(1e5, vector(150, -80, 60), 1.2));
    const scalar c = testGas::soundSpeed(uniform.T);

    gasSettings settings;
    settings.box = s.box;
    settings.schemes = std::get<0>(GetParam()).entries;
    settings.start = [&](const point&) { return uniform; };
    settings.allPatches(std::get<2>(GetParam()));
    gasCase gasOnMesh(settings);
    taylorGalerkinGas& gas = gasOnMesh.gas();

    const scalar dt = 0.2*gas.stable().deltaT;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-s.amplitude, s.amplitude);
    const pointField x0(gasOnMesh.x());
    scalar fastest = 0;
    for (label step = 0; step < 60; ++step)
    {
        pointField x(x0);
        for (point& xi : x)
        {
            for (const direction axis : gas.mesh().axes())
            {
                xi[axis] +=
                    some(random)*s.box.size[axis]/s.box.n[axis];
            }
        }
        fastest = max(fastest, max(mag(x - gasOnMesh.x()))/dt);
        gas.advance(dt, x);
    }

    // The mesh moves as fast as sound, or the test says little
    EXPECT_GT(fastest, 0.5*c);

    EXPECT_LE(largest(gasOnMesh.scalars("p")/uniform.p - 1), 1e-12);
    EXPECT_LE(largest(gasOnMesh.scalars("T")/uniform.T - 1), 1e-12);
    const vectorField U(gasOnMesh.U());
    for (const direction axis : gas.mesh().axes())
    {
        EXPECT_LE(largest(U.component(axis) - uniform.U[axis]), 1e-12*c);
    }
}


INSTANTIATE_TEST_SUITE_P
(
    All, FreeStream,
    testing::Combine
    (
        testing::ValuesIn(schemes),
        testing::ValuesIn(shapes),
        testing::Values("open", "farField", "fixedValue")
    ),
    [](const auto& info)
    {
        return
            std::string(std::get<0>(info.param).name) + "_"
          + std::get<1>(info.param).name + "_" + std::get<2>(info.param);
    }
);
