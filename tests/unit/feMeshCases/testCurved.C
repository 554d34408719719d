/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Axisymmetric, cylindrical and spherical scenes from meshes with wedges

#include "blockCase.H"
#include "feMesh.H"
#include "StringStream.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

struct curvedScene
{
    const char* name;
    std::string blockMeshDict;
    label dim, curvature;
    direction radial, radialComponent;
    label nNodes, nSimplices;
    scalar volume, depth;

    //- Patches that bound the scene, with the number of their facets
    std::map<word, label> facets;
};

void PrintTo(const curvedScene& s, std::ostream* os) { *os << s.name; }

class Curved
:
    public testing::TestWithParam<curvedScene>
{
protected:

    blockCase blocks{GetParam().blockMeshDict};
    autoPtr<Time> time = blocks.folder.clock();
    polyMesh poly
    {
        IOobject
        (
            polyMesh::defaultRegion, time->constant(), time(),
            IOobject::MUST_READ
        )
    };
    feMesh mesh{poly};
};

//- Solid angle of a pyramid by cutting it into many thin ones: the angle
//  under which dy dz at distance 1 is seen is cos^3
scalar solidAngle(const scalar angle2, const scalar angle3)
{
    const label n = 2000;
    const scalar a = std::tan(0.5*angle2), b = std::tan(0.5*angle3);
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const scalar y = a*(i + 0.5)/n, z = b*(j + 0.5)/n;
            sum += std::pow(1 + y*y + z*z, -1.5);
        }
    }
    return 4*sum*a*b/sqr(scalar(n));
}

} // End namespace


TEST_P(Curved, hasTheNodesAndMeasureOfTheScene)
{
    const curvedScene& s = GetParam();
    EXPECT_EQ(mesh.dim(), s.dim);
    EXPECT_EQ(mesh.curvature(), s.curvature);
    EXPECT_EQ(mesh.radial(), s.radial);
    EXPECT_EQ(mesh.axes()[s.radial], s.radialComponent);
    EXPECT_EQ(mesh.nNodes(), s.nNodes);
    EXPECT_EQ(mesh.nSimplices(), s.nSimplices);
    EXPECT_NEAR(mesh.depth(), s.depth, 1e-7*s.depth);

    scalar sum = 0;
    for (label i = 0; i < mesh.nSimplices(); ++i)
    {
        EXPECT_GT(mesh.simplexVolume(i), 0);
        sum += mesh.simplexVolume(i);
    }
    EXPECT_NEAR(sum, s.volume, 1e-7*s.volume);
}


TEST_P(Curved, patchesAreThoseThatBoundTheScene)
{
    std::map<word, label> facets;
    for (const fePatch& patch : mesh.patches())
    {
        facets[patch.name] = patch.facetSimplex.size();
    }
    EXPECT_EQ(facets, GetParam().facets);
}


// A mesh point's node has its distance from the axis, exactly zero on it
TEST_P(Curved, nodesAreAtTheirDistanceFromTheAxis)
{
    const direction r = GetParam().radialComponent;
    forAll(poly.points(), i)
    {
        vector x(poly.points()[i]);
        if (mesh.curvature() == 1)
        {
            for (const direction axis : mesh.axes())
            {
                if (axis != r)
                {
                    const label node = mesh.nodeOfPoint()[i];
                    EXPECT_EQ(mesh.nodes()[node][axis], x[axis]);
                }
            }
            x[mesh.dim() == 2 ? mesh.axes()[1 - GetParam().radial] : 2] = 0;
        }
        EXPECT_NEAR(mesh.nodes()[mesh.nodeOfPoint()[i]][r], mag(x), 1e-15);
    }
}


TEST_P(Curved, followsMotion)
{
    const pointField before(mesh.nodes());
    poly.movePoints(pointField(1.25*poly.points()));
    mesh.movePoints();
    forAll(before, i)
    {
        EXPECT_LT(mag(mesh.nodes()[i] - 1.25*before[i]), 1e-15);
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes, Curved, testing::Values
    (
        curvedScene{"axisymmetric", wedgeDict("6 4 1", 0.1).text(),
            2, 1, 1, 1, 35, 48, 0.1*0.125, 0.1,
            {{"left", 4}, {"right", 4}, {"outer", 6}}},
        curvedScene{"axisY", wedgeDict("6 4 1", 0.02, 1).text(),
            2, 1, 1, 2, 35, 48, 0.02*0.125, 0.02,
            {{"left", 4}, {"right", 4}, {"outer", 6}}},
        curvedScene{"axisZ", wedgeDict("6 4 1", 0.1, 2).text(),
            2, 1, 0, 0, 35, 48, 0.1*0.125, 0.1,
            {{"left", 4}, {"right", 4}, {"outer", 6}}},
        curvedScene{"cylindrical", wedgeDict("1 5 1", 0.1, 2, "empty").text(),
            1, 1, 0, 0, 6, 5, 0.1*0.125, 0.1, {{"outer", 1}}},
        curvedScene{"spherical", pyramidDict("5 1 1", 0.3, 0.2).text(),
            1, 2, 0, 0, 6, 5, solidAngle(0.3, 0.2)*(1 - pow3(0.2))/3,
            solidAngle(0.3, 0.2), {{"inner", 1}, {"outer", 1}}}
    ),
    [](const auto& info) { return std::string(info.param.name); }
);


namespace
{

std::string errorOf(const std::string& dict)
{
    FatalError.throwExceptions();
    blockCase blocks(dict);
    autoPtr<Time> time = blocks.folder.clock();
    const polyMesh poly
    (
        IOobject
        (
            polyMesh::defaultRegion, time->constant(), time(),
            IOobject::MUST_READ
        )
    );
    try
    {
        const feMesh mesh(poly);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "no error";
}

} // End namespace


TEST(CurvedErrors, axisBesideTheOrigin)
{
    const std::string message =
        errorOf(wedgeDict("6 4 1", 0.1, 0, "patch", 0.1).text());
    EXPECT_NE(message.find("through the origin"), message.npos) << message;
    EXPECT_NE(message.find("wedge patch back"), message.npos) << message;
}


TEST(CurvedErrors, twoCellsAcross)
{
    const std::string message = errorOf(wedgeDict("6 4 2", 0.1).text());
    EXPECT_NE(message.find("one cell thick"), message.npos) << message;
}


TEST(CurvedErrors, threeWedgePatches)
{
    std::string dict = pyramidDict("5 1 1", 0.1, 0.1).text();
    dict.replace(dict.rfind("wedge"), 5, "patch");
    const std::string message = errorOf(dict);
    EXPECT_NE(message.find("3 wedge patches"), message.npos) << message;
}


TEST(Report, namesNumbersAndPlaces)
{
    blockCase blocks(boxDict("2 3 4", {"patch", "patch", "patch"}).text());
    autoPtr<Time> time = blocks.folder.clock();
    const polyMesh poly
    (
        IOobject
        (
            polyMesh::defaultRegion, time->constant(), time(),
            IOobject::MUST_READ
        )
    );
    OStringStream os;
    feMesh(poly).report(os);
    for
    (
        const char* words :
        {
            "dimensions   : 3", "nodes        : 60", "simplices    : 120",
            "24 in five tetrahedra", "least", "largest", "aspect ratio"
        }
    )
    {
        EXPECT_NE(os.str().find(words), std::string::npos)
            << words << "\n" << os.str();
    }
}
