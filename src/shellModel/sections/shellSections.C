/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellSections.H"
#include "dictionaryCheck.H"
#include "shellInput.H"

using positionalShell::Material;
using positionalShell::Section;

namespace Foam
{

//- The case's names of material parameters and those of the shell library
static const std::vector<std::pair<std::string, std::string>> parameterNames
{
    {"E", "youngsModulus"},
    {"nu", "poissonRatio"},
    {"rho", "density"}
};


static std::string libraryName(const word& keyword)
{
    for (const auto& names : parameterNames)
    {
        if (names.first == keyword)
        {
            return names.second;
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

    Material::Parameters parameters;
    for (const entry& e : dict)
    {
        if (e.keyword() != "type")
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
