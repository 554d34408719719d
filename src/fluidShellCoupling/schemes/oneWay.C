/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "oneWay.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(oneWay, 0);
    addToRunTimeSelectionTable(shellCoupling, oneWay, dictionary);
}


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
    findMap
    (
        gas_.mesh().nodes(),
        dict.getOrDefault<scalar>("mapTolerance", 0.01)
    );
    resume();
}


void Foam::oneWay::advance()
{
    const scalar duration = time_.deltaTValue();
    beginStep(duration);
    advanceShell(duration);
    advanceGas
    (
        duration, false,
        [&](const scalar, const scalar dt) { gas_.advance(dt); }
    );
    balance_.end();
}
