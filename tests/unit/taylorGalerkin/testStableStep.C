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


// The least height of a right triangle of legs h is h/sqrt(2); in a cube that
// is cut into six it is h/sqrt(2) as well
TEST(StableStep, leastHeightOfTrianglesAndTetrahedra)
{
    gasCase plane(uniform(boxMesh::plane(10, 10), vector(30, 40, 0)));
    EXPECT_NEAR
    (
        plane.gas().stable().deltaT/(0.1/std::sqrt(2.0)/(50 + c)), 1, 1e-12
    );

    boxMesh box(boxMesh::space(4, 4, 4));
    box.kind = boxMesh::tetrahedra;
    gasCase space(uniform(box, vector(0, 30, 40)));
    EXPECT_NEAR
    (
        space.gas().stable().deltaT/(0.25/std::sqrt(2.0)/(50 + c)), 1, 1e-12
    );
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
    EXPECT_NEAR(stable.deltaT/(0.04/c), 1, 1e-9);
    EXPECT_NEAR(gas.x()[stable.node].x(), 0.58, 0.021);
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

    std::vector<scalar> p(n + 1), speed(n + 1), laplacian(n + 1), mu(n);
    for (label i = 0; i <= n; ++i)
    {
        p[i] = pressure(i*h);
        speed[i] = 30 + std::sqrt(1.4*p[i]/1.2);
    }
    for (label i = 0; i <= n; ++i)
    {
        // The ends have half a cell and one neighbour
        laplacian[i] =
            i == 0 ? 2*(p[1] - p[0])/sqr(h)
          : i == n ? 2*(p[n - 1] - p[n])/sqr(h)
          : (p[i - 1] - 2*p[i] + p[i + 1])/sqr(h);
    }
    for (label i = 0; i < n; ++i)
    {
        mu[i] = q*pow3(h)*(speed[i] + speed[i + 1])/2
           *(mag(laplacian[i]) + mag(laplacian[i + 1]))/2
           /((p[i] + p[i + 1])/2);
    }
    scalar least = GREAT;
    for (label i = 1; i < n; ++i)
    {
        const scalar a = max(max(speed[i - 1], speed[i]), speed[i + 1])/h;
        const scalar d = (mu[i - 1] + mu[i])/sqr(h);
        least = min(least, (-d + std::sqrt(d*d + 4*a*a))/(2*a*a));
    }
    EXPECT_NEAR(gas.gas().stable().deltaT/least, 1, 1e-10);
    EXPECT_LT(gas.gas().stable().deltaT, 0.8*h/speed[0]);
}
