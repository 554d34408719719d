/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "twoWay.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(twoWay, 0);
    addToRunTimeSelectionTable(shellCoupling, twoWay, dictionary);
}


Foam::twoWay::twoWay
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    movingCoupling(time, mesh, gas, std::move(shell), dict)
{
    vectorField displacement, velocity;
    solveMotion(time_.deltaTValue(), displacement, velocity);
    resetMotion(displacement, velocity);
    resume();
}


void Foam::twoWay::advance()
{
    const scalar duration = time_.deltaTValue();
    beginStep(duration);
    advanceShell(duration);

    vectorField displacement, velocity;
    solveMotion(duration, displacement, velocity);
    motion_.advance(duration, displacement, velocity);
    watchMotion([this]() { shell_->restoreOldState(); });

    advanceMovingGas(duration, false);
    balance_.end();
    moveMesh();
}
