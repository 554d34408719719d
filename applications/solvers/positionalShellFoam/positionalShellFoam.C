/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    positionalShellFoam

Description
    Shells alone, statics or dynamics, by the positional finite element method:
    needs no fluid mesh.

    Reads constant/shellProperties (shellModel.H) and the shell mesh in
    constant/\<mesh\> (blockShell). In statics time is the load parameter and
    every time step one load step.

Usage
    \b positionalShellFoam [OPTION]

    Options:
      - \par -modes \<n\>
        Only find the n lowest frequencies of small vibrations about the state
        at the start, and write the modes to VTK/modes.pvd

      - \par -shift \<s\>
        With -modes: shift of the squares of the angular frequencies [1/s2];
        negative for a shell that can move freely
*/

#include "argList.H"
#include "Time.H"
#include "shellModel.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Statics or dynamics of shells alone (positional finite elements)"
    );

    argList::addOption
    (
        "modes",
        "n",
        "Only find the n lowest frequencies and write the modes as VTK"
    );
    argList::addOption
    (
        "shift",
        "s",
        "With -modes: negative [1/s2] for a shell that can move freely"
    );

    #include "setRootCase.H"
    #include "createTime.H"

    shellModel shell(runTime);
    shell.describe(Info);

    if (args.found("modes"))
    {
        shell.writeModes
        (
            args.get<label>("modes"),
            args.lookupOrDefault<scalar>("shift", 0),
            Info
        );
        Info<< "End" << nl << endl;

        return 0;
    }

    while (runTime.loop())
    {
        Info<< "Time = " << runTime.timeName() << nl;

        shell.advance(runTime.deltaTValue());
        shell.reportStep(Info);

        runTime.write();
        runTime.printExecutionTime(Info);
    }

    shell.reportEnd(Info);
    Info<< "End" << nl << endl;

    return 0;
}
