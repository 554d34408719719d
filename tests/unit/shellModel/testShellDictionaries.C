/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// What the entries of constant/shellProperties make

#include "shellCase.H"
#include "shellVector.H"

#include <gtest/gtest.h>

#include <map>

using namespace Foam;

namespace
{

struct load
{
    const char* name;
    const char* entries;
    vector total;           // of the force, by hand
};

void PrintTo(const load& l, std::ostream* os) { *os << l.name; }

class Load : public testing::TestWithParam<load> {};

struct constraint
{
    const char* name;
    const char* entries;
    label fewer;            // equations than 7 per node, by hand
};

void PrintTo(const constraint& c, std::ostream* os) { *os << c.name; }

class Constraint : public testing::TestWithParam<constraint> {};

// 3 x 1 quadrilaterals of cubic triangles
constexpr label nU = 10;
constexpr label nV = 4;

} // End namespace


// The strip of area 1 and mass 0.2 in the x-y plane, normal along z
TEST_P(Load, hasTheResultantOfItsEntries)
{
    shellCase made(clamp, GetParam().entries);
    shellModel shell(made.time());
    shell.initialise(positionalShell::Vector::Zero(shell.nDofs()));

    const vector difference
    (
        resultant(shell.externalForce()) - GetParam().total
    );
    EXPECT_LE(mag(difference), 1e-12*mag(GetParam().total))
        << resultant(shell.externalForce()).z();
}


INSTANTIATE_TEST_SUITE_P
(
    Types, Load,
    testing::Values
    (
        load
        {
            "nodal",
            "a { type nodal; nodeSet uMax; force (1 2 3); }",
            nV*vector(1, 2, 3)
        },
        load
        {
            "edge",
            "a { type edge; nodeSet uMax; forcePerLength (1 2 3); }",
            0.5*vector(1, 2, 3)
        },
        load
        {
            "edgeWithFactor",
            "a { type edge; nodeSet uMax; forcePerLength (1 2 3);"
            " factor polynomial ((4 0) (1 1)); }",
            2.0*vector(1, 2, 3)
        },
        load
        {
            "traction",
            "a { type traction; traction (1 2 3); }",
            vector(1, 2, 3)
        },
        load
        {
            "deadPressure",
            "a { type deadPressure; elementSet all; pressure 5; }",
            vector(0, 0, -5)
        },
        load
        {
            "followerPressure",
            "a { type followerPressure; pressure 5; face upper; }",
            vector(0, 0, -5)
        },
        load
        {
            "gravity",
            "a { type gravity; g (0 0 -9.81); }",
            0.2*vector(0, 0, -9.81)
        },
        load
        {
            "two",
            "a { type gravity; g (1 0 0); } b { type gravity; g (0 1 0); }",
            0.2*vector(1, 1, 0)
        }
    )
);


// Off the mid-surface the force reaches the directors with its lever arm h/2
TEST(FollowerPressure, actsOnItsFace)
{
    const std::map<std::string, scalar> arms
    {
        {"", 0}, {"face middle;", 0}, {"face upper;", 0.05},
        {"face lower;", -0.05}
    };
    for (const auto& [face, arm] : arms)
    {
        shellCase made
        (
            clamp, "a { type followerPressure; pressure 5; " + face + " }"
        );
        shellModel shell(made.time());
        shell.initialise(positionalShell::Vector::Zero(shell.nDofs()));

        const scalarField onDirectors
        (
            nodeScalars(shell.externalForce(), positionalShell::Component::gz)
        );
        EXPECT_NEAR(sum(onDirectors), -5*arm, 1e-12) << face;
    }
}


TEST_P(Constraint, leavesTheEquationsOfItsEntries)
{
    shellCase made(GetParam().entries, "");
    shellModel shell(made.time());
    EXPECT_EQ
    (
        label(shell.model().dofs().nEquations()),
        7*nU*nV - GetParam().fewer
    );
}


INSTANTIATE_TEST_SUITE_P
(
    Types, Constraint,
    testing::Values
    (
        constraint{"none", "", 0},
        constraint{"clamped", clamp, 6*nV},
        constraint{"hinged", "a { type hinged; nodeSet uMin; }", 3*nV},
        constraint
        {
            "symmetryPlane",
            "a { type symmetryPlane; nodeSet vMin; normal (0 1 0); }", 2*nU
        },
        constraint
        {
            "fixed",
            "a { type fixed; nodeSet uMax; components (x gz a); }", 3*nV
        },
        constraint
        {
            "prescribed",
            "a { type prescribed; nodeSet uMax; component z;"
            " displacement 0.1; }",
            nV
        },
        constraint
        {
            "tied",
            "a { type tied; nodeSet uMax; component z; }", nV - 1
        },
        constraint
        {
            "planeStrainStrip",
            "a { type planeStrainStrip; direction (0 1 0); }", 7*nU*nV - 5*nU
        }
    )
);


TEST(ShellModel, knowsItsPlaneStrainStrip)
{
    shellCase made("a { type planeStrainStrip; direction (0 1 0); }", "");
    const shellModel shell(made.time());
    EXPECT_TRUE(shell.planeStrain());
    EXPECT_EQ(shell.stripDirection(), vector(0, 1, 0));
    EXPECT_DOUBLE_EQ(shell.stripWidth(), 0.5);
}


TEST(ShellModel, withoutStripHasNoWidth)
{
    shellCase made(clamp, "");
    const shellModel shell(made.time());
    EXPECT_FALSE(shell.planeStrain());
    EXPECT_EQ(shell.stripWidth(), 0);
}


TEST(ShellModel, isFoundOnTime)
{
    shellCase made(clamp, "");
    const shellModel shell(made.time());
    EXPECT_EQ(made.time->findObject<shellModel>("shellModel"), &shell);
    EXPECT_TRUE(shellModel::declared(made.time()));
}
