/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellMeshIO.H"
#include "shellFile.H"
#include "shellInput.H"
#include "shellVector.H"
#include "IOdictionary.H"
#include "labelListIOList.H"
#include "OSspecific.H"
#include "vectorIOField.H"

using positionalShell::NamedSets;
using positionalShell::ShellMesh;
using positionalShell::Triangle;
using positionalShell::Vec3;

namespace Foam
{

static fileName meshFolder(const Time& runTime, const word& meshName)
{
    return runTime.constant()/meshName;
}


static std::vector<Vec3> readVectors
(
    const Time& runTime,
    const fileName& folder,
    const word& name
)
{
    const vectorIOField values(shellFile(runTime, folder, name));

    std::vector<Vec3> result;
    result.reserve(values.size());
    for (const vector& v : values)
    {
        result.push_back(toShell(v));
    }
    return result;
}


static vectorField toFoam(const std::vector<Vec3>& vectors)
{
    vectorField result(label(vectors.size()));
    forAll(result, i)
    {
        result[i] = toFoam(vectors[i]);
    }
    return result;
}


static std::vector<Triangle> readTriangles
(
    const Time& runTime,
    const fileName& folder
)
{
    const labelListIOList lists(shellFile(runTime, folder, "triangles"));

    std::vector<Triangle> triangles(lists.size());
    forAll(lists, elementi)
    {
        const labelList& nodes = lists[elementi];

        if (nodes.size() != positionalShell::nodesPerElement)
        {
            FatalErrorInFunction
                << "Triangle " << elementi << " of " << lists.objectPath()
                << " has " << nodes.size() << " nodes; a cubic triangle has "
                << label(positionalShell::nodesPerElement) << nl
                << exit(FatalError);
        }
        std::copy(nodes.begin(), nodes.end(), triangles[elementi].begin());
    }
    return triangles;
}


static NamedSets readSets
(
    const Time& runTime,
    const fileName& folder,
    const word& name
)
{
    const IOdictionary dict
    (
        shellFile(runTime, folder, name, IOobject::READ_IF_PRESENT)
    );

    NamedSets sets;
    for (const entry& e : dict)
    {
        const labelList members(dict.get<labelList>(e.keyword()));
        sets[e.keyword()].assign(members.begin(), members.end());
    }
    return sets;
}


static dictionary setsDict(const NamedSets& sets)
{
    dictionary dict;
    for (const auto& set : sets)
    {
        if (set.first != "all")
        {
            labelList members(label(set.second.size()));
            std::copy(set.second.begin(), set.second.end(), members.begin());
            dict.add(word(set.first), members);
        }
    }
    return dict;
}

} // End namespace Foam


positionalShell::ShellMesh Foam::readShellMesh
(
    const Time& runTime,
    const word& meshName
)
{
    const fileName folder(meshFolder(runTime, meshName));

    if (!shellFileExists(runTime, folder, "nodes"))
    {
        FatalErrorInFunction
            << "No shell mesh in " << runTime.globalPath()/folder << nl
            << "    Make one first, with blockShell, gmshToShell or"
            << " patchToShell, or correct the entry mesh of"
            << " constant/shellProperties" << nl
            << exit(FatalError);
    }

    const bool directors = shellFileExists(runTime, folder, "directors");

    try
    {
        return ShellMesh
        (
            readVectors(runTime, folder, "nodes"),
            readTriangles(runTime, folder),
            readSets(runTime, folder, "nodeSets"),
            readSets(runTime, folder, "elementSets"),
            directors
          ? readVectors(runTime, folder, "directors")
          : std::vector<Vec3>()
        );
    }
    catch (const std::invalid_argument& problem)
    {
        FatalErrorInFunction
            << "Shell mesh " << runTime.globalPath()/folder << ": "
            << problem.what() << nl
            << exit(FatalError);
        throw;
    }
}


void Foam::writeShellMesh
(
    const Time& runTime,
    const word& meshName,
    const positionalShell::ShellMesh& mesh,
    const bool directors
)
{
    const fileName folder(meshFolder(runTime, meshName));

    labelListList triangles(mesh.nElements());
    forAll(triangles, elementi)
    {
        const Triangle& t = mesh.triangle(elementi);
        triangles[elementi] = labelList(t.begin(), t.end());
    }

    const auto write = [&]
    (
        const word& name,
        const word& className,
        const auto& contents
    )
    {
        writeShellFile(runTime, folder, name, className, contents);
    };

    write("nodes", vectorIOField::typeName, toFoam(mesh.nodes()));
    write("triangles", labelListIOList::typeName, triangles);
    write("nodeSets", dictionary::typeName, setsDict(mesh.nodeSets()));
    write("elementSets", dictionary::typeName, setsDict(mesh.elementSets()));

    if (directors)
    {
        write("directors", vectorIOField::typeName, toFoam(mesh.directors()));
    }
    else if (Pstream::master())
    {
        rm(runTime.globalPath()/folder/"directors");
    }
}
