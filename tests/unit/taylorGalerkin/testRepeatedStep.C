/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Steps that are repeated from a stored state give the same bits, whatever the
// gas did in between: what iterated coupling rests on

#include "gasCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A blast in a box, off centre
primitive blast(const point& x)
{
    const scalar r2 = sqr(x.x() - 0.3) + sqr(x.y() - 0.6);
    return testGas::state(r2 < 0.04 ? 4e5 : 1e5, Zero, r2 < 0.04 ? 3 : 1.2);
}

struct answer
{
    scalarField p, rho;
    vectorField U;
    pointField x;
    scalar stable, energy;
};

answer answerOf(gasCase& gas)
{
    return answer
    {
        gas.scalars("p"), gas.scalars("rho"), gas.U(), gas.x(),
        gas.gas().stable().deltaT, gas.gas().totals().energy
    };
}

void expectSame(const answer& a, const answer& b, const std::string& where)
{
    EXPECT_EQ(a.p, b.p) << where;
    EXPECT_EQ(a.rho, b.rho) << where;
    EXPECT_EQ(a.U, b.U) << where;
    EXPECT_EQ(a.x, b.x) << where;
    EXPECT_EQ(a.stable, b.stable) << where;
    EXPECT_EQ(a.energy, b.energy) << where;
}

//- Moves the right wall and what is before it; by turns of the walls' normals
//  as well
point bulge(const point& x0, const scalar amount)
{
    return x0 + vector(amount*x0.x()*(1 + 0.3*x0.y()), 0, 0);
}

//- Some steps, their bits; others; the first again
void check(gasSettings s, const scalar firstMotion, const scalar motion)
{
    SCOPED_TRACE(s.schemes);
    s.start = blast;
    gasCase gas(s);
    const scalar dt = 0.2*gas.gas().stable().deltaT;
    const pointField x0(gas.x());
    auto at = [&](const scalar amount)
    {
        pointField x(x0);
        for (point& xi : x)
        {
            xi = bulge(xi, amount);
        }
        return x;
    };
    auto steps = [&](const scalar each)
    {
        for (label i = 1; i <= 3; ++i)
        {
            gas.gas().advance(dt, at(firstMotion + i*each));
        }
    };

    gas.run(4, dt);
    gas.gas().advance(dt, at(firstMotion));
    const answer stored(answerOf(gas));
    gas.gas().storeOldState();

    steps(motion);
    const answer first(answerOf(gas));
    EXPECT_NE(first.p, stored.p);

    // Back, another way, and back again
    gas.gas().restoreOldState();
    expectSame(answerOf(gas), stored, "after going back");
    steps(-0.7*motion - 1e-3);
    gas.gas().restoreOldState();
    steps(motion);
    expectSame(answerOf(gas), first, "repeated");

    // Without reading anything in between
    gas.gas().restoreOldState();
    steps(motion);
    expectSame(answerOf(gas), first, "repeated at once");
}

gasSettings settings(const boxMesh& box, const std::string& schemes)
{
    gasSettings s;
    s.box = box;
    s.schemes = schemes;
    s.allPatches("wall");
    s.boundary["left"] = "farField";
    return s;
}

const std::string fluxCorrected =
    "timeScheme twoStep; shockCapturing fluxCorrected;";

} // End namespace


TEST(RepeatedStep, givesTheSameBitsWithEveryScheme)
{
    const boxMesh box = boxMesh::plane(12, 10);
    check(settings(box, fluxCorrected), 2e-3, 1e-3);
    check
    (
        settings
        (
            box, "timeScheme twoStep; shockCapturing pressureLaplacian;"
        ),
        2e-3, 1e-3
    );
    check
    (
        settings
        (
            box, "timeScheme threeStep; shockCapturing pressureSwitch;"
        ),
        2e-3, 1e-3
    );
}


TEST(RepeatedStep, givesTheSameBitsInEveryDimension)
{
    check(settings(boxMesh::lines(20), fluxCorrected), 2e-3, 1e-3);
    check(settings(boxMesh::space(5, 4, 3), fluxCorrected), 2e-3, 1e-3);
}


TEST(RepeatedStep, givesTheSameBitsWhenTheMeshStartsToMove)
{
    // Stored at rest: parts that still sleep, no last step's motion
    check(settings(boxMesh::plane(40, 4), fluxCorrected), 0, 1e-3);
}


TEST(RepeatedStep, givesTheSameBitsInViscousGasOnMovingWalls)
{
    gasSettings s = settings(boxMesh::plane(12, 10), fluxCorrected);
    s.transport = "mu 0.1; Pr 0.7;";
    s.boundary["right"] = "noSlip";
    s.boundary["top"] = "noSlipT";
    check(s, 2e-3, 1e-3);
}


TEST(RepeatedStep, goingBackToNothingIsAnError)
{
    FatalError.throwExceptions();
    gasSettings s = settings(boxMesh::lines(8), fluxCorrected);
    s.start = blast;
    gasCase gas(s);
    EXPECT_THROW(gas.gas().restoreOldState(), Foam::error);
}
