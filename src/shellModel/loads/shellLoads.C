/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellLoads.H"
#include "dictionaryCheck.H"
#include "kingeryBulmashLoad.H"
#include "shellInput.H"
#include "shellTimeFunction.H"
#include "shellVector.H"

#include "BlastWave.hpp"
#include "BodyForce.hpp"
#include "EdgeLoad.hpp"
#include "ElasticFoundation.hpp"
#include "FollowerPressure.hpp"
#include "NodalLoad.hpp"
#include "SurfaceTraction.hpp"
#include "TieLoad.hpp"

#include <functional>
#include <map>

using positionalShell::LoadPtr;
using positionalShell::TimeFunctionPtr;
using positionalShell::Vec3;

namespace Foam
{

typedef positionalShell::ShellModel Model;

//- Keywords of a type of load and its maker
struct loadType
{
    wordList keywords;
    std::function
    <
        LoadPtr(const Model&, const dictionary&, const TimeFunctionPtr& factor)
    > make;
};


static Vec3 vec3(const dictionary& dict, const word& keyword)
{
    return toShell(dict.get<vector>(keyword));
}


static Vec3 vec3OrZero(const dictionary& dict, const word& keyword)
{
    return toShell(dict.lookupOrDefault<vector>(keyword, Zero));
}


static std::string nodeSet(const dictionary& dict)
{
    return dict.get<word>("nodeSet");
}


static std::string elementSet(const dictionary& dict)
{
    return dict.lookupOrDefault<word>("elementSet", "all");
}


static scalar face(const dictionary& dict)
{
    if (!dict.found("face"))
    {
        return 0;
    }
    return selectEntry(dict, "face", {"lower", "middle", "upper"}) - 1;
}


static positionalShell::PressureFieldPtr blastWave(const dictionary& dict)
{
    auto blast = std::make_shared<positionalShell::BlastWave>();
    blast->centre = vec3(dict, "centre");
    blast->referenceDistance = dict.get<scalar>("referenceDistance");
    blast->peak = dict.get<scalar>("peak");
    blast->peakExponent = dict.lookupOrDefault<scalar>("peakExponent", 0);
    blast->arrival = dict.get<scalar>("arrival");
    blast->speed = dict.get<scalar>("speed");
    blast->duration = dict.get<scalar>("duration");
    blast->decay = dict.get<scalar>("decay");
    blast->check();
    return blast;
}


static const std::map<word, loadType>& loadTypes()
{
    using namespace positionalShell;
    typedef const dictionary& Dict;
    typedef const TimeFunctionPtr& Factor;

    static const std::map<word, loadType> types
    {
        {"nodal", {{"nodeSet", "force", "directorForce"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<NodalLoad>
                (
                    model,
                    nodeSet(dict),
                    vec3(dict, "force"),
                    factor,
                    vec3OrZero(dict, "directorForce")
                );
            }}},
        {"edge", {{"nodeSet", "forcePerLength", "directorForcePerLength"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<EdgeLoad>
                (
                    model,
                    nodeSet(dict),
                    vec3(dict, "forcePerLength"),
                    factor,
                    vec3OrZero(dict, "directorForcePerLength")
                );
            }}},
        {"traction", {{"elementSet", "traction"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<SurfaceTraction>
                (
                    model,
                    elementSet(dict),
                    vec3(dict, "traction"),
                    factor
                );
            }}},
        {"deadPressure", {{"elementSet", "pressure"},
            [](const Model& model, Dict dict, Factor factor)
            {
                return SurfaceTraction::deadPressure
                (
                    model,
                    elementSet(dict),
                    dict.get<scalar>("pressure"),
                    factor
                );
            }}},
        {"followerPressure", {{"elementSet", "pressure", "face"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<FollowerPressure>
                (
                    model,
                    elementSet(dict),
                    dict.get<scalar>("pressure"),
                    factor,
                    face(dict)
                );
            }}},
        {"blastWave",
            {{"elementSet", "face", "centre", "referenceDistance", "peak",
              "peakExponent", "arrival", "speed", "duration", "decay"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<FollowerPressure>
                (
                    model,
                    elementSet(dict),
                    blastWave(dict),
                    factor,
                    face(dict)
                );
            }}},
        {"kingeryBulmash",
            {{"elementSet", "face", "mass", "position", "burst", "pressure",
              "temperature"}, kingeryBulmashLoad}},
        {"rigidTie", {{"nodeSet", "force", "moment"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<TieLoad>
                (
                    model,
                    nodeSet(dict),
                    vec3OrZero(dict, "force"),
                    vec3OrZero(dict, "moment"),
                    factor
                );
            }}},
        {"elasticFoundation", {{"elementSet", "stiffness", "direction"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<ElasticFoundation>
                (
                    model,
                    elementSet(dict),
                    dict.get<scalar>("stiffness"),
                    vec3OrZero(dict, "direction"),
                    factor
                );
            }}},
        {"gravity", {{"g"},
            [](const Model& model, Dict dict, Factor factor) -> LoadPtr
            {
                return std::make_shared<BodyForce>
                (
                    model, vec3(dict, "g"), factor
                );
            }}}
    };
    return types;
}

} // End namespace Foam


positionalShell::Loads Foam::readShellLoads
(
    const dictionary& loads,
    const positionalShell::ShellModel& model
)
{
    wordList names;
    for (const auto& type : loadTypes())
    {
        names.append(type.first);
    }

    positionalShell::Loads result;
    for (const entry& e : loads)
    {
        const dictionary& dict = loads.subDict(e.keyword());
        const word& name = names[selectEntry(dict, "type", names)];
        const loadType& type = loadTypes().at(name);

        wordList keywords(type.keywords);
        keywords.append("type");
        keywords.append("factor");
        checkKeywords(dict, keywords);

        const TimeFunctionPtr factor(readLoadFactor("factor", dict));
        result.push_back
        (
            rejectedIn(dict, [&] { return type.make(model, dict, factor); })
        );
    }
    return result;
}
