/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "initialState.H"

namespace Foam
{
    defineTypeNameAndDebug(initialState, 0);
    defineRunTimeSelectionTable(initialState, dictionary);
}


Foam::autoPtr<Foam::initialState> Foam::initialState::New
(
    const word& type,
    const feMesh& mesh,
    const dictionary& dict
)
{
    const auto found = dictionaryConstructorTablePtr_->cfind(type);
    if (!found.found())
    {
        FatalIOErrorInLookup
        (
            dict, typeName, type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return found.val()(mesh, dict);
}
