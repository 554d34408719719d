/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellSurface.H"

namespace Foam
{
    defineTypeNameAndDebug(shellSurface, 0);
    defineRunTimeSelectionTable(shellSurface, dictionary);
}


Foam::autoPtr<Foam::shellSurface> Foam::shellSurface::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "surface", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<shellSurface>(cstrIter()(dict));
}
