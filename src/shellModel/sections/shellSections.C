/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellSections.H"
#include "dictionaryCheck.H"
#include "shellInput.H"
#include "shellVector.H"
#include "unitConversion.H"

using positionalShell::Material;
using positionalShell::Section;

namespace Foam
{

//- The case's names of material parameters and those of the shell library;
//  both may be followed by the numbers of directions
static const std::vector<std::pair<std::string, std::string>> parameterNames
{
    {"E", "youngsModulus"},
    {"nu", "poissonRatio"},
    {"G", "shearModulus"},
    {"rho", "density"}
};


static std::string libraryName(const word& keyword)
{
    const std::string numbers("0123456789");
    const auto length = keyword.find_first_of(numbers);
    const std::string stem(keyword.substr(0, length));
    const std::string ending(keyword.substr(stem.size()));

    for (const auto& names : parameterNames)
    {
        if (names.first == stem)
        {
            return names.second + ending;
        }
    }
    return keyword;
}


//- A message of the library in terms of the case's names
static std::string inCaseTerms(std::string message)
{
    for (const auto& names : parameterNames)
    {
        const std::string& from = names.second;

        for
        (
            auto at = message.find(from);
            at != std::string::npos;
            at = message.find(from, at + names.first.size())
        )
        {
            message.replace(at, from.size(), names.first);
        }
    }
    return message;
}


static positionalShell::MaterialPtr readMaterial(const dictionary& dict)
{
    const word type(dict.get<word>("type"));

    const wordList ownEntries({"type", "axis", "angle"});

    Material::Parameters parameters;
    for (const entry& e : dict)
    {
        if (!ownEntries.found(e.keyword()))
        {
            parameters[libraryName(e.keyword())] =
                dict.get<scalar>(e.keyword());
        }
    }

    return rejectedIn(dict, [&]
    {
        try
        {
            return Material::create(type, parameters);
        }
        catch (const std::invalid_argument& problem)
        {
            throw std::invalid_argument(inCaseTerms(problem.what()));
        }
    });
}

//- Direction 1 of the material of a section
static void readDirection(const dictionary& dict, Section& section)
{
    const bool given = dict.found("axis") || dict.found("angle");
    if (!section.material->directional())
    {
        if (given)
        {
            FatalIOErrorInFunction(dict)
                << section.material->name() << " is the same in all directions:"
                << " remove axis and angle" << nl << exit(FatalIOError);
        }
        return;
    }

    const vector axis(dict.get<vector>("axis"));
    if (axis == vector::zero)
    {
        FatalIOErrorInFunction(dict)
            << "axis must not be zero" << nl << exit(FatalIOError);
    }
    section.axis = toShell(axis);
    section.angle = degToRad(dict.lookupOrDefault<scalar>("angle", 0));
}

} // End namespace Foam


std::vector<positionalShell::Section> Foam::readShellSections
(
    const dictionary& sections,
    const positionalShell::ShellMesh& mesh
)
{
    std::vector<Section> result;

    for (const entry& e : sections)
    {
        const dictionary& dict = sections.subDict(e.keyword());
        checkKeywords(dict, {"elementSet", "thickness", "material"});

        Section section;
        section.elementSet = dict.lookupOrDefault<word>("elementSet", "all");
        section.thickness = dict.get<scalar>("thickness");
        section.material = readMaterial(dict.subDict("material"));
        readDirection(dict.subDict("material"), section);

        // Here rather than in the model: the message then has the lines
        rejectedIn(dict, [&] { mesh.elementSet(section.elementSet); });
        if (section.thickness <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "thickness must be positive, not " << section.thickness
                << nl << exit(FatalIOError);
        }
        result.push_back(section);
    }

    if (result.empty())
    {
        FatalIOErrorInFunction(sections)
            << "No section: every element needs thickness and material" << nl
            << exit(FatalIOError);
    }
    return result;
}
