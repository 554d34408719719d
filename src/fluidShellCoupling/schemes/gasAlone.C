/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasAlone.H"

Foam::gasAlone::gasAlone
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas
)
:
    fluidShellCoupling(time, mesh, gas, 1)
{
    if (meshMover::declared(mesh))
    {
        mover_.reset(new meshMover(mesh));
    }
    Info<< "Coupling: none, gas alone on a mesh "
        << (mover_.valid() ? "in motion" : "at rest") << nl << endl;
}


void Foam::gasAlone::advance()
{
    const scalar duration = time_.deltaTValue();

    if (!mover_.valid())
    {
        subCycle
        (
            duration,
            [&](const scalar, const scalar, const scalar dt)
            {
                gas_.advance(dt);
            }
        );
        return;
    }

    pointField newPoints;
    {
        phaseTimes::timer timer(times_, phaseTimes::meshMotion);
        newPoints = mover_->newPoints();
    }
    const pointField start(gas_.mesh().nodes());
    const pointField end(gas_.mesh().gather(newPoints));
    if (!mover_->accepts(gas_.mesh(), List<pointField>(1, end)))
    {
        gas_.updateFields();
        mover_->stop(mesh_.points());
    }
    gas_.expectMotion(end - start);
    subCycle
    (
        duration,
        [&](const scalar, const scalar to, const scalar dt)
        {
            gas_.advance(dt, (1 - to)*start + to*end);
        }
    );
    phaseTimes::timer timer(times_, phaseTimes::meshMotion);
    mover_->move(newPoints);
}
