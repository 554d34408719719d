/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "patchShellMesh.H"
#include "cubicShellMesh.H"
#include "patchOutline.H"
#include "triPointRef.H"

using positionalShell::CubicEdge;
using positionalShell::NamedSets;
using positionalShell::ShellMesh;

namespace Foam
{

static void fail(const polyPatch& patch, const std::string& what)
{
    FatalErrorInFunction
        << "Patch " << patch.name() << ": " << what.c_str() << nl
        << exit(FatalError);
}


static std::string name(const polyPatch& patch, const label face)
{
    return "face " + std::to_string(patch.start() + face) + " (number "
      + std::to_string(face) + " of patch " + patch.name() + ")";
}


//- Do the triangles of a quadrilateral cut from corner i to i + 2 lie on its
//  side?
static bool cutsWell(const face& quad, const pointField& points, const label i)
{
    const auto at = [&](const label j) { return points[quad[(i + j) % 4]]; };
    const vector area(quad.areaNormal(points));

    return (triPointRef(at(0), at(1), at(2)).areaNormal() & area) > 0
        && (triPointRef(at(0), at(2), at(3)).areaNormal() & area) > 0;
}


static void cut
(
    const polyPatch& patch,
    const label facei,
    std::vector<std::vector<int>>& triangles
)
{
    const face& quad = patch.localFaces()[facei];
    const pointField& points = patch.localPoints();

    label i = magSqr(points[quad[0]] - points[quad[2]])
      <= magSqr(points[quad[1]] - points[quad[3]]) ? 0 : 1;
    if (!cutsWell(quad, points, i))
    {
        i = 1 - i;
    }
    if (!cutsWell(quad, points, i))
    {
        fail
        (
            patch,
            name(patch, facei) + " has no area, or no diagonal cuts it into"
            " two triangles of its side; repair the mesh there (checkMesh)"
        );
    }
    const auto at = [&](const label j) { return int(quad[(i + j) % 4]); };
    triangles.push_back({at(0), at(1), at(2)});
    triangles.push_back({at(0), at(2), at(3)});
}


//- Triangles of local points, and the face that each is of
static std::vector<label> facesToTriangles
(
    const polyPatch& patch,
    const bool flip,
    std::vector<std::vector<int>>& triangles
)
{
    std::vector<label> faceOf;
    forAll(patch, facei)
    {
        const face& f = patch.localFaces()[facei];
        if (f.size() > 4)
        {
            fail
            (
                patch,
                name(patch, facei) + " has " + std::to_string(f.size())
              + " points; a shell is made of triangles and quadrilaterals:"
                " mesh the patch with those"
            );
        }
        if (f.size() == 4)
        {
            cut(patch, facei, triangles);
        }
        else
        {
            triangles.push_back({int(f[0]), int(f[1]), int(f[2])});
        }
        faceOf.resize(triangles.size(), facei);
    }
    for (auto& triangle : triangles)
    {
        if (flip)
        {
            std::swap(triangle[1], triangle[2]);
        }
    }
    return faceOf;
}


static void addEdges
(
    const polyPatch& patch,
    const cubicShellMesh& cubic,
    const std::string& name,
    const edgeList& edges,
    NamedSets& sets
)
{
    if (sets.count(name) || name == "all")
    {
        fail
        (
            patch,
            "the patch " + name + " at its boundary is called like a set that"
            " every shell mesh has; rename that patch"
        );
    }
    std::vector<int>& nodes = sets[name];
    for (const edge& e : edges)
    {
        const CubicEdge* edge = cubic.edge(e[0], e[1]);
        nodes.insert(nodes.end(), edge->begin(), edge->end());
    }
}


static NamedSets outlineSets
(
    const polyPatch& patch,
    const cubicShellMesh& cubic,
    const scalar featureAngle
)
{
    const patchOutline outline(patch, featureAngle);
    const pointField& points = patch.localPoints();
    NamedSets sets;

    addEdges(patch, cubic, "boundary", outline.boundary, sets);

    Info<< "Boundary of patch " << patch.name() << nl;
    forAll(outline.pieces, i)
    {
        const edgeList& edges = outline.pieces[i];
        const std::string name = "edge" + std::to_string(i);
        addEdges(patch, cubic, name, edges, sets);
        Info<< "    " << name.c_str() << "  from " << points[edges.first()[0]]
            << " by " << points[edges[edges.size()/2][0]] << " to "
            << points[edges.last()[1]] << nl;
    }
    forAll(outline.corners, i)
    {
        const std::string name = "corner" + std::to_string(i);
        sets[name] = {int(cubic.node(outline.corners[i]))};
        Info<< "    " << name.c_str() << "  " << points[outline.corners[i]]
            << nl;
    }
    Info<< endl;

    for (const word& name : outline.neighbours.sortedToc())
    {
        addEdges(patch, cubic, name, outline.neighbours[name], sets);
    }
    return sets;
}

} // End namespace Foam


positionalShell::ShellMesh Foam::patchShellMesh
(
    const polyPatch& patch,
    const patchShellOptions& options
)
{
    if (patch.empty())
    {
        fail(patch, "it has no faces");
    }

    triangleSurface surface;
    surface.source = "Patch " + patch.name();
    surface.mergeAdvice =
        "the two sides of a panel make no shell mesh; give each side a patch"
        " of its own";
    surface.turnAdvice =
        "the patch has both sides of a panel; give each side a patch of its"
        " own";
    surface.points = patch.localPoints();
    const std::vector<label> faceOf
    (
        facesToTriangles(patch, options.flip, surface.triangles)
    );
    surface.pointName = [&](const label point)
    {
        return "point " + std::to_string(patch.meshPoints()[point]);
    };
    surface.triangleName = [&](const label triangle)
    {
        return name(patch, faceOf[triangle]);
    };

    const cubicShellMesh cubic(surface);

    // Of faults first those of the faces, then those of the outline
    cubic.mesh({}, {});
    const NamedSets sets(outlineSets(patch, cubic, options.featureAngle));
    const ShellMesh mesh(cubic.mesh(sets, {}));
    cubic.report(mesh, options.featureAngle);
    return mesh;
}
