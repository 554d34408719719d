/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "predictedMotion.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(predictedMotion, 0);
    addToRunTimeSelectionTable(shellCoupling, predictedMotion, dictionary);
}


Foam::predictedMotion::predictedMotion
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    movingCoupling(time, mesh, gas, std::move(shell), dict),
    accelerationKnown_(false)
{
    expected_ = shellMotion();
    resume();

    vectorField displacement, velocity;
    solveMotion
    (
        time_.deltaTValue(), expected_.displacement, expected_.velocity,
        displacement, velocity
    );
    resetMotion(displacement, velocity);
}


Foam::predictedMotion::interfaceMotion
Foam::predictedMotion::shellMotion() const
{
    const positionalShell::ShellState& state = shell_->state();
    return interfaceMotion
    {
        vectorField(map_->displacement(state.position)),
        vectorField(map_->velocity(state.velocity))
    };
}


Foam::predictedMotion::interfaceMotion
Foam::predictedMotion::predict(const scalar duration) const
{
    interfaceMotion m(shellMotion());
    m.displacement += duration*m.velocity;
    // The first step has no last one. The shell's own acceleration is no
    // substitute: a load that comes all of a sudden accelerates vibrations
    // that are far faster than the step, (C9)
    if (accelerationKnown_)
    {
        m.displacement += 0.5*sqr(duration)*acceleration_;
        m.velocity += duration*acceleration_;
    }
    return m;
}


positionalShell::Vector Foam::predictedMotion::openStep(const scalar duration)
{
    phaseTimes::timer timer(times_, phaseTimes::transfer);
    beginStep(duration);
    const positionalShell::Vector load = shellLoad(lastForces());
    shell_->initialise(load);
    return load;
}


void Foam::predictedMotion::pass
(
    const scalar duration,
    const positionalShell::Vector& startLoad,
    const bool again
)
{
    vectorField displacement, velocity;
    solveMotion
    (
        duration, expected_.displacement, expected_.velocity,
        displacement, velocity
    );
    if (again)
    {
        motion_.setEnd(displacement, velocity);
    }
    else
    {
        motion_.advance(duration, displacement, velocity);
    }
    // The shell is still where it was
    watchMotion([]() {});
    advanceMovingGas(duration, true);

    positionalShell::Vector load;
    {
        phaseTimes::timer timer(times_, phaseTimes::transfer);
        load = shellLoad(lastForces());
    }
    stepShell(duration, startLoad, load);
}


void Foam::predictedMotion::closeStep
(
    const scalar duration,
    const vectorField& velocity
)
{
    acceleration_ =
        (map_->velocity(shell_->state().velocity) - velocity)/duration;
    accelerationKnown_ = true;
    transfer(lastForces());
    balance_.end();
    moveMesh();
}


void Foam::predictedMotion::advance()
{
    const scalar duration = time_.deltaTValue();
    const positionalShell::Vector startLoad = openStep(duration);
    const interfaceMotion start(shellMotion());

    expected_ = predict(duration);
    pass(duration, startLoad);
    closeStep(duration, start.velocity);
}


void Foam::predictedMotion::writeNodeMemory(Ostream& os) const
{
    movingCoupling::writeNodeMemory(os);
    expected_.displacement.writeEntry("displacement", os);
    expected_.velocity.writeEntry("velocity", os);
    acceleration_.writeEntry("acceleration", os);
}


void Foam::predictedMotion::readNodeMemory(const dictionary& dict)
{
    movingCoupling::readNodeMemory(dict);

    // Absent when another scheme wrote the state: as at a start
    if (dict.found("acceleration"))
    {
        const label n = nodes_.size();
        expected_.displacement = vectorField("displacement", dict, n);
        expected_.velocity = vectorField("velocity", dict, n);
        acceleration_ = vectorField("acceleration", dict, n);
        accelerationKnown_ = true;
    }
}
