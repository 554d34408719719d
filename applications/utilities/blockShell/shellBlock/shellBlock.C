/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellBlock.H"
#include "dictionaryCheck.H"
#include "lineDivide.H"
#include "lineEdge.H"
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


//- Lines between n quadrilaterals, graded as blockMesh grades an edge
static std::vector<double> lines
(
    const dictionary& dict,
    const label n,
    const gradingDescriptors& grading
)
{
    if (n < grading.size())
    {
        FatalIOErrorInFunction(dict)
            << "grading has " << grading.size() << " sections for " << n
            << " divisions; there must be as many divisions at least" << nl
            << exit(FatalIOError);
    }
    const pointField ends({vector::zero, vector(1, 0, 0)});
    const lineDivide division(blockEdges::lineEdge(ends, 0, 1), n, grading);

    // The ends are what the surface is closed at: exact
    std::vector<double> result
    (
        division.lambdaDivisions().begin(), division.lambdaDivisions().end()
    );
    result.front() = 0;
    result.back() = 1;
    return result;
}


static positionalShell::StructuredLayout readLayout
(
    const dictionary& dict,
    const shellSurface& surface
)
{
    gradingDescriptors gradingU;
    gradingDescriptors gradingV;
    if (dict.found("grading"))
    {
        ITstream& is = dict.lookup("grading");
        is.readBegin("grading");
        is >> gradingU >> gradingV;
        is.readEnd("grading");
    }
    const auto n = readDivisions(dict);

    positionalShell::StructuredLayout layout;
    layout.u = lines(dict, n.first, gradingU);
    layout.v = lines(dict, n.second, gradingV);
    layout.closedU = surface.closedU();
    layout.poleVMin = surface.pole(0);
    layout.poleVMax = surface.pole(1);
    return layout;
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
        dict,
        {
            "mesh", "surface", "divisions", "grading", "elementSet", "nodeSets"
        }
    );

    const auto surface = shellSurface::New(dict.subDict("surface"));
    const auto layout = readLayout(dict, surface());

    ShellMesh mesh
    (
        rejectedIn(dict, [&]
        {
            return positionalShell::structuredMesh
            (
                layout,
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
