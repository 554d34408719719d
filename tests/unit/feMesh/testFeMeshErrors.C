/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Meshes that the finite element view must refuse

#include "boxMesh.H"
#include "feMesh.H"
#include "testFolder.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

std::string errorOf(const boxMesh& box)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly = box.make(time());
    try
    {
        const feMesh mesh(poly());
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "no error";
}

void expectMention(const std::string& message, const char* words)
{
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // End namespace


TEST(FeMeshErrors, planeSceneTwoCellsThick)
{
    boxMesh box(boxMesh::plane(3, 3));
    box.n.z() = 2;
    expectMention(errorOf(box), "one cell thick");
}


TEST(FeMeshErrors, lineSceneTwoCellsThick)
{
    boxMesh box(boxMesh::lines(3));
    box.n.y() = 2;
    expectMention(errorOf(box), "one cell thick");
}


TEST(FeMeshErrors, obliqueEdgesAcrossAPlaneScene)
{
    boxMesh box(boxMesh::plane(3, 3));
    box.map = [](const point& x)
    {
        return point(x.x() + 0.2*x.z(), x.y(), x.z());
    };
    expectMention(errorOf(box), "straight across");
}


// A corner goes beyond the opposite corner: the outline crosses itself
TEST(FeMeshErrors, crossedCell)
{
    boxMesh box(boxMesh::plane(2, 1));
    box.map = [](const point& x)
    {
        const bool pushed = x.x() > 0.9 && x.y() < 0.1;
        return pushed ? point(0.7, 1.5, x.z()) : x;
    };
    const std::string message = errorOf(box);
    expectMention(message, "1 cell(s) cannot be split");
    expectMention(message, "cell 1 at");
    expectMention(message, "checkMesh");
}


TEST(FeMeshErrors, invertedCell)
{
    boxMesh box(boxMesh::space(3, 1, 1));
    box.map = [](const point& x)
    {
        return x.x() > 0.9 ? point(0.5, x.y(), x.z()) : x;
    };
    const std::string message = errorOf(box);
    expectMention(message, "1 cell(s) cannot be split");
    expectMention(message, "cell 2 at");
}


// The message names the first ten of them
TEST(FeMeshErrors, manyInvertedCells)
{
    boxMesh box(boxMesh::space(3, 4, 4));
    box.map = [](const point& x)
    {
        return x.x() > 0.9 ? point(0.5, x.y(), x.z()) : x;
    };
    const std::string message = errorOf(box);
    expectMention(message, "16 cell(s) cannot be split");
    size_t nNamed = 0;
    for (size_t at = 0; (at = message.find("cell ", at)) != message.npos; ++at)
    {
        ++nNamed;
    }
    EXPECT_EQ(nNamed, 10u) << message;
}


TEST(FeMeshErrors, unknownPatch)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly = boxMesh::plane(2, 2).make(time());
    const feMesh mesh(poly());
    EXPECT_EQ(mesh.patch("left").name, "left");
    try
    {
        mesh.patch("roof");
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        expectMention(e.message(), "roof");
        expectMention(e.message(), "left right bottom top");
    }
}
