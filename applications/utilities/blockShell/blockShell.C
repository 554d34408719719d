/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    blockShell

Description
    Makes a shell mesh of cubic triangles, two per quadrilateral, from
    system/blockShellDict, and writes it to constant/\<mesh\>.

Usage
    Example of system/blockShellDict:
    \verbatim
    mesh        shell;

    surface
    {
        type    plate;
        origin  (0.0005 0.015 0);
        sideU   (0 0.05 0);
        sideV   (0 0 0.001);
    }

    divisions   (16 1);
    grading     (((0.5 0.5 4) (0.5 0.5 0.25)) 1);

    elementSet  panel;

    nodeSets
    {
        base    uMin;
        sides   (vMin vMax);
    }
    \endverbatim

    \table
        Property   | Description                           | Default
        mesh       | folder below constant                 | shell
        surface    | plate cylinder cone sphere (*.H here) | required
        divisions  | quadrilaterals along u and v          | required
        grading    | along u and v, each as blockMesh's    | (1 1)
        elementSet | a name for all elements, beside "all" | none
        nodeSets   | name edge; or name (edge edge ...);   | none
    \endtable

    The edges are uMin uMax vMin vMax, the corners uMinVMin uMaxVMin uMinVMax
    uMaxVMax; these names are node sets of the mesh too. The shell's normal
    (upper face) is along du x dv; nodes lie on the surface, and its normals at
    the nodes are written too. On a closed surface uMin and uMax are both the
    seam. An edge that is a single point (the pole of a sphere, the tip of a
    cone) has one triangle per division of u.
*/

#include "argList.H"
#include "IOdictionary.H"
#include "Time.H"
#include "cubicShellMesh.H"
#include "shellBlock.H"
#include "shellMeshIO.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Make a shell mesh of cubic triangles from system/blockShellDict"
    );
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"

    const IOdictionary dict
    (
        IOobject
        (
            "blockShellDict",
            runTime.system(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const word meshName(dict.lookupOrDefault<word>("mesh", "shell"));

    const positionalShell::ShellMesh mesh(makeShellBlock(dict));
    writeShellMesh(runTime, meshName, mesh, true);

    Info<< "Shell mesh " << runTime.constant()/meshName << ": "
        << label(mesh.nElements()) << " cubic triangles, "
        << label(mesh.nNodes()) << " nodes" << nl << nl;
    reportSets(mesh);
    Info<< "End" << nl << endl;

    return 0;
}
