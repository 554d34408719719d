/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshTriangles.H"
#include "UIndirectList.H"

#include <algorithm>
#include <array>

using Foam::gmshElement;
using Foam::gmshFile;
using Foam::label;
using Foam::labelList;

static void fail(const gmshFile& file, const std::string& what)
{
    using namespace Foam;

    FatalErrorInFunction
        << "gmsh file " << file.path().c_str() << ": " << what.c_str() << nl
        << exit(FatalError);
}


static std::string number(const gmshElement& element)
{
    return std::to_string(element.number);
}


//- Nodes in the other direction, starting from the same corner
static labelList reversed(const labelList& nodes)
{
    using namespace Foam;

    const labelList order
    (
        nodes.size() == 3 ? labelList({0, 2, 1})
      : nodes.size() == 6 ? labelList({0, 2, 1, 5, 4, 3})
      : labelList({0, 2, 1, 8, 7, 6, 5, 4, 3, 9})
    );
    return labelList(UIndirectList<label>(nodes, order));
}


//- A minus sign of a group turns its surfaces round
static void turn(const gmshFile& file, gmshElement& triangle)
{
    std::set<label> groups;
    label nMinus = 0;
    for (const label group : triangle.groups)
    {
        groups.insert(Foam::mag(group));
        nMinus += (group < 0);
    }
    if (nMinus == 0)
    {
        return;
    }
    if (nMinus < label(triangle.groups.size()))
    {
        fail
        (
            file,
            "surface " + std::to_string(triangle.entity) + " (triangle "
          + number(triangle) + ") is in physical groups with and without the"
            " minus sign, so that its upper side is not defined; use one sign"
        );
    }
    triangle.groups = groups;
    triangle.nodes = reversed(triangle.nodes);
}


static std::array<label, 3> corners(const gmshElement& triangle)
{
    std::array<label, 3> sorted;
    std::copy_n(triangle.nodes.begin(), 3, sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}


//- Add the groups of a triangle that the file lists again. MSH 2.2 lists a
//  triangle once per group
static void merge
(
    const gmshFile& file,
    gmshElement& first,
    const gmshElement& again
)
{
    std::set<label> groups(first.groups);
    groups.insert(again.groups.begin(), again.groups.end());

    const std::string both =
        "triangles " + number(first) + " and " + number(again);

    if
    (
        file.version() > 3
     || first.entity != again.entity
     || groups.size() < first.groups.size() + again.groups.size()
     || first.groups.empty()
     || again.groups.empty()
    )
    {
        fail(file, both + " have the same corners; remove one of them");
    }
    if (first.nodes != again.nodes)
    {
        fail
        (
            file,
            both + " are the same in two directions: surface "
          + std::to_string(first.entity) + " is in physical groups with and"
            " without the minus sign; use one sign"
        );
    }
    first.groups = groups;
}


std::vector<gmshElement> Foam::gmshTriangles(const gmshFile& file)
{
    std::vector<gmshElement> triangles;
    std::map<std::array<label, 3>, std::size_t> known;

    for (const gmshElement& element : file.elements())
    {
        if (element.type->dimension != 2)
        {
            continue;
        }
        gmshElement triangle(element);
        turn(file, triangle);

        const auto place = known.emplace(corners(triangle), triangles.size());
        if (place.second)
        {
            triangles.push_back(triangle);
        }
        else
        {
            merge(file, triangles[place.first->second], triangle);
        }
        if (triangle.type->order != triangles.front().type->order)
        {
            fail
            (
                file,
                "triangle " + number(triangles.front()) + " is of order "
              + std::to_string(triangles.front().type->order) + ", triangle "
              + number(triangle) + " of order "
              + std::to_string(triangle.type->order)
              + "; save the whole mesh with one Mesh.ElementOrder"
            );
        }
    }
    if (triangles.empty())
    {
        fail
        (
            file,
            "there are no triangles; mesh the surfaces (gmsh -2), and give"
            " them a physical group or save with Mesh.SaveAll = 1"
        );
    }
    return triangles;
}
