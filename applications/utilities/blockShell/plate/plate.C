/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "plate.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

namespace Foam
{
namespace shellSurfaces
{
    defineTypeNameAndDebug(plate, 0);
    addToRunTimeSelectionTable(shellSurface, plate, dictionary);
}
}


Foam::shellSurfaces::plate::plate(const dictionary& dict)
:
    origin_(dict.get<vector>("origin")),
    sideU_(dict.get<vector>("sideU")),
    sideV_(dict.get<vector>("sideV"))
{
    checkKeywords(dict, {"type", "origin", "sideU", "sideV"});

    if (mag(sideU_ ^ sideV_) <= SMALL*mag(sideU_)*mag(sideV_))
    {
        FatalIOErrorInFunction(dict)
            << "sideU " << sideU_ << " and sideV " << sideV_
            << " do not span an area" << nl << exit(FatalIOError);
    }
}


Foam::vector Foam::shellSurfaces::plate::position
(
    const scalar u,
    const scalar v
) const
{
    return origin_ + u*sideU_ + v*sideV_;
}


Foam::vector Foam::shellSurfaces::plate::normal
(
    const scalar,
    const scalar
) const
{
    return normalised(sideU_ ^ sideV_);
}
