/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "cylinder.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace shellSurfaces
{
    defineTypeNameAndDebug(cylinder, 0);
    addToRunTimeSelectionTable(shellSurface, cylinder, dictionary);
}
}


Foam::shellSurfaces::cylinder::cylinder(const dictionary& dict)
:
    revolution(dict, {"radius", "length"}),
    radius_(positive(dict, "radius")),
    length_(positive(dict, "length"))
{}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::cylinder::profile(const scalar v) const
{
    return {radius_, v*length_};
}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::cylinder::profileNormal(const scalar) const
{
    return {1, 0};
}
