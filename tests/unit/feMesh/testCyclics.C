/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Nodes, corners and edges of meshes whose sides are images of each other

#include "boxMesh.H"
#include "feMesh.H"
#include "testFolder.H"

#include <gtest/gtest.h>

#include <set>

using namespace Foam;

namespace
{

struct periodicScene
{
    const char* name;
    boxMesh box;

    //- Periodic directions
    labelVector periodic;

    label nNodes;
    scalar volume;
};

void PrintTo(const periodicScene& s, std::ostream* os) { *os << s.name; }

boxMesh periodicBox(boxMesh b, const labelVector& periodic)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (periodic[d])
        {
            b.types[2*d] = b.types[2*d + 1] = "cyclic";
        }
    }
    return b;
}

class Cyclics
:
    public testing::TestWithParam<periodicScene>
{
protected:

    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly =
        periodicBox(GetParam().box, GetParam().periodic).make(time());
    feMesh mesh{poly()};
    const label stride = mesh.dim() + 1;

    template<int dim>
    scalar measure(const label s, const pointField& x) const
    {
        simplexVec<dim> corners[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            corners[a] = mesh.components<dim>
            (
                x[mesh.simplexCorners()[(dim + 1)*s + a]]
            );
        }
        return simplex::volume<dim>(simplex::edges<dim>(corners));
    }

    scalar volume(const label s, const pointField& x) const
    {
        switch (mesh.dim())
        {
            case 1: return mesh.depth()*measure<1>(s, x);
            case 2: return mesh.depth()*measure<2>(s, x);
            default: return measure<3>(s, x);
        }
    }
};

} // End namespace


TEST_P(Cyclics, imagesAreOneNode)
{
    EXPECT_EQ(mesh.nNodes(), GetParam().nNodes);
    EXPECT_GT(mesh.nCorners(), mesh.nNodes());

    // Points that differ by whole periods, and only those, are one node
    forAll(mesh.nodeOfPoint(), i)
    {
        const label nodei = mesh.nodeOfPoint()[i];
        vector d(poly->points()[i] - mesh.nodes()[nodei]);
        for (const direction axis : mesh.axes())
        {
            if (GetParam().periodic[axis])
            {
                d[axis] -= std::round(d[axis]);
            }
            EXPECT_NEAR(d[axis], 0, 1e-14);
        }
    }
}


TEST_P(Cyclics, serialGlobalLabelIsTheSmallestPoint)
{
    labelList smallest(mesh.nNodes(), labelMax);
    forAll(mesh.nodeOfPoint(), i)
    {
        label& s = smallest[mesh.nodeOfPoint()[i]];
        s = min(s, i);
    }
    EXPECT_EQ(mesh.globalNode(), smallest);
}


TEST_P(Cyclics, simplicesFillTheBoxAtTheirCorners)
{
    scalar sum = 0;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        EXPECT_GT(volume(s, mesh.corners()), 0);
        sum += volume(s, mesh.corners());
    }
    EXPECT_NEAR(sum, GetParam().volume, 1e-13);

    forAll(mesh.simplices(), i)
    {
        EXPECT_EQ
        (
            mesh.simplices()[i],
            mesh.nodeOfCorner(mesh.simplexCorners()[i])
        );
    }
}


// Every facet belongs to two simplices or to one and a patch
TEST_P(Cyclics, facetsMatchThroughTheCyclics)
{
    std::map<std::multiset<label>, label> count;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        for (label off = 0; off < stride; ++off)
        {
            std::multiset<label> facet;
            for (label a = 0; a < stride; ++a)
            {
                if (a != off)
                {
                    facet.insert(mesh.simplices()[stride*s + a]);
                }
            }
            ++count[facet];
        }
    }
    for (const fePatch& patch : mesh.patches())
    {
        EXPECT_NE(patch.type, "cyclic");
        forAll(patch.facetSimplex, i)
        {
            ++count
            [
                std::multiset<label>
                (
                    patch.facets.begin() + mesh.dim()*i,
                    patch.facets.begin() + mesh.dim()*(i + 1)
                )
            ];
        }
    }
    for (const auto& facet : count)
    {
        // Two cells apart, two facets may have the same nodes
        EXPECT_TRUE(facet.second == 2 || facet.second == 4) << facet.second;
    }
}


TEST_P(Cyclics, cornersFollowTheNodes)
{
    pointField nodes(mesh.nodes());
    const vector shift(0.3, -0.2, 0.1);
    nodes += shift;
    const pointField before(mesh.corners());
    mesh.moveNodes(nodes);
    forAll(before, i)
    {
        EXPECT_LT(mag(mesh.corners()[i] - before[i] - shift), 1e-15);
    }
    poly->movePoints(pointField(poly->points() - shift));
    mesh.movePoints();
    forAll(before, i)
    {
        EXPECT_LT(mag(mesh.corners()[i] - before[i] + shift), 1e-15);
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes, Cyclics, testing::Values
    (
        periodicScene{"line", boxMesh::lines(5), labelVector(1, 0, 0), 5, 0.01},
        periodicScene{"lineOfTwo", boxMesh::lines(2), labelVector(1, 0, 0),
            2, 0.01},
        periodicScene{"channel", boxMesh::plane(4, 3), labelVector(1, 0, 0),
            16, 0.1},
        periodicScene{"torus", boxMesh::plane(4, 3), labelVector(1, 1, 0),
            12, 0.1},
        periodicScene{"twoWide", boxMesh::plane(2, 3), labelVector(1, 0, 0),
            8, 0.1},
        periodicScene{"pipe", boxMesh::space(4, 3, 2), labelVector(1, 0, 0),
            48, 1},
        periodicScene{"oddPipe", boxMesh::space(3, 3, 2), labelVector(1, 0, 0),
            36, 1},
        periodicScene{"threeWays", boxMesh::space(4, 3, 2),
            labelVector(1, 1, 1), 24, 1}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);


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

} // End namespace


TEST(CyclicErrors, oneCellBetweenCyclics)
{
    const std::string message =
        errorOf(periodicBox(boxMesh::plane(1, 3), labelVector(1, 0, 0)));
    EXPECT_NE(message.find("twice"), std::string::npos) << message;
    EXPECT_NE(message.find("at least two cells"), std::string::npos);
}


// A quarter of a ring: left and right are turned by 90 degrees
TEST(CyclicErrors, rotationalCyclic)
{
    boxMesh box(periodicBox(boxMesh::space(4, 3, 2), labelVector(1, 0, 0)));
    box.map = [](const point& x)
    {
        const scalar angle = -0.5*M_PI*x.x();
        const scalar r = x.y() + 1;
        return point(r*std::sin(-angle), r*std::cos(angle), x.z());
    };
    const std::string message = errorOf(box);
    EXPECT_NE(message.find("rotational"), std::string::npos) << message;
    EXPECT_NE(message.find("left"), std::string::npos) << message;
}
