/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "cubicShellMesh.H"
#include "boundBox.H"
#include "CubicTriangle.hpp"
#include "ListOps.H"
#include "mergePoints.H"
#include "shellVector.H"
#include "unitConversion.H"

using positionalShell::CubicEdge;
using positionalShell::MeshNames;
using positionalShell::NamedSets;
using positionalShell::ShellMesh;
using positionalShell::Vec3;

// Points nearer than this times the size of the surface are at one place:
// what single precision leaves of equal coordinates
static constexpr Foam::scalar samePlace = 1e-7;


static std::vector<Vec3> positions(const Foam::pointField& points)
{
    std::vector<Vec3> result;
    for (const Foam::point& p : points)
    {
        result.push_back(Foam::toShell(p));
    }
    return result;
}


Foam::cubicShellMesh::cubicShellMesh(const triangleSurface& surface)
:
    surface_(surface),
    nodeOf_(surface.points.size(), -1)
{
    if (surface.triangles.empty())
    {
        fail("there are no triangles");
    }
    checkDistinct();

    raised_ = positionalShell::raisedTriangles
    (
        surface.order, positions(surface.points), surface.triangles
    );

    for (std::size_t i = 0; i < raised_.source.size(); ++i)
    {
        if (raised_.source[i] >= 0)
        {
            nodeOf_[raised_.source[i]] = label(i);
        }
    }
    for (const auto& triangle : raised_.triangles)
    {
        for (const auto& places : positionalShell::CubicTriangle::edgeNodes())
        {
            CubicEdge edge;
            for (label i = 0; i < 4; ++i)
            {
                edge[i] = triangle[places[i]];
            }
            edges_.emplace(std::minmax(edge[0], edge[3]), edge);
        }
    }
}


void Foam::cubicShellMesh::fail(const std::string& what) const
{
    FatalErrorInFunction
        << surface_.source.c_str() << ": " << what.c_str() << nl
        << exit(FatalError);
}


void Foam::cubicShellMesh::checkDistinct() const
{
    // Points that no triangle has are left out of the mesh
    bitSet used(surface_.points.size());
    for (const auto& triangle : surface_.triangles)
    {
        for (const int point : triangle)
        {
            used.set(point);
        }
    }
    const labelList members(used.sortedToc());
    const pointField points(surface_.points, members);

    labelList merged;
    const label n = mergePoints
    (
        points, samePlace*boundBox(points).mag(), false, merged
    );
    if (n == points.size())
    {
        return;
    }

    labelList first(n, -1);
    forAll(merged, i)
    {
        const label other = first[merged[i]];
        if (other >= 0)
        {
            OStringStream at;
            at << points[i];
            fail
            (
                surface_.pointName(members[other]) + " and "
              + surface_.pointName(members[i]) + " are at the same place, "
              + at.str() + ": " + surface_.mergeAdvice
            );
        }
        first[merged[i]] = i;
    }
}


positionalShell::MeshNames Foam::cubicShellMesh::names() const
{
    MeshNames names;
    names.node = [this](int node) -> std::string
    {
        const int source = raised_.source[node];
        return source < 0
          ? std::string("a node inside a triangle or on its edge")
          : surface_.pointName(source);
    };
    names.element = [this](int element)
    {
        return surface_.triangleName(element);
    };
    return names;
}


const positionalShell::CubicEdge* Foam::cubicShellMesh::edge
(
    const label point0,
    const label point1
) const
{
    const auto found =
        edges_.find(std::minmax(int(nodeOf_[point0]), int(nodeOf_[point1])));
    return found == edges_.end() ? nullptr : &found->second;
}


positionalShell::ShellMesh Foam::cubicShellMesh::mesh
(
    const NamedSets& nodeSets,
    const NamedSets& elementSets
) const
{
    try
    {
        return ShellMesh
        (
            raised_.nodes, raised_.triangles, nodeSets, elementSets, {},
            names()
        );
    }
    catch (const std::invalid_argument& problem)
    {
        std::string what(problem.what());
        if (what.find("oriented against each other") != std::string::npos)
        {
            what += " (" + surface_.turnAdvice + ")";
        }
        fail(what);
        throw;
    }
}


void Foam::cubicShellMesh::report
(
    const ShellMesh& mesh,
    const scalar featureAngle
) const
{
    Info<< "Shell mesh" << nl
        << "    triangles  " << label(mesh.nElements())
        << ", of order " << surface_.order
        << (surface_.order < 3 ? " raised to 3" : "") << nl
        << "    nodes      " << label(mesh.nNodes()) << nl;

    if (surface_.order < 3)
    {
        const auto error = positionalShell::geometricError
        (
            int(surface_.order), raised_, degToRad(featureAngle)
        );
        Info<< "    geometric error  " << error.distance
            << " m from the smooth surface at most (estimate), at "
            << surface_.triangleName(error.element).c_str() << nl
            << "    normals          " << radToDeg(error.angle)
            << " deg at most off their mean at a node" << nl
            << "    Folds sharper than " << featureAngle
            << " deg are taken as meant." << nl;
        if (error.distance > SMALL*mesh.lengthScale())
        {
            Info<< "    Triangles of order 3 follow a curved surface better."
                << nl;
        }
    }
    reportSets(mesh);
}


void Foam::reportSets(const positionalShell::ShellMesh& mesh)
{
    const auto list = [](const char* title, const NamedSets& sets)
    {
        Info<< title << nl;
        for (const auto& set : sets)
        {
            Info<< "    " << set.first.c_str() << "  "
                << label(set.second.size()) << nl;
        }
    };
    list("Node sets", mesh.nodeSets());
    list("Element sets", mesh.elementSets());
    Info<< endl;
}
