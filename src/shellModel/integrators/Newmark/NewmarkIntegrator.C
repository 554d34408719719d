/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "NewmarkIntegrator.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "newtonControls.H"
#include "shellInput.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(Newmark, 0);
    addToRunTimeSelectionTable(shellIntegrator, Newmark, dictionary);
}
}


static positionalShell::NewmarkOptions readOptions
(
    const Foam::dictionary& shellProperties
)
{
    using namespace Foam;

    const dictionary coeffs(coeffsDict(shellProperties, "Newmark"));
    checkKeywords(coeffs, {"beta", "gamma"});

    positionalShell::NewmarkOptions options;
    coeffs.readIfPresent("beta", options.beta);
    coeffs.readIfPresent("gamma", options.gamma);
    shellProperties.readIfPresent("massDamping", options.massDamping);
    options.newton = readNewtonControls(shellProperties, options.newton);
    return options;
}


Foam::shellIntegrators::Newmark::Newmark
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    model_(model),
    options_(readOptions(shellProperties))
{
    rejectedIn(shellProperties, [this] { reset(); });
}


void Foam::shellIntegrators::Newmark::initialise
(
    positionalShell::ShellState& state,
    const positionalShell::Loads& loads,
    const positionalShell::Vector& fixedForce
)
{
    method_->initialise(state, loads, &fixedForce);
}


positionalShell::DynamicStep Foam::shellIntegrators::Newmark::step
(
    const positionalShell::ShellState& start,
    const scalar dt,
    const positionalShell::Loads& loads,
    const positionalShell::Vector& fixedForce
)
{
    return method_->step(start, dt, loads, &fixedForce);
}


void Foam::shellIntegrators::Newmark::reset()
{
    method_.reset(new positionalShell::Newmark(model_, options_));
}
