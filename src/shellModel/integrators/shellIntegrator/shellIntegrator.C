/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellIntegrator.H"

namespace Foam
{
    defineTypeNameAndDebug(shellIntegrator, 0);
    defineRunTimeSelectionTable(shellIntegrator, dictionary);
}


Foam::autoPtr<Foam::shellIntegrator> Foam::shellIntegrator::New
(
    const word& keyword,
    const word& type,
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            shellProperties,
            keyword,
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<shellIntegrator>(cstrIter()(model, shellProperties));
}
