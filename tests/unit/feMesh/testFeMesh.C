/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The finite element view of a polyMesh: simplices, patches, motion, queries

#include "boxMesh.H"
#include "feMesh.H"
#include "SubField.H"
#include "testFolder.H"

#include <gtest/gtest.h>

#include <map>

using namespace Foam;

namespace
{

//- A mesh, what it must be, and a name for the test's report
struct scene
{
    const char* name;
    boxMesh box;
    label dim;
    label nNodes;
    label nSimplices;
    scalar volume = 1;
};

void PrintTo(const scene& s, std::ostream* os) { *os << s.name; }

boxMesh with(boxMesh b, boxMesh::cellKind kind, const scalar distortion)
{
    b.kind = kind;
    b.shuffle = 7;
    return b.distort(distortion);
}

//- A plane scene in x and z
boxMesh standing(boxMesh b)
{
    b.n = labelVector(3, 1, 4);
    b.size = vector(1, 0.5, 1);
    b.types = wordList({"patch", "patch", "empty", "empty", "patch", "patch"});
    return b;
}

//- An L: the upper right quarter is missing
boxMesh corner(boxMesh b)
{
    b.n = labelVector(4, 4, 2);
    b.keep = [](label i, label j, label) { return i < 2 || j < 2; };
    return b;
}

class FeMesh
:
    public testing::TestWithParam<scene>
{
protected:

    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly = GetParam().box.make(time());
    feMesh mesh{poly()};

    template<int dim>
    scalar measure(const label s) const
    {
        simplexVec<dim> x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = mesh.components<dim>(
                mesh.nodes()[mesh.simplices()[(dim + 1)*s + a]]);
        }
        return simplex::volume<dim>(simplex::edges<dim>(x));
    }

    scalar volume(const label s) const
    {
        switch (GetParam().dim)
        {
            case 1: return mesh.depth()*measure<1>(s);
            case 2: return mesh.depth()*measure<2>(s);
            default: return measure<3>(s);
        }
    }

    template<int dim>
    vector facetArea(const fePatch& patch, const label i) const
    {
        const label s = patch.facetSimplex[i];
        simplexVec<dim> x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = mesh.components<dim>(
                mesh.nodes()[mesh.simplices()[(dim + 1)*s + a]]);
        }
        Eigen::Matrix<double, dim, dim> rest =
            Eigen::Matrix<double, dim, dim>::Zero();
        const auto B = simplex::areas(simplex::edges<dim>(x), rest);
        const simplexVec<dim> S =
            simplex::outwardArea<dim>(B, patch.opposite[i])*mesh.depth();
        return mesh.fullVector<dim>(S);
    }

    vector facetArea(const fePatch& patch, const label i) const
    {
        switch (GetParam().dim)
        {
            case 1: return facetArea<1>(patch, i);
            case 2: return facetArea<2>(patch, i);
            default: return facetArea<3>(patch, i);
        }
    }
};

} // End namespace


TEST_P(FeMesh, hasNodesAndSimplicesOfTheSceneOnly)
{
    EXPECT_EQ(mesh.dim(), GetParam().dim);
    EXPECT_EQ(mesh.nNodes(), GetParam().nNodes);
    EXPECT_EQ(mesh.nSimplices(), GetParam().nSimplices);
    EXPECT_EQ(mesh.simplices().size(), mesh.nSimplices()*(mesh.dim() + 1));

    // A node is where its mesh points are, but for the empty directions
    forAll(mesh.nodeOfPoint(), pointi)
    {
        const label node = mesh.nodeOfPoint()[pointi];
        for (const direction axis : mesh.axes())
        {
            EXPECT_EQ(mesh.nodes()[node][axis], poly->points()[pointi][axis]);
        }
    }
}


TEST_P(FeMesh, simplicesFillTheCells)
{
    scalarField filled(poly->nCells(), Zero);
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        EXPECT_GT(volume(s), 0);
        filled[mesh.cellOfSimplex()[s]] += volume(s);
    }
    EXPECT_NEAR(sum(filled), GetParam().volume, 1e-13);
}


// Conforming: every facet belongs to two simplices, or to one and a patch
TEST_P(FeMesh, facetsMatch)
{
    std::map<std::vector<label>, label> count;
    const label stride = mesh.dim() + 1;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        for (label off = 0; off < stride; ++off)
        {
            std::vector<label> facet;
            for (label a = 0; a < stride; ++a)
            {
                if (a != off)
                {
                    facet.push_back(mesh.simplices()[stride*s + a]);
                }
            }
            std::sort(facet.begin(), facet.end());
            ++count[facet];
        }
    }
    for (const fePatch& patch : mesh.patches())
    {
        forAll(patch.facetSimplex, i)
        {
            std::vector<label> facet
            (
                patch.facets.begin() + mesh.dim()*i,
                patch.facets.begin() + mesh.dim()*(i + 1)
            );
            std::sort(facet.begin(), facet.end());
            ++count[facet];
        }
    }
    for (const auto& facet : count)
    {
        EXPECT_EQ(facet.second, 2);
    }
}


TEST_P(FeMesh, patchesHaveTheirAreasAndNodes)
{
    vector closed(Zero);
    for (const fePatch& patch : mesh.patches())
    {
        const polyPatch& pp = poly->boundaryMesh()[patch.name];
        EXPECT_EQ(patch.index, pp.index());
        EXPECT_EQ(patch.type, pp.type());

        vector area(Zero);
        forAll(patch.facetSimplex, i)
        {
            area += facetArea(patch, i);
            const label s = patch.facetSimplex[i];
            const label opposite =
                mesh.simplices()[(mesh.dim() + 1)*s + patch.opposite[i]];
            for (label b = 0; b < mesh.dim(); ++b)
            {
                EXPECT_NE(patch.facets[mesh.dim()*i + b], opposite);
            }
        }
        closed += area;
        EXPECT_LT(mag(area - sum(pp.faceAreas())), 1e-13) << patch.name;

        labelHashSet nodes;
        for (const label pointi : pp.meshPoints())
        {
            nodes.insert(mesh.nodeOfPoint()[pointi]);
        }
        EXPECT_EQ(patch.nodes, nodes.sortedToc());
    }
    EXPECT_LT(mag(closed), 1e-13);
}


TEST_P(FeMesh, followsAMovingPolyMesh)
{
    const vector shift(0.3, -0.2, 0.1);
    const pointField before(mesh.nodes());
    poly->movePoints(pointField(poly->points() + shift));
    EXPECT_TRUE(mesh.movePoints());
    forAll(before, i)
    {
        EXPECT_LT(mag(mesh.nodes()[i] - before[i] - shift), 1e-15);
    }
}


// Every point of a simplex is found, with the coordinates that reproduce it
TEST_P(FeMesh, findsPoints)
{
    std::mt19937 random(5);
    std::exponential_distribution<double> some;
    const label stride = mesh.dim() + 1;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        std::vector<scalar> b(stride);
        scalar sum = 0;
        for (scalar& bi : b)
        {
            bi = some(random);
            sum += bi;
        }
        point x(Zero);
        for (label a = 0; a < stride; ++a)
        {
            x += b[a]/sum*mesh.nodes()[mesh.simplices()[stride*s + a]];
        }

        scalarList weights;
        const label found = mesh.findSimplex(x, weights);
        ASSERT_GE(found, 0);
        EXPECT_TRUE(mesh.inSimplex(s, x, weights));

        ASSERT_EQ(weights.size(), stride);
        point y(Zero);
        for (label a = 0; a < stride; ++a)
        {
            y += weights[a]*mesh.nodes()[mesh.simplices()[stride*s + a]];
        }
        for (const direction axis : mesh.axes())
        {
            EXPECT_NEAR(y[axis], x[axis], 1e-13);
        }
    }
    scalarList weights;
    EXPECT_EQ(mesh.findSimplex(point(2, 2, 2), weights), -1);
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes, FeMesh, testing::Values
    (
        scene{"lines", with(boxMesh::lines(7), boxMesh::hexahedra, 0.3),
            1, 8, 7, 0.01},
        scene{"squares", with(boxMesh::plane(3, 4), boxMesh::hexahedra, 0.2),
            2, 20, 24, 0.1},
        scene{"triangles", with(boxMesh::plane(3, 4), boxMesh::prisms, 0.2),
            2, 20, 24, 0.1},
        scene{"standing", with(standing(boxMesh()), boxMesh::hexahedra, 0.2),
            2, 20, 24, 0.5},
        scene{"hexahedra",
            with(boxMesh::space(3, 4, 2), boxMesh::hexahedra, 0.15),
            3, 60, 5*24, 1},
        scene{"prisms", with(boxMesh::space(3, 4, 2), boxMesh::prisms, 0.15),
            3, 60, 6*24, 1},
        scene{"tetrahedra",
            with(boxMesh::space(3, 4, 2), boxMesh::tetrahedra, 0.15),
            3, 60, 6*24, 1},
        scene{"corner", with(corner(boxMesh()), boxMesh::hexahedra, 0),
            3, 63, 5*24, 0.75}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);
