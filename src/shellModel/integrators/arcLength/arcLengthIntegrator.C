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
    staticIntegrator(model)
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
    return finished
    (
        solver_->step(start, dt, loads, memory, given.end), loads, given
    );
}


void Foam::shellIntegrators::arcLength::reset()
{
    solver_.reset(new positionalShell::ArcLength(model(), options_));
}
