/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshElementType.H"

#include <map>
#include <set>

namespace
{

const std::map<Foam::label, Foam::gmshElementType>& usable()
{
    static const std::map<Foam::label, Foam::gmshElementType> types
    {
        {15, {0, 1, 1}},
        {1, {1, 1, 2}}, {8, {1, 2, 3}}, {26, {1, 3, 4}},
        {2, {2, 1, 3}}, {9, {2, 2, 6}}, {21, {2, 3, 10}}
    };
    return types;
}

} // End anonymous namespace


const Foam::gmshElementType* Foam::gmshElementType::find(const label type)
{
    const auto found = usable().find(type);
    return found == usable().end() ? nullptr : &found->second;
}


std::string Foam::gmshElementType::unusable(const label type)
{
    static const std::set<label> quads{3, 10, 16, 36, 37, 38, 39, 40, 47, 48};
    static const std::set<label> incomplete{20, 22, 24, 52, 53, 54};
    static const std::set<label> higher{23, 25, 42, 43, 44, 45, 46, 27, 28};
    static const std::set<label> volumes
    {
        4, 5, 6, 7, 11, 12, 13, 14, 17, 18, 19, 29, 30, 31, 71, 72, 90, 92, 106,
        118, 125
    };

    if (quads.count(type))
    {
        return "a quadrilateral; a shell is made of triangles: mesh without"
            " Recombine Surface and with Mesh.RecombineAll = 0";
    }
    if (incomplete.count(type))
    {
        return "a triangle without nodes inside; mesh with"
            " Mesh.SecondOrderIncomplete = 0";
    }
    if (higher.count(type))
    {
        return "of an order above 3; mesh with Mesh.ElementOrder = 3 or less";
    }
    if (volumes.count(type))
    {
        return "a volume element; mesh the surface only (gmsh -2), with"
            " physical groups of points, curves and surfaces";
    }
    return "of no type that a shell can use: point, line or complete triangle"
        " of order 1 to 3";
}
