/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    gmshToShell

Description
    Makes the shell mesh constant/\<mesh\> of the triangles of a gmsh file:
    MSH 2.2 or 4.1, ASCII or binary, order 1, 2 or 3. Orders 1 and 2 are raised
    to 3 without a change of shape; the log says how far such triangles may be
    from the smooth surface. Physical groups become node and element sets
    (gmshShellMesh.H).

Usage
    \verbatim
    gmsh -2 -order 3 panel.geo
    gmshToShell panel.msh
    \endverbatim

    Options:
      - \par -mesh \<name\>
        Folder below constant, default shell
      - \par -scale \<factor\>
        From the file's unit of length to metres, default 1
      - \par -featureAngle \<degrees\>
        Folds sharper than this are no geometric error, default 30
      - \par -noGroups
        Accept a file without physical groups
*/

#include "argList.H"
#include "gmshShellMesh.H"
#include "shellMeshIO.H"
#include "Time.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote("Make a shell mesh of the triangles of a gmsh file");
    argList::noParallel();
    argList::addArgument("file.msh");
    argList::addOption
    (
        "mesh", "name", "Folder below constant (default: shell)"
    );
    argList::addOption
    (
        "scale", "factor", "From the file's unit to metres (default: 1)"
    );
    argList::addOption
    (
        "featureAngle",
        "degrees",
        "Folds sharper than this are no geometric error (default: 30)"
    );
    argList::addBoolOption
    (
        "noGroups", "Accept a file without physical groups"
    );

    #include "setRootCase.H"
    #include "createTime.H"

    gmshShellOptions options;
    args.readIfPresent("scale", options.scale);
    args.readIfPresent("featureAngle", options.featureAngle);
    options.noGroups = args.found("noGroups");

    if (options.scale <= 0)
    {
        FatalErrorInFunction
            << "Option -scale must be positive, not " << options.scale << nl
            << exit(FatalError);
    }

    const fileName path(args[1]);
    const gmshFile file(path);
    const word meshName(args.lookupOrDefault<word>("mesh", "shell"));

    writeShellMesh(runTime, meshName, gmshShellMesh(file, options));
    Info<< "Written to " << runTime.constant()/meshName << nl << nl
        << "End" << nl << endl;

    return 0;
}
