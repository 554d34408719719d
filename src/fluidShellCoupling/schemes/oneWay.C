/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "oneWay.H"

Foam::oneWay::oneWay
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    shellCoupling(time, mesh, gas, std::move(shell), dict)
{
    Info<< "Coupling: oneWay, " << subCycles_
        << " gas step(s) per shell step" << endl;
    findMap
    (
        nodes_.gather(gas_.mesh().nodes()),
        dict.getOrDefault<scalar>("mapTolerance", 0.01)
    );
}


void Foam::oneWay::advance()
{
    const scalar duration = time_.deltaTValue();
    advanceShell(duration);
    subCycle
    (
        duration,
        [&](const scalar, const scalar, const scalar dt)
        {
            gas_.advance(dt);
        }
    );
}
