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

    #include "setRootCase.H"
    #include "createTime.H"

    shellModel shell(runTime);
    shell.describe(Info);

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
