/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellBlock.H"
#include "dictionaryCheck.H"
#include "shellInput.H"
#include "shellSurface.H"
#include "shellVector.H"
#include "StructuredMesh.hpp"

#include <algorithm>
#include <numeric>

using positionalShell::ShellMesh;

namespace Foam
{

//- An entry that is a word or a list of words
static wordList readWords(const dictionary& dict, const word& keyword)
{
    ITstream& is = dict.lookup(keyword);
    token first(is);

    if (first.isWord())
    {
        return wordList(1, first.wordToken());
    }
    is.putBack(first);
    return wordList(is);
}


static std::pair<label, label> readDivisions(const dictionary& dict)
{
    const labelList n(dict.get<labelList>("divisions"));

    if (n.size() != 2 || n[0] < 1 || n[1] < 1)
    {
        FatalIOErrorInFunction(dict)
            << "divisions must be two positive numbers, (nU nV), not "
            << flatOutput(n) << nl << exit(FatalIOError);
    }
    return {n[0], n[1]};
}


//- Named unions of the edges and corners that the mesh comes with
static void addNodeSets(const dictionary& sets, ShellMesh& mesh)
{
    for (const entry& e : sets)
    {
        const word& name = e.keyword();

        std::vector<int> nodes;
        for (const word& edge : readWords(sets, name))
        {
            const std::vector<int>& part =
                rejectedIn(sets, [&]() -> const std::vector<int>&
                {
                    return mesh.nodeSet(edge);
                });
            nodes.insert(nodes.end(), part.begin(), part.end());
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());

        rejectedIn(sets, [&] { mesh.addNodeSet(name, nodes); });
    }
}


static void addElementSet(const dictionary& dict, ShellMesh& mesh)
{
    if (dict.found("elementSet"))
    {
        std::vector<int> elements(mesh.nElements());
        std::iota(elements.begin(), elements.end(), 0);

        rejectedIn(dict, [&]
        {
            mesh.addElementSet(dict.get<word>("elementSet"), elements);
        });
    }
}

} // End namespace Foam


positionalShell::ShellMesh Foam::makeShellBlock(const dictionary& dict)
{
    checkKeywords
    (
        dict, {"mesh", "surface", "divisions", "elementSet", "nodeSets"}
    );

    const auto surface = shellSurface::New(dict.subDict("surface"));
    const auto divisions = readDivisions(dict);

    ShellMesh mesh
    (
        rejectedIn(dict, [&]
        {
            return positionalShell::structuredMesh
            (
                divisions.first,
                divisions.second,
                [&](double u, double v)
                {
                    return toShell(surface->position(u, v));
                },
                [&](double u, double v)
                {
                    return toShell(surface->normal(u, v));
                }
            );
        })
    );

    addElementSet(dict, mesh);
    addNodeSets(dict.subOrEmptyDict("nodeSets"), mesh);
    return mesh;
}
