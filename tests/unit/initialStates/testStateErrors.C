/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// What a user reads who mistypes a state

#include "stateScene.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

struct mistake
{
    const char* type;
    const char* entries;
    std::vector<std::string> words;
};

const mistake mistakes[] =
{
    {"planarShok", "machNumber 2;",
        {"planarShok", "mappedProfile", "planarShock", "sphericalCharge"}},
    {"planarShock",
        "point (0 0 0); normal (1 0 0); ahead { p 1; T 1; }",
        {"machNumber"}},
    {"planarShock",
        "machNumber 0.9; point (0 0 0); normal (1 0 0); ahead { p 1; T 1; }",
        {"machNumber", "0.9", "at least 1"}},
    {"planarShock",
        "machNumber 2; point (0 0 0); normal (1 0 0); ahead { p -1; T 1; }",
        {"p is -1", "greater than 0"}},
    {"planarShock",
        "machNumber 2; point (0 0 0); normal (1 0 0); ahead { p 1; T 0; }",
        {"T is 0", "greater than 0"}},
    {"planarShock",
        "machNumber 2; point (0 0 0); normal (1 0 1); ahead { p 1; T 1; }",
        {"normal", "2-dimensional"}},
    {"planarShock",
        "machNumber 2; point (0 0 0); normal (0 0 0); ahead { p 1; T 1; }",
        {"normal", "no direction"}},
    {"planarShock",
        "machNumber 2; point (0 0 0); normal (1 0 0); "
        "ahead { p 1; T 1; V 1; }",
        {"Unknown keyword V", "(p T U)"}},
    {"sphericalCharge", "radius 1; p 1; T 1;", {"centre"}},
    {"sphericalCharge", "centre (0 0 0); radius 1; T 1;", {"p"}},
    {"sphericalCharge", "centre (0 0 0); radius -1; p 1; T 1;",
        {"radius is -1"}},
    {"sphericalCharge", "centre (0 0 0); radius 1; p 1; T 1; raduis 2;",
        {"raduis", "fraction"}},
    {"sphericalCharge", "centre (0 0 0); mass 1; energy 1;",
        {"radius", "density"}},
    {"sphericalCharge",
        "centre (0 0 0); mass 1; energy 1; radius 1; density 1;",
        {"radius", "density"}},
    {"sphericalCharge", "centre (0 0 0); mass 1; radius 1;", {"energy"}},
    {"sphericalCharge", "centre (0 0 0); mass 1; energy 1; radius 1; p 3;",
        {"Unknown keyword p", "mass"}},
    {"sphericalCharge", "centre (9 9 9); radius 1; p 1; T 1;",
        {"nowhere in the mesh"}},
    {"sphericalCharge",
        "centre (0 0 0); radius 0.5; p 1; T 1; fraction 0.5;",
        {"holds 0.2", "fraction is 0.5", "10 %"}},
    {"sphericalCharge",
        "centre (0 0 0); radius 0.5; p 1; T 1; fraction 1.5;", {"(0 1]"}},
    {"sphericalCharge", "centre (0 0 0); TNT { mass 1; }",
        {"2 direction(s)", "mass, energy"}},
    {"sphericalCharge", "centre (0 0 0); TNT { mas 1; }",
        {"Unknown keyword mas", "specificEnergy"}},
    {"sphericalCharge", "centre (0 0 0); TNT { mass -1; }", {"mass is -1"}},
    {"sphericalCharge", "centre (0 0 0); TNT { mass 1; } radius 1;",
        {"Unknown keyword radius", "TNT"}},
    {"sphericalCharge",
        "centre (0 0 0); TNT { mass 1; radius 1; density 2; }",
        {"radius and density"}},
    {"mappedProfile", "geometry round; centre (0 0 0); file \"t\";",
        {"round", "spherical", "cylindrical", "planar"}},
    {"mappedProfile", "geometry spherical; centre (0 0 0); file \"t\";",
        {"spherical needs 3 directions"}},
    {"mappedProfile", "geometry cylindrical; centre (0 0 0); file \"nowhere\";",
        {"no file", "nowhere"}},
    {"mappedProfile", "geometry cylindrical; centre (0 0 0);",
        {"file", "case"}},
    {"mappedProfile", "geometry cylindrical; centre (0 0 0); case \"nowhere\";",
        {"no case", "nowhere"}},
    {"mappedProfile",
        "geometry cylindrical; centre (0 0 0); file \"t\"; axis (0 0 1);",
        {"Unknown keyword axis"}},
    {"mappedProfile", "geometry planar; centre (0 0 0); file \"t\";",
        {"axis"}},
};

class Mistakes : public testing::TestWithParam<mistake> {};

} // End namespace


TEST_P(Mistakes, areExplained)
{
    stateScene scene(boxMesh::plane(6, 6));
    const std::string message =
        scene.errorOf(GetParam().type, GetParam().entries);
    for (const std::string& word : GetParam().words)
    {
        EXPECT_NE(message.find(word), std::string::npos) << message;
    }
}


TEST(StateErrors, bulbLighterThanAir)
{
    stateScene scene(randomMesh(3, 6));
    const std::string message = scene.errorOf
    (
        "sphericalCharge",
        "centre (0.5 0.5 0.5); TNT { mass 0.1; radius 0.45; }"
    );
    EXPECT_NE(message.find("smaller radius"), std::string::npos) << message;
}


TEST(StateErrors, gasNotPhysicalBeforehand)
{
    stateScene scene(boxMesh::plane(3, 3));
    const label n = scene.mesh().nNodes();
    scalarField p(n, 1e5);
    p[scene.mesh().nodeOfPoint()[3]] = -2;
    try
    {
        gasNodes
        (
            scene.mesh(), stateScene::air(),
            p, vectorField(n, Zero), scalarField(n, 300)
        );
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        const std::string message(e.message());
        EXPECT_NE(message.find("p = -2"), std::string::npos) << message;
        EXPECT_NE(message.find("(1 0 0)"), std::string::npos) << message;
    }
}


INSTANTIATE_TEST_SUITE_P(All, Mistakes, testing::ValuesIn(mistakes));
