/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "NewmarkIntegrator.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(Newmark, 0);
    addToRunTimeSelectionTable(shellIntegrator, Newmark, dictionary);
}
}


Foam::shellIntegrators::Newmark::Newmark
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    dynamicIntegrator(shellProperties),
    model_(model)
{
    const dictionary coeffs(coeffsDict(shellProperties, "Newmark"));
    checkKeywords(coeffs, {"beta", "gamma"});
    coeffs.readIfPresent("beta", options_.beta);
    coeffs.readIfPresent("gamma", options_.gamma);
    readOptions(shellProperties, options_);
    start(shellProperties);
}


std::unique_ptr<positionalShell::TimeIntegrator>
Foam::shellIntegrators::Newmark::make() const
{
    return std::unique_ptr<positionalShell::TimeIntegrator>
    (
        new positionalShell::Newmark(model_, options_)
    );
}
