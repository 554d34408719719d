/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "twoWay.H"

Foam::twoWay::twoWay
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    shellCoupling(time, mesh, gas, std::move(shell), dict),
    mover_(mesh),
    initialNodes_(gas.mesh().gather(mover_.points0())),
    motion_(gas.mesh().nNodes()),
    nShellSteps_(0)
{
    Info<< "Coupling: twoWay, " << subCycles_
        << " gas step(s) per shell step" << endl;
    findMap
    (
        nodes_.gather(initialNodes_),
        dict.getOrDefault<scalar>("mapTolerance", 0.01)
    );

    vectorField displacement, velocity;
    moveWithShell(time_.deltaTValue(), displacement, velocity);
    motion_.reset(displacement, velocity);
}


void Foam::twoWay::moveWithShell
(
    const scalar duration,
    vectorField& displacement,
    vectorField& velocity
)
{
    const feMesh& mesh = gas_.mesh();
    const positionalShell::ShellState& state = shell_->state();

    // Displacement last: the motion solver's field then shows it
    velocity = mesh.gather
    (
        mover_.displacement
        (
            mesh, nodes_, duration*map_->velocity(state.velocity)
        )
    );
    velocity /= duration;
    endDisplacement_ = mover_.displacement
    (
        mesh, nodes_, map_->displacement(state.position)
    );
    displacement = mesh.gather(endDisplacement_);
}


void Foam::twoWay::advance()
{
    const scalar duration = time_.deltaTValue();
    const pointField lastDisplacement(endDisplacement_);
    shell_->storeOldState();
    advanceShell(duration);
    ++nShellSteps_;
    {
        phaseTimes::timer timer(times_, phaseTimes::meshMotion);
        vectorField displacement, velocity;
        moveWithShell(duration, displacement, velocity);
        motion_.advance(duration, displacement, velocity);
        mover_.watch
        (
            gas_.mesh(), initialNodes_, motion_, lastDisplacement,
            [&]()
            {
                shell_->restoreOldState();
                gas_.updateFields();
            }
        );
    }

    subCycle
    (
        duration,
        [&](const scalar, const scalar to, const scalar dt)
        {
            const vectorField forces(nodes_.pressureForces(gas_, pRef_));
            const pointField before(nodes_.gather(gas_.mesh().nodes()));
            gas_.advance(dt, initialNodes_ + motion_.at(to));
            balance_.addGas
            (
                forces,
                nodes_.gather(gas_.mesh().nodes()) - before
            );
        }
    );

    if (willWrite())
    {
        phaseTimes::timer timer(times_, phaseTimes::meshMotion);
        mover_.move(mover_.points0() + endDisplacement_);
    }
}


void Foam::twoWay::reportEnd()
{
    shellCoupling::reportEnd();
    mover_.reportEnd(nShellSteps_);
}
