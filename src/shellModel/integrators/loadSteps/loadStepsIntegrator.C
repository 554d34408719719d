/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "loadStepsIntegrator.H"
#include "addToRunTimeSelectionTable.H"
#include "newtonControls.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(loadSteps, 0);
    addToRunTimeSelectionTable(shellIntegrator, loadSteps, dictionary);
}
}


Foam::shellIntegrators::loadSteps::loadSteps
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    staticIntegrator(model),
    options_
    (
        readNewtonControls(shellProperties, positionalShell::NewtonOptions()),
        readMaxCuts(shellProperties)
    )
{
    reset();
}


std::vector<positionalShell::DynamicStep>
Foam::shellIntegrators::loadSteps::advance
(
    const positionalShell::ShellState& start,
    const scalar dt,
    const positionalShell::Loads& loads,
    const positionalShell::GivenForce& given,
    positionalShell::Vector&
)
{
    return finished
    (
        solver_->step(start, start.time + dt, loads, given.end), loads, given
    );
}


void Foam::shellIntegrators::loadSteps::reset()
{
    solver_.reset(new positionalShell::StaticSolver(model(), options_));
}
