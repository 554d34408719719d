/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellModel.H"
#include "clockTime.H"
#include "untrappedFpe.H"

#include <algorithm>

using positionalShell::DynamicStep;

static Foam::scalar greatest(const positionalShell::KindNorms& norms)
{
    return std::max({norms.position, norms.director, norms.thickness});
}


static Foam::shellStepReport summary
(
    const DynamicStep& step,
    const positionalShell::LinearSolverReport& linear,
    const Foam::scalar wallTime
)
{
    Foam::shellStepReport report;
    report.iterations = step.report.iterations;
    if (!step.report.history.empty())
    {
        report.initialResidual = greatest(step.report.history.front().residual);
        report.residual = greatest(step.report.history.back().residual);
    }
    report.solver = positionalShell::factorisationName(linear.last);
    report.wallTime = wallTime;
    return report;
}


void Foam::shellModel::checkSize(const positionalShell::Vector& force) const
{
    if (force.size() != nDofs())
    {
        FatalErrorInFunction
            << "Generalised force of size " << label(force.size())
            << "; the shell has " << nDofs() << " unknowns"
            << abort(FatalError);
    }
}


void Foam::shellModel::stopAfterStep
(
    const scalar dt,
    const std::string& problem
) const
{
    const scalar t = now_.state.time;
    const word timeName(Time::timeName(t));

    // The start of a run is on disk or is the state of rest
    string lastGood("the start of this run");
    if (nSteps_ > 0)
    {
        writeState(timeName);
        lastGood = "written to " + timeName + "/shell";
    }

    FatalErrorInFunction
        << "The shell's step from time " << t << " to " << t + dt
        << " failed:" << nl
        << problem.c_str() << nl
        << "    The last good state is " << lastGood.c_str() << nl
        << "    Reduce deltaT in system/controlDict"
        << (dynamic_ ? "" : " (the load step)")
        << "; if the residual was still falling, raise maxIterations in"
        << " newton of " << properties_.objectPath() << nl
        << exit(FatalError);

    std::abort();
}


void Foam::shellModel::initialise(const positionalShell::Vector& force)
{
    if (now_.account)
    {
        return;
    }
    checkSize(force);

    try
    {
        const untrappedFpe untrapped;
        integrator_->initialise(now_.state, loads_, force);
    }
    catch (const std::runtime_error& problem)
    {
        FatalErrorInFunction
            << "The shell has no consistent start at time " << now_.state.time
            << ": " << problem.what() << nl
            << "    Check the loads at this time and the material in "
            << properties_.objectPath() << nl
            << exit(FatalError);
    }

    now_.externalForce =
        force
      + totalForce(loads_, *model_, now_.state.position, now_.state.time);
    startAccount();
    earlier_.initial = now_.account->total();

    if (vtk_)
    {
        vtk_->write(now_.state, runTime_.startTimeIndex());
    }
}


void Foam::shellModel::advance
(
    const scalar dt,
    const positionalShell::Vector& force
)
{
    checkSize(force);
    initialise(force);

    if (writtenSinceStep_)
    {
        integrator_->reset();
        writtenSinceStep_ = false;
    }

    const clockTime timer;
    DynamicStep step;
    try
    {
        const untrappedFpe untrapped;
        step = integrator_->step(now_.state, dt, loads_, force);
    }
    catch (const positionalShell::SingularMatrix& problem)
    {
        stopAfterStep(dt, problem.what());
    }

    if (!step.converged)
    {
        stopAfterStep(dt, step.report.describe());
    }

    now_.account->add(step);
    now_.state = step.state;
    now_.externalForce = step.externalForce;
    now_.report = summary
    (
        step, integrator_->linearReport(), timer.elapsedTime()
    );

    stepTime_ += now_.report.wallTime;
    nIterations_ += now_.report.iterations;
    ++nSteps_;
}


void Foam::shellModel::advance(const scalar dt)
{
    advance(dt, positionalShell::Vector::Zero(nDofs()));
}


void Foam::shellModel::storeOldState()
{
    old_ = now_;
}


void Foam::shellModel::restoreOldState()
{
    now_ = old_;
}


Foam::shellEnergies Foam::shellModel::energies() const
{
    return
        now_.account
      ? shellEnergies::sum(earlier_, *now_.account)
      : shellEnergies();
}
