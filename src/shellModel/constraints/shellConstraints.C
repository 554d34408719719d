/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellConstraints.H"
#include "dictionaryCheck.H"
#include "shellInput.H"
#include "shellTimeFunction.H"
#include "shellVector.H"

#include <functional>
#include <map>

using positionalShell::Component;
using positionalShell::Constraints;

namespace Foam
{

//- Keywords of a type of constraint and what it does
struct constraintType
{
    wordList keywords;
    std::function<void(Constraints&, const dictionary&, bool dynamic)> add;
};


static std::string setName(const dictionary& dict)
{
    return dict.get<word>("nodeSet");
}


static Component component(const dictionary& dict)
{
    return readComponent(dict, dict.get<word>("component"));
}


static std::vector<Component> components(const dictionary& dict)
{
    std::vector<Component> result;
    for (const word& name : dict.get<wordList>("components"))
    {
        result.push_back(readComponent(dict, name));
    }
    return result;
}


//- The parts that are given: a displacement with its direction, an angle with
//  its axis
static positionalShell::RigidMotion rigidMotion
(
    const dictionary& dict,
    const bool dynamic
)
{
    positionalShell::RigidMotion motion;
    motion.point = toShell(dict.get<vector>("point"));
    if (dict.found("displacement") || dict.found("direction"))
    {
        motion.direction = toShell(dict.get<vector>("direction"));
        motion.displacement = readMotion("displacement", dict, dynamic);
    }
    if (dict.found("angle") || dict.found("axis"))
    {
        motion.axis = toShell(dict.get<vector>("axis"));
        motion.angle = readMotion("angle", dict, dynamic);
    }
    return motion;
}


static const std::map<word, constraintType>& constraintTypes()
{
    static const std::map<word, constraintType> types
    {
        {"clamped", {{"nodeSet"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.clamped(setName(dict));
            }}},
        {"hinged", {{"nodeSet"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.hinged(setName(dict));
            }}},
        {"symmetryPlane", {{"nodeSet", "normal"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.symmetryPlane(setName(dict), readAxis(dict, "normal"));
            }}},
        {"fixed", {{"nodeSet", "components"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.fixed(setName(dict), components(dict));
            }}},
        {"prescribed", {{"nodeSet", "component", "displacement"},
            [](Constraints& c, const dictionary& dict, bool dynamic)
            {
                c.prescribed
                (
                    setName(dict),
                    component(dict),
                    readMotion("displacement", dict, dynamic)
                );
            }}},
        {"tied", {{"nodeSet", "component"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.tied(setName(dict), component(dict));
            }}},
        {"rigidTie", {{"nodeSet", "point"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.rigidTie(setName(dict), toShell(dict.get<vector>("point")));
            }}},
        {"rigidMotion",
            {{"nodeSet", "point", "direction", "displacement", "axis",
              "angle"},
            [](Constraints& c, const dictionary& dict, bool dynamic)
            {
                c.rigidMotion(setName(dict), rigidMotion(dict, dynamic));
            }}},
        {"planeStrainStrip", {{"direction"},
            [](Constraints& c, const dictionary& dict, bool)
            {
                c.planeStrainStrip(readAxis(dict, "direction"));
            }}}
    };
    return types;
}


static wordList typeNames()
{
    wordList names;
    for (const auto& type : constraintTypes())
    {
        names.append(type.first);
    }
    return names;
}

} // End namespace Foam


positionalShell::DofMap Foam::readShellConstraints
(
    const dictionary& constraints,
    const positionalShell::ShellMesh& mesh,
    const bool dynamic
)
{
    Constraints result(mesh);

    for (const entry& e : constraints)
    {
        const dictionary& dict = constraints.subDict(e.keyword());
        const wordList names(typeNames());
        const word& name = names[selectEntry(dict, "type", names)];
        const constraintType& type = constraintTypes().at(name);

        wordList keywords(type.keywords);
        keywords.append("type");
        checkKeywords(dict, keywords);

        rejectedIn(dict, [&] { type.add(result, dict, dynamic); });
    }

    return rejectedIn(constraints, [&] { return result.dofMap(); });
}


std::vector<std::pair<Foam::word, Foam::word>> Foam::supportSets
(
    const dictionary& constraints
)
{
    std::vector<std::pair<word, word>> result;
    for (const entry& e : constraints)
    {
        const dictionary& dict = constraints.subDict(e.keyword());
        const word type(dict.get<word>("type"));
        const bool free = type == "tied" || type == "rigidTie";
        if (dict.found("nodeSet") && !free)
        {
            result.push_back({e.keyword(), dict.get<word>("nodeSet")});
        }
    }
    return result;
}


Foam::vector Foam::planeStrainDirection(const dictionary& constraints)
{
    for (const entry& e : constraints)
    {
        const dictionary& dict = constraints.subDict(e.keyword());
        if (dict.get<word>("type") == "planeStrainStrip")
        {
            return normalised(dict.get<vector>("direction"));
        }
    }
    return Zero;
}
