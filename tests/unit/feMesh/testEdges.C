/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Edges of the simplices

#include "boxMesh.H"
#include "feMesh.H"
#include "testFolder.H"

#include <gtest/gtest.h>

#include <set>

using namespace Foam;

namespace
{

class Edges
:
    public testing::TestWithParam<label>
{
protected:

    static boxMesh box()
    {
        switch (GetParam())
        {
            case 1: return boxMesh::lines(6);
            case 2: return boxMesh::plane(3, 4);
            default: return boxMesh::space(3, 2, 4);
        }
    }

    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly = box().make(time());
    feMesh mesh{poly()};
    const label stride = mesh.dim() + 1;
};

} // End namespace


TEST_P(Edges, areThePairsOfTheSimplicesOnceAndSorted)
{
    std::set<std::pair<label, label>> expected;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        for (label a = 0; a < stride; ++a)
        {
            for (label b = 0; b < stride; ++b)
            {
                const label i = mesh.simplices()[stride*s + a];
                const label j = mesh.simplices()[stride*s + b];
                if (i < j)
                {
                    expected.insert({i, j});
                }
            }
        }
    }
    ASSERT_EQ(mesh.nEdges(), label(expected.size()));
    label edgei = 0;
    for (const auto& pair : expected)
    {
        EXPECT_EQ(mesh.edges()[edgei][0], pair.first);
        EXPECT_EQ(mesh.edges()[edgei][1], pair.second);
        EXPECT_LE(mesh.firstEdge()[pair.first], edgei);
        EXPECT_GT(mesh.firstEdge()[pair.first + 1], edgei);
        ++edgei;
    }
}


TEST_P(Edges, ofASimplexJoinItsNodesInOrder)
{
    const label perSimplex = mesh.dim()*stride/2;
    ASSERT_EQ(mesh.simplexEdges().size(), mesh.nSimplices()*perSimplex);
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        label k = perSimplex*s;
        for (label a = 0; a < mesh.dim(); ++a)
        {
            for (label b = a + 1; b < stride; ++b)
            {
                const edge joined
                (
                    mesh.simplices()[stride*s + a],
                    mesh.simplices()[stride*s + b]
                );
                EXPECT_TRUE(mesh.edges()[mesh.simplexEdges()[k++]] == joined);
            }
        }
    }
}


// Euler's formula for a ball: nodes - edges + facets - tetrahedra = 1
TEST_P(Edges, haveTheNumberThatEulersFormulaGives)
{
    label nFacets = mesh.nSimplices()*stride;
    for (const fePatch& patch : mesh.patches())
    {
        nFacets += patch.facetSimplex.size();
    }
    nFacets /= 2;
    const label euler =
        mesh.dim() == 1 ? mesh.nNodes() - mesh.nEdges()
      : mesh.dim() == 2 ? mesh.nNodes() - mesh.nEdges() + mesh.nSimplices()
      : mesh.nNodes() - mesh.nEdges() + nFacets - mesh.nSimplices();
    EXPECT_EQ(euler, 1);
}


// Alone, a processor owns everything and shares nothing
TEST_P(Edges, areOwnedInSerial)
{
    EXPECT_EQ(mesh.exchange().nOwned(), mesh.nNodes());
    EXPECT_EQ(mesh.edgeExchange().nOwned(), mesh.nEdges());
    EXPECT_TRUE(mesh.exchange().shared().empty());

    std::vector<double> values(mesh.nNodes(), 2.0);
    mesh.exchange().sum(values.data(), 1, 1);
    EXPECT_EQ(values, std::vector<double>(mesh.nNodes(), 2.0));
}


INSTANTIATE_TEST_SUITE_P(Dimensions, Edges, testing::Values(1, 2, 3));


TEST(NodeOrder, joinsLabelsThatAreNearWhateverThePointsOrder)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    const label n = 8;
    boxMesh box(boxMesh::space(n, n, n));
    box.shuffle = 3;
    autoPtr<polyMesh> shuffled = box.make(time());
    const feMesh mesh(shuffled());

    // Neighbours differ by one in the sum of their steps from a corner, and
    // no more than 3/4 (n + 1)^2 + 1/4 points have one sum
    const label level = (3*(n + 1)*(n + 1) + 1)/4;
    label widest = 0;
    for (const edge& e : mesh.edges())
    {
        widest = max(widest, mag(e[1] - e[0]));
    }
    EXPECT_LE(widest, 4*level);

    forAll(shuffled->points(), pointi)
    {
        const label nodei = mesh.nodeOfPoint()[pointi];
        EXPECT_EQ(mesh.pointOfNode()[nodei], pointi);
        EXPECT_EQ(mesh.globalNode()[nodei], pointi);
        EXPECT_EQ(mesh.nodes()[nodei], shuffled->points()[pointi]);
    }
}
