/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshShellMesh.H"
#include "cubicShellMesh.H"
#include "gmshTriangles.H"

using positionalShell::CubicEdge;
using positionalShell::NamedSets;
using positionalShell::ShellMesh;

namespace Foam
{

//- Sets of a mesh under construction
class gmshSets
{
    const gmshFile& file_;
    const cubicShellMesh& cubic_;

    //- Group of each name
    std::map<std::string, std::pair<label, label>> groupOf_;

public:

    NamedSets nodes;
    NamedSets elements;

    gmshSets(const gmshFile& file, const cubicShellMesh& cubic)
    :
        file_(file),
        cubic_(cubic)
    {}

    //- The name of a group; stops when it cannot be a set's
    std::string name(const label dimension, const label group);

    void addTriangle(const label index, const gmshElement&);
    void addPoint(const gmshElement&);
    void addLine(const gmshElement&);

    //- Stop for named groups without elements, and for no groups
    void check(const bool noGroups) const;
};


static const char* kind(const label dimension)
{
    return dimension == 0 ? "point" : dimension == 1 ? "curve" : "surface";
}


static bool isSetName(const std::string& name)
{
    const auto letter = [](unsigned char c)
    {
        return c < 128 && (std::isalpha(c) || c == '_');
    };
    bool valid = !name.empty() && letter(name[0]) && name != "all";
    for (const unsigned char c : name)
    {
        valid = valid && (letter(c) || std::isdigit(c) || c == '-' || c == '.');
    }
    return valid;
}


std::string gmshSets::name(const label dimension, const label group)
{
    const std::string id =
        "physical group " + std::to_string(group) + " of "
      + kind(dimension) + "s";

    const auto given = file_.groupNames().find({dimension, group});
    const std::string name =
        given == file_.groupNames().end()
      ? kind(dimension) + std::to_string(group)
      : given->second;

    if (!isSetName(name))
    {
        cubic_.fail
        (
            id + " has the name '" + name + "', which cannot be a set's;"
            " rename it: letters, digits, _ - . and a letter first, not 'all'"
        );
    }
    const auto place = groupOf_.emplace(name, std::make_pair(dimension, group));
    if (place.first->second != std::make_pair(dimension, group))
    {
        cubic_.fail
        (
            id + " has the name '" + name + "', which physical group "
          + std::to_string(place.first->second.second) + " of "
          + kind(place.first->second.first) + "s has too; rename one"
        );
    }
    return name;
}


void gmshSets::addTriangle(const label index, const gmshElement& triangle)
{
    for (const label group : triangle.groups)
    {
        const std::string name = this->name(2, group);
        elements[name].push_back(int(index));
        for (const int node : cubic_.triangles()[index])
        {
            nodes[name].push_back(node);
        }
    }
}


void gmshSets::addPoint(const gmshElement& point)
{
    for (const label group : point.groups)
    {
        const label node = cubic_.node(point.nodes[0]);
        const std::string name = this->name(0, mag(group));
        if (node < 0)
        {
            cubic_.fail
            (
                "point " + std::to_string(point.number) + " of the group "
              + name + " is node "
              + std::to_string(file_.number(point.nodes[0]))
              + ", which no triangle has: embed the point in the surface"
                " (Point{} In Surface{}), or take it out of the group"
            );
        }
        nodes[name].push_back(int(node));
    }
}


void gmshSets::addLine(const gmshElement& line)
{
    for (const label group : line.groups)
    {
        const CubicEdge* edge = cubic_.edge(line.nodes[0], line.nodes[1]);
        const std::string name = this->name(1, mag(group));
        if (!edge)
        {
            cubic_.fail
            (
                "line " + std::to_string(line.number) + " of the group " + name
              + " joins nodes " + std::to_string(file_.number(line.nodes[0]))
              + " and " + std::to_string(file_.number(line.nodes[1]))
              + ", but no triangle has that edge: embed the curve in the"
                " surface (Curve{} In Surface{}), or take it out of the group"
            );
        }
        nodes[name].insert(nodes[name].end(), edge->begin(), edge->end());
    }
}


void gmshSets::check(const bool noGroups) const
{
    for (const auto& group : file_.groupNames())
    {
        const label dimension = group.first.first;
        if (dimension < 3 && !groupOf_.count(group.second))
        {
            cubic_.fail
            (
                "physical group " + std::to_string(group.first.second) + " of "
              + kind(dimension) + "s, '" + group.second + "', has no element:"
                " mesh what it holds, or remove the group"
            );
        }
    }
    if (groupOf_.empty() && !noGroups)
    {
        cubic_.fail
        (
            "there are no physical groups, hence no sets to hold the shell by:"
            " add Physical Curve(\"base\") = {...}; and the like, or accept it"
            " with the option -noGroups"
        );
    }
}


static triangleSurface surfaceOf
(
    const gmshFile& file,
    const std::vector<gmshElement>& triangles,
    const scalar scale
)
{
    triangleSurface surface;
    surface.source = "gmsh file " + file.path();
    surface.mergeAdvice =
        "surfaces that touch must share their curves (Coherence;) and the mesh"
        " its nodes (Coherence Mesh;)";
    surface.turnAdvice =
        "Reverse Surface, ReverseMesh Surface, or a minus sign in the physical"
        " group of one surface";
    surface.order = triangles.front().type->order;
    surface.points = scale*file.points();
    for (const gmshElement& triangle : triangles)
    {
        surface.triangles.emplace_back
        (
            triangle.nodes.begin(), triangle.nodes.end()
        );
    }
    surface.pointName = [&](label point)
    {
        return "node " + std::to_string(file.number(point));
    };
    surface.triangleName = [&](label i)
    {
        return "triangle " + std::to_string(triangles[i].number)
          + " (surface " + std::to_string(triangles[i].entity) + ")";
    };
    return surface;
}

} // End namespace Foam


positionalShell::ShellMesh Foam::gmshShellMesh
(
    const gmshFile& file,
    const gmshShellOptions& options
)
{
    const std::vector<gmshElement> triangles(gmshTriangles(file));
    const triangleSurface surface(surfaceOf(file, triangles, options.scale));
    const cubicShellMesh cubic(surface);

    // The shape first: sets of a wrong mesh mislead
    cubic.mesh({}, {});

    gmshSets sets(file, cubic);
    label index = 0;
    for (const gmshElement& triangle : triangles)
    {
        sets.addTriangle(index++, triangle);
    }
    for (const gmshElement& element : file.elements())
    {
        if (element.type->dimension == 0)
        {
            sets.addPoint(element);
        }
        else if (element.type->dimension == 1)
        {
            sets.addLine(element);
        }
    }

    sets.check(options.noGroups);
    const ShellMesh mesh(cubic.mesh(sets.nodes, sets.elements));

    Info<< "gmsh file " << file.path() << ": MSH " << file.version()
        << (file.binary() ? ", binary" : ", ASCII") << nl << nl;
    cubic.report(mesh, options.featureAngle);
    return mesh;
}
