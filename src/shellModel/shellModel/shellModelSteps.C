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
    const std::vector<DynamicStep>& steps,
    const positionalShell::LinearSolverReport& linear,
    const Foam::scalar wallTime
)
{
    Foam::shellStepReport report;
    report.steps = steps.size();
    for (const DynamicStep& step : steps)
    {
        report.iterations += step.report.iterations;
    }
    const auto& first = steps.front().report.history;
    const auto& last = steps.back().report.history;
    if (!first.empty() && !last.empty())
    {
        report.initialResidual = greatest(first.front().residual);
        report.residual = greatest(last.back().residual);
    }
    report.solver = positionalShell::factorisationName(linear.last);
    report.wallTime = wallTime;
    return report;
}


void Foam::shellModel::resetIntegrator()
{
    const positionalShell::LinearSolverReport& linear =
        integrator_->linearReport();
    earlierFactors_.nCholesky += linear.nCholesky;
    earlierFactors_.nLU += linear.nLU;
    earlierFactors_.nIndefinite += linear.nIndefinite;
    integrator_->reset();
    writtenSinceStep_ = false;
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
    const bool ownParameter = integrator_->ownParameter();
    const word timeName
    (
        Time::timeName
        (
            ownParameter
          ? runTime_.value() - runTime_.deltaTValue()
          : t
        )
    );

    // The start of a run is on disk or is the state of rest
    string lastGood("the start of this run");
    if (nSteps_ > 0)
    {
        writeState(timeName);
        lastGood = "written to " + timeName + "/shell";
    }

    FatalErrorInFunction
        << "The shell's step from "
        << (ownParameter ? "load parameter " : "time ") << t
        << (ownParameter ? " (first increment " : " to ")
        << (ownParameter ? dt : t + dt)
        << (ownParameter ? ")" : "") << " failed:" << nl
        << problem.c_str() << nl
        << "    The last good state is " << lastGood.c_str() << nl
        << "    Reduce deltaT in system/controlDict"
        << (dynamic_ ? "" : " (the load step)")
        << ", or allow more cuts of a step (maxCuts in newton of "
        << properties_.objectPath()
        << "); if the residual was still falling, raise maxIterations there"
        << nl
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


positionalShell::Vector Foam::shellModel::givenForce() const
{
    return
        now_.externalForce
      - totalForce(loads_, *model_, now_.state.position, now_.state.time);
}


std::vector<DynamicStep> Foam::shellModel::integrate
(
    const scalar dt,
    const positionalShell::Vector& force
)
{
    try
    {
        const untrappedFpe untrapped;
        const positionalShell::Vector atStart(givenForce());
        return integrator_->advance
        (
            now_.state, dt, loads_, {&atStart, &force}, now_.memory
        );
    }
    catch (const positionalShell::SingularMatrix& problem)
    {
        stopAfterStep(dt, problem.what());
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
        resetIntegrator();
    }

    const clockTime timer;
    const std::vector<DynamicStep> steps(integrate(dt, force));
    if (!steps.back().converged)
    {
        stopAfterStep(dt, steps.back().report.describe());
    }

    for (const DynamicStep& step : steps)
    {
        now_.account->add(step);
    }
    now_.state = steps.back().state;
    now_.externalForce = steps.back().externalForce;
    now_.report = summary
    (
        steps, integrator_->linearReport(), timer.elapsedTime()
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
