/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "generalisedAlphaIntegrator.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(generalisedAlpha, 0);
    addToRunTimeSelectionTable(shellIntegrator, generalisedAlpha, dictionary);
}
}


Foam::shellIntegrators::generalisedAlpha::generalisedAlpha
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    dynamicIntegrator(shellProperties),
    model_(model)
{
    const dictionary coeffs(coeffsDict(shellProperties, "generalisedAlpha"));
    checkKeywords(coeffs, {"spectralRadius"});
    coeffs.readIfPresent("spectralRadius", options_.spectralRadius);
    readOptions(shellProperties, options_);
    start(shellProperties);
}


std::unique_ptr<positionalShell::TimeIntegrator>
Foam::shellIntegrators::generalisedAlpha::make() const
{
    return std::unique_ptr<positionalShell::TimeIntegrator>
    (
        new positionalShell::GeneralisedAlpha(model_, options_)
    );
}
