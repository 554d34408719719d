/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "arcLengthIntegrator.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "newtonControls.H"
#include "shellInput.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(arcLength, 0);
    addToRunTimeSelectionTable(shellIntegrator, arcLength, dictionary);
}
}


Foam::shellIntegrators::arcLength::arcLength
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    model_(model)
{
    const dictionary coeffs(coeffsDict(shellProperties, "arcLength"));
    checkKeywords(coeffs, {"desiredIterations", "maxGrowth"});
    coeffs.readIfPresent("desiredIterations", options_.desiredIterations);
    coeffs.readIfPresent("maxGrowth", options_.maxGrowth);
    options_.newton = readNewtonControls(shellProperties, options_.newton);
    options_.maxCuts = readMaxCuts(shellProperties);
    rejectedIn(shellProperties, [this] { reset(); });
}


std::vector<positionalShell::DynamicStep>
Foam::shellIntegrators::arcLength::advance
(
    const positionalShell::ShellState& start,
    const scalar dt,
    const positionalShell::Loads& loads,
    const positionalShell::GivenForce& given,
    positionalShell::Vector& memory
)
{
    const positionalShell::ArcLengthStep found =
        solver_->step(start, dt, loads, memory, given.end);

    positionalShell::DynamicStep result;
    result.converged = found.converged;
    result.state = found.state;
    result.report = found.report;
    result.externalForce =
        totalForce(loads, model_, found.state.position, found.state.time);
    if (given.end)
    {
        result.externalForce += *given.end;
    }
    return {result};
}


void Foam::shellIntegrators::arcLength::reset()
{
    solver_.reset(new positionalShell::ArcLength(model_, options_));
}
