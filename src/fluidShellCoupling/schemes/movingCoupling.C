/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "movingCoupling.H"

Foam::movingCoupling::movingCoupling
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
    findMap
    (
        initialNodes_,
        dict.getOrDefault<scalar>("mapTolerance", 0.01)
    );
}


void Foam::movingCoupling::solveMotion
(
    const scalar duration,
    const vectorField& interfaceDisplacement,
    const vectorField& interfaceVelocity,
    vectorField& displacement,
    vectorField& velocity
)
{
    phaseTimes::timer timer(times_, phaseTimes::meshMotion);
    const feMesh& mesh = gas_.mesh();

    // Displacement last: the motion solver's field then shows it
    velocity = mesh.gather
    (
        mover_.displacement(mesh, nodes_, duration*interfaceVelocity)
    );
    velocity /= duration;
    endDisplacement_ =
        mover_.displacement(mesh, nodes_, interfaceDisplacement);
    displacement = mesh.gather(endDisplacement_);
    gas_.expectMotion(displacement);
    gas_.expectMotion(velocity);
}


void Foam::movingCoupling::solveMotion
(
    const scalar duration,
    vectorField& displacement,
    vectorField& velocity
)
{
    const positionalShell::ShellState& state = shell_->state();
    solveMotion
    (
        duration,
        map_->displacement(state.position), map_->velocity(state.velocity),
        displacement, velocity
    );
}


void Foam::movingCoupling::advanceMovingGas
(
    const scalar duration,
    const bool meanOfEnds
)
{
    advanceGas
    (
        duration, meanOfEnds,
        [&](const scalar to, const scalar dt)
        {
            gas_.advance(dt, motion_.at(initialNodes_, to)());
        }
    );
}


void Foam::movingCoupling::resetMotion
(
    const vectorField& displacement,
    const vectorField& velocity
)
{
    motion_.reset(displacement, velocity);
    lastDisplacement_ = endDisplacement_;
}


void Foam::movingCoupling::watchMotion(const std::function<void()>& goBack)
{
    phaseTimes::timer timer(times_, phaseTimes::meshMotion);
    mover_.watch
    (
        gas_.mesh(), initialNodes_, motion_, lastDisplacement_,
        [&]()
        {
            goBack();
            gas_.updateFields();
        }
    );
}


void Foam::movingCoupling::moveMesh()
{
    ++nShellSteps_;
    lastDisplacement_ = endDisplacement_;
    if (willWrite())
    {
        phaseTimes::timer timer(times_, phaseTimes::meshMotion);
        mover_.move(mover_.points0() + endDisplacement_);
    }
}


void Foam::movingCoupling::reportEnd()
{
    shellCoupling::reportEnd();
    mover_.reportEnd(nShellSteps_);
}
