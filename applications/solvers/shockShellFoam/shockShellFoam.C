/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    shockShellFoam

Description
    Shock and blast waves on thin structures: compressible gas by
    Taylor-Galerkin finite elements on moving simplices, shells by the nonlinear
    positional formulation, coupled one-way or two-way with sub-cycling.

    The case declares what is computed: without constant/couplingProperties the
    gas alone, without constant/dynamicMeshDict on a mesh at rest.
*/
#include "argList.H"
#include "Time.H"
#include "fvMesh.H"
#include "taylorGalerkinGas.H"
#include "fluidShellCoupling.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Compressible gas (Taylor-Galerkin finite elements on moving"
        " simplices) and nonlinear positional shells, coupled"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    autoPtr<taylorGalerkinGas> gas = taylorGalerkinGas::New(mesh);

    autoPtr<fluidShellCoupling> coupling =
        fluidShellCoupling::New(runTime, mesh, gas());

    Info<< "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        coupling->setDeltaT();

        ++runTime;
        Info<< "Time = " << runTime.timeName() << nl << endl;

        coupling->advance();
        coupling->report();

        coupling->write();
        runTime.printExecutionTime(Info);
    }

    coupling->reportEnd();

    Info<< nl << "End" << nl << endl;

    return 0;
}
