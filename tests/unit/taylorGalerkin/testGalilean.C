/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Gas and mesh moving together give the pressure and density of both at rest.
// Exact for twoStep, whose fluxes are all of the same state. threeStep carries
// mass and energy with velocities of other times than momentum and is not
// invariant in this sense.

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

struct answer
{
    scalarField p, rho;
    vectorField U;
};

//- Two gases that run into each other, with a blob of density and shear. The
//  pressure is uniform at the start: in the first step the artificial
//  viscosity cannot know the mesh velocity, and here it does not matter.
primitive collision(const point& x)
{
    auto across = [](scalar y) { return y*(1 - y); };
    const scalar blob =
        0.3*std::exp(-(sqr(x.x() - 0.7) + sqr(x.y() - 0.4))/0.02);
    return x.x() < 0.5
      ? testGas::state(1e5, vector(80, 20*across(x.y()), 0), 1.2)
      : testGas::state(1e5, vector(-90, 0, 15*across(x.z())), 0.4*(1 + blob));
}

//- Largest difference between the run at rest and the one that flies along
answer difference
(
    const boxMesh& box,
    const std::string& scheme,
    const word& sides,
    const vector& V,
    const label nSteps
)
{
    answer results[2];
    scalar dt = 0;
    for (const label flies : {0, 1})
    {
        gasSettings s;
        s.box = box;
        s.schemes = scheme + " shockCapturing pressureLaplacian;";
        s.start = [&](const point& x)
        {
            primitive v(collision(x));
            v.U += flies*V;
            return v;
        };
        s.allPatches(sides);
        s.boundary["left"] = "farField";
        s.boundary["right"] = "open";

        gasCase gas(s);
        if (!flies)
        {
            dt = 0.3*gas.gas().stable().deltaT;
        }
        gas.run(nSteps, dt,
            [&](const point& x, scalar t) { return x + flies*t*V; });

        results[flies] =
            answer{gas.scalars("p"), gas.scalars("rho"), gas.U()};
        results[flies].U -= flies*V;
    }
    return answer
    {
        mag(results[1].p/results[0].p - 1),
        mag(results[1].rho/results[0].rho - 1),
        results[1].U - results[0].U
    };
}

const char* twoSteps[] =
{
    "timeScheme twoStep;",
    "timeScheme twoStep; twoStepCoeffs { massMatrix consistent; }"
};

boxMesh of(boxMesh b)
{
    return b.distort(0.1);
}

} // End namespace


// Slip walls alongside, flight along them
TEST(Galilean, twoStepAlongWalls)
{
    const boxMesh boxes[] =
    {
        of(boxMesh::plane(20, 8)), of(boxMesh::space(12, 4, 3))
    };
    for (const boxMesh& box : boxes)
    {
        for (const std::string scheme : twoSteps)
        {
            const answer d =
                difference(box, scheme, "wall", vector(-180, 0, 0), 50);
            EXPECT_LE(max(d.p), 1e-12);
            EXPECT_LE(max(d.rho), 1e-12);
            EXPECT_LE(max(mag(d.U)), 340*1e-12);
        }
    }
}


TEST(Galilean, twoStepObliquely)
{
    const boxMesh boxes[] =
    {
        of(boxMesh::lines(40)), of(boxMesh::plane(20, 8)),
        of(boxMesh::space(12, 4, 3))
    };
    const vector flights[] =
    {
        vector(200, 0, 0), vector(150, 90, 0), vector(120, -90, 110)
    };
    for (label i = 0; i < 3; ++i)
    {
        for (const std::string scheme : twoSteps)
        {
            const answer d =
                difference(boxes[i], scheme, "open", flights[i], 50);
            EXPECT_LE(max(d.p), 1e-12);
            EXPECT_LE(max(d.rho), 1e-12);
            EXPECT_LE(max(mag(d.U)), 340*1e-12);
        }
    }
}
