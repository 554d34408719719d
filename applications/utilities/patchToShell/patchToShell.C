/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    patchToShell

Description
    Makes the shell mesh constant/\<mesh\> of the faces of a patch of the gas
    mesh, with cubic triangles that have straight sides; the log says how far
    they may be from the smooth surface. The patch is taken as the mid-surface:
    of a panel meshed with its thickness take one side. Node sets come from the
    patch's boundary (patchShellMesh.H); the log says where each is.

Usage
    \verbatim
    patchToShell panel
    \endverbatim

    Options:
      - \par -mesh \<name\>
        Folder below constant, default shell
      - \par -featureAngle \<degrees\>
        Corners of the boundary turn by more, default 30
      - \par -flip
        Upper face towards the gas
      - \par -region \<name\>
        Mesh region
*/

#include "argList.H"
#include "patchShellMesh.H"
#include "polyMesh.H"
#include "shellMeshIO.H"
#include "Time.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote("Make a shell mesh of the faces of a patch");
    argList::noParallel();
    argList::addArgument("patch");
    argList::addOption
    (
        "mesh", "name", "Folder below constant (default: shell)"
    );
    argList::addOption
    (
        "featureAngle",
        "degrees",
        "Corners of the boundary turn by more (default: 30)"
    );
    argList::addBoolOption("flip", "Upper face towards the gas");
    #include "addRegionOption.H"

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createNamedPolyMesh.H"

    patchShellOptions options;
    args.readIfPresent("featureAngle", options.featureAngle);
    options.flip = args.found("flip");

    const word patchName(args[1]);
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label patchi = patches.findPatchID(patchName);
    if (patchi < 0)
    {
        FatalErrorInFunction
            << "Unknown patch " << patchName << nl
            << "    Valid patches are " << flatOutput(patches.names()) << nl
            << exit(FatalError);
    }

    const word meshName(args.lookupOrDefault<word>("mesh", "shell"));
    writeShellMesh
    (
        runTime, meshName, patchShellMesh(patches[patchi], options)
    );
    Info<< "Written to " << runTime.constant()/meshName << nl << nl
        << "End" << nl << endl;

    return 0;
}
