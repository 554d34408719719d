/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The stable step against what can be said by hand, eqs. (G10)-(G12)

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

gasSettings uniform(const boxMesh& box, const vector& U)
{
    gasSettings s;
    s.box = box;
    s.start = [=](const point&) { return testGas::state(1e5, U, 1.2); };
    return s;
}

const scalar c = std::sqrt(1.4*1e5/1.2);

} // End namespace


TEST(StableStep, courantNumberOfALine)
{
    gasCase gas(uniform(boxMesh::lines(10), vector(-50, 0, 0)));
    EXPECT_NEAR(gas.gas().stable().deltaT/(0.1/(50 + c)), 1, 1e-12);
    EXPECT_EQ(gas.gas().stable().diffusion, 0);
}


// Squares of side h whose diagonals alternate: at a wall, where no diagonal
// ends, the dual volume is h^2/3, two dual faces sqrt(5)/6 h and one 2/3 h. Gas
// at rest: c h^2 over the sum of half wave speeds.
TEST(StableStep, sumOfWaveSpeedsOfTriangles)
{
    gasCase plane(uniform(boxMesh::plane(10, 10), vector::zero));
    EXPECT_NEAR
    (
        plane.gas().stable().deltaT/(0.1/c*2/(std::sqrt(5.0) + 2)), 1, 1e-12
    );
}


// Cubes of side h: inside h/(3 c) as on hexahedra, less at the walls
TEST(StableStep, sumOfWaveSpeedsOfTetrahedra)
{
    gasCase space(uniform(boxMesh::space(4, 4, 4), vector::zero));
    const scalar relative = space.gas().stable().deltaT/(0.25/c);
    EXPECT_LE(relative, 1.0/3);
    EXPECT_GE(relative, 0.25);
}


TEST(StableStep, isAtTheSmallestCell)
{
    gasSettings s(uniform(boxMesh::lines(10), vector::zero));
    s.box.map = [](const point& x)
    {
        return mag(x.x() - 0.5) < 1e-6 ? x + vector(0.06, 0, 0) : x;
    };
    gasCase gas(s);
    const stableStep& stable = gas.gas().stable();
    // Half of the cells 0.04 and 0.1 on both sides
    EXPECT_NEAR(stable.deltaT/(0.07/c), 1, 1e-9);
    EXPECT_NEAR(stable.position.x(), 0.6, 1e-9);
}


TEST(StableStep, usesTheVelocityRelativeToTheMesh)
{
    const vector V(200, 0, 0);
    gasCase gas(uniform(boxMesh::lines(10), V));
    gas.run(2, 1e-5, [&](const point& x, scalar t) { return x + t*V; });
    EXPECT_NEAR(gas.gas().stable().deltaT/(0.1/c), 1, 1e-9);

    // at rest again
    gas.run(1, 1e-5);
    EXPECT_NEAR(gas.gas().stable().deltaT/(0.1/(200 + c)), 1, 1e-9);
}


// With artificial viscosity dt is the root of (dt a)^2 + dt d = 1; a and d from
// the finite difference formulas of the line
TEST(StableStep, artificialViscosityHasItsOwnLimit)
{
    const label n = 12;
    const scalar h = 1.0/n, q = 1.7;
    auto pressure = [](scalar x) { return x < 0.5 ? 1e6 : 1e5 + 2e4*x; };
    gasSettings s;
    s.box = boxMesh::lines(n);
    s.schemes = "timeScheme twoStep; shockCapturing pressureLaplacian;"
        " pressureLaplacianCoeffs { qDif 1.7; }";
    s.start = [&](const point& x)
    {
        return testGas::state(pressure(x.x()), vector(30, 0, 0), 1.2);
    };
    gasCase gas(s);

    std::vector<scalar> p(n + 1), speed(n + 1), mu(n + 1);
    for (label i = 0; i <= n; ++i)
    {
        p[i] = pressure(i*h);
        speed[i] = 30 + std::sqrt(1.4*p[i]/1.2);
    }
    // The ends have half a cell and one neighbour
    auto volume = [=](label i) { return i == 0 || i == n ? h/2 : h; };
    for (label i = 0; i <= n; ++i)
    {
        const scalar laplacian =
        (
            (i > 0 ? p[i - 1] - p[i] : 0) + (i < n ? p[i + 1] - p[i] : 0)
        )/(h*volume(i));
        mu[i] = q*pow3(h)*speed[i]*mag(laplacian)/p[i];
    }
    scalar least = GREAT;
    for (label i = 0; i <= n; ++i)
    {
        scalar a = 0, d = 0;
        for (const label j : {i - 1, i + 1})
        {
            if (j >= 0 && j <= n)
            {
                a += max(speed[i], speed[j])/2/volume(i);
                d += (mu[i] + mu[j])/2/h/volume(i);
            }
        }
        least = min(least, (-d + std::sqrt(d*d + 4*a*a))/(2*a*a));
    }
    EXPECT_NEAR(gas.gas().stable().deltaT/least, 1, 1e-10);
    EXPECT_LT(gas.gas().stable().deltaT, 0.8*h/speed[0]);
}
