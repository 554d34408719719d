/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// How cells are split: every kind of cell, whatever its points' labels

#include "boxMesh.H"
#include "cellMesh.H"
#include "feMesh.H"
#include "hexRef8.H"
#include "polyTopoChange.H"
#include "testFolder.H"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace Foam;

namespace
{

scalar volume(const feMesh& mesh, const label s)
{
    const label* n = &mesh.simplexCorners()[4*s];
    const pointField& x = mesh.corners();
    return
        ((x[n[1]] - x[n[0]]) & ((x[n[2]] - x[n[0]]) ^ (x[n[3]] - x[n[0]])))/6;
}

//- Positive simplices that fill each cell, and facets that match
void expectGoodSplit(const feMesh& mesh)
{
    scalarField filled(mesh.poly().nCells(), Zero);
    std::map<std::set<label>, label> count;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        EXPECT_GT(volume(mesh, s), 0);
        filled[mesh.cellOfSimplex()[s]] += volume(mesh, s);
        for (label off = 0; off < 4; ++off)
        {
            std::set<label> facet;
            for (label a = 0; a < 4; ++a)
            {
                if (a != off)
                {
                    facet.insert(mesh.simplices()[4*s + a]);
                }
            }
            ++count[facet];
        }
    }
    const scalarField& exact = mesh.poly().cellVolumes();
    forAll(filled, celli)
    {
        EXPECT_NEAR(filled[celli], exact[celli], 1e-12*exact[celli]);
    }

    for (const fePatch& patch : mesh.patches())
    {
        for (label i = 0; i < patch.facets.size(); i += 3)
        {
            const label* n = &patch.facets[i];
            ++count[{n[0], n[1], n[2]}];
        }
    }
    for (const auto& facet : count)
    {
        EXPECT_EQ(facet.second, 2);
    }
}

//- Corners of the unit cube by their place in binary: x + 2 y + 4 z
const pointField cube
({
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
    {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}
});

const faceList cubeFaces
({
    face({0, 2, 6, 4}), face({1, 3, 7, 5}), face({0, 1, 5, 4}),
    face({2, 3, 7, 6}), face({0, 1, 3, 2}), face({4, 5, 7, 6})
});

struct shape
{
    const char* name;
    pointField points;
    faceList faces;
};

void PrintTo(const shape& s, std::ostream* os) { *os << s.name; }

shape prismOver(const label n)
{
    shape s{"", pointField(2*n), faceList(n + 2)};
    s.faces[n].setSize(n);
    s.faces[n + 1].setSize(n);
    for (label i = 0; i < n; ++i)
    {
        const scalar angle = 2*M_PI*i/n;
        s.points[i] = point(std::cos(angle), std::sin(angle), 0);
        s.points[n + i] = s.points[i] + vector(0.2, 0.1, 1);
        const label j = (i + 1) % n;
        s.faces[i] = face({i, j, n + j, n + i});
        s.faces[n][i] = i;
        s.faces[n + 1][i] = n + i;
    }
    return s;
}

shape pyramidOver(const label n)
{
    shape s{"", prismOver(n).points, faceList(n + 1)};
    s.points[n] = point(0.1, 0.2, 1);
    s.points.setSize(n + 1);
    s.faces[n].setSize(n);
    for (label i = 0; i < n; ++i)
    {
        s.faces[i] = face({i, (i + 1) % n, n});
        s.faces[n][i] = i;
    }
    return s;
}

//- Cube whose corners are cut off: octagons and triangles
shape truncatedCube()
{
    shape s{"", pointField(24), faceList(14)};
    const scalar cut = 0.3;
    forAll(cube, c)
    {
        s.faces[6 + c].setSize(3);
        for (label d = 0; d < 3; ++d)
        {
            const vector along(cube[c ^ (1 << d)] - cube[c]);
            s.points[3*c + d] = cube[c] + cut*along;
            s.faces[6 + c][d] = 3*c + d;
        }
    }
    forAll(cubeFaces, i)
    {
        const face& f = cubeFaces[i];
        forAll(f, k)
        {
            for (const label other : {f.prevLabel(k), f.nextLabel(k)})
            {
                const label d = (f[k] ^ other) == 1 ? 0
                    : (f[k] ^ other) == 2 ? 1 : 2;
                s.faces[i].append(3*f[k] + d);
            }
        }
    }
    return s;
}

shape named(const char* name, shape s)
{
    s.name = name;
    return s;
}

class Splitting
:
    public testing::TestWithParam<shape>
{};

} // End namespace


TEST_P(Splitting, fillsTheCellForAnyLabels)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    for (unsigned shuffle = 0; shuffle < 40; ++shuffle)
    {
        SCOPED_TRACE(shuffle);
        autoPtr<polyMesh> poly =
            cellMesh(time(), GetParam().points, GetParam().faces, shuffle);
        expectGoodSplit(feMesh(poly()));
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Shapes, Splitting, testing::Values
    (
        named("tetrahedron", pyramidOver(3)),
        named("pyramid", pyramidOver(4)),
        named("prism", prismOver(3)),
        named("hexahedron", shape{"", cube, cubeFaces}),
        named("hexagonalPrism", prismOver(6)),
        named("heptagonalPyramid", pyramidOver(7)),
        named("truncatedCube", truncatedCube())
    ),
    [](const auto& info) { return std::string(info.param.name); }
);


namespace
{

//- A box of which the cells are refined that select chooses
template<class Select>
autoPtr<polyMesh> refinedBox
(
    const Time& time,
    const Select& select,
    const word& sides = "patch"
)
{
    boxMesh box(boxMesh::space(3, 3, 3));
    box.types[0] = box.types[1] = sides;
    autoPtr<polyMesh> poly = box.make(time);
    DynamicList<label> chosen;
    for (label celli = 0; celli < poly->nCells(); ++celli)
    {
        if (select(poly->cellCentres()[celli]))
        {
            chosen.append(celli);
        }
    }
    hexRef8 cutter(poly(), false);
    const labelList cells(cutter.consistentRefinement(chosen, true));
    polyTopoChange change(poly());
    cutter.setRefinement(cells, change);
    change.changeMesh(poly(), false);
    return poly;
}

} // End namespace


// Refined cells next to unrefined ones: points in the middle of edges and
// faces, where fans and cones have to avoid simplices without volume
TEST(SplittingRefined, besideAPlane)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    std::mt19937 random(1);
    std::normal_distribution<double> some;
    for (label i = 0; i < 20; ++i)
    {
        SCOPED_TRACE(i);
        const vector normal(some(random), some(random), some(random));
        autoPtr<polyMesh> poly = refinedBox
        (
            time(), [&](const point& x)
            {
                return ((x - point(0.5, 0.5, 0.5)) & normal) > 0.1*mag(normal);
            }
        );
        EXPECT_GT(poly->nCells(), 27);
        expectGoodSplit(feMesh(poly()));
    }
}


// The faces on the two sides of a cyclic are split in the same way, also where
// they have five and more points
TEST(SplittingRefined, throughACyclic)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    for (unsigned seed = 1; seed < 15; ++seed)
    {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        autoPtr<polyMesh> poly = refinedBox
        (
            time(),
            [&](const point& x)
            {
                return mag(x.y() - 0.5) < 0.2 && random() % 3 == 0;
            },
            "cyclic"
        );
        expectGoodSplit(feMesh(poly()));
    }
}


// Among refined cells on many sides a cell may have no split: it is named.
// That is rare also where every fourth cell is refined at random.
TEST(SplittingRefined, randomPatterns)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    label nUnsplit = 0;
    for (unsigned seed = 1; seed < 20; ++seed)
    {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        autoPtr<polyMesh> poly = refinedBox
        (
            time(), [&](const point&) { return random() % 4 == 0; }
        );
        try
        {
            expectGoodSplit(feMesh(poly()));
        }
        catch (const Foam::error& e)
        {
            EXPECT_EQ(e.message().find("1 cell(s) cannot be split"), 0u)
                << e.message();
            ++nUnsplit;
        }
    }
    EXPECT_LE(nUnsplit, 1);
}


// An outline with a corner pushed in: not every fan, but one, stays inside
TEST(SplittingPlane, concavePolygon)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    boxMesh box(boxMesh::plane(2, 1));
    box.map = [](const point& x)
    {
        const bool pushed = x.x() > 0.9 && x.y() > 0.9;
        return pushed ? point(0.55, 0.55, x.z()) : x;
    };
    autoPtr<polyMesh> poly = box.make(time());
    const feMesh mesh(poly());
    ASSERT_EQ(mesh.nSimplices(), 4);
    EXPECT_EQ(mesh.splitCounts()[otherCone], 1);
    scalar sum = 0;
    for (label s = 0; s < 4; ++s)
    {
        simplexVec<2> x[3];
        for (int a = 0; a < 3; ++a)
        {
            x[a] = mesh.components<2>(mesh.nodes()[mesh.simplices()[3*s + a]]);
        }
        const scalar v = simplex::volume<2>(simplex::edges<2>(x));
        EXPECT_GT(v, 0);
        sum += v;
    }

    // The square, and the other by the shoelace formula
    EXPECT_NEAR(sum, 0.5 + 0.1625, 1e-14);
}


// Hexahedra are split in five with diagonals that alternate: along each axis
// as many faces have the one diagonal as the other
TEST(SplittingHexahedra, noDirectionIsFavoured)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    boxMesh box(boxMesh::space(4, 4, 4));
    box.shuffle = 3;
    autoPtr<polyMesh> poly = box.make(time());
    const feMesh mesh(poly());
    EXPECT_EQ(mesh.splitCounts()[fiveTetrahedra], poly->nCells());
    EXPECT_EQ(mesh.nSimplices(), 5*poly->nCells());

    // Mean of the products of the components of the edges' directions
    tensor mean(Zero);
    for (const edge& e : mesh.edges())
    {
        const vector d(e.vec(mesh.nodes()));
        mean += d*d;
    }
    EXPECT_LT(mag(mean.xy()) + mag(mean.yz()) + mag(mean.xz()), 1e-13);
}


// The split is made once: a motion that would choose other fans keeps it
TEST(SplittingHexahedra, isKeptWhenTheMeshMoves)
{
    testFolder folder;
    autoPtr<Time> time = folder.clock();
    autoPtr<polyMesh> poly = boxMesh::space(3, 3, 3).make(time());
    feMesh mesh(poly());
    const labelList before(mesh.simplices());
    pointField moved(poly->points());
    for (point& x : moved)
    {
        x.x() += 0.3*x.y()*x.z();
    }
    poly->movePoints(moved);
    mesh.movePoints();
    EXPECT_EQ(mesh.simplices(), before);
    EXPECT_EQ(mesh.nodes(), mesh.gather(moved)());
}
