/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"

namespace Foam
{
namespace shellSurfaces
{
    defineTypeNameAndDebug(sphere, 0);
    addToRunTimeSelectionTable(shellSurface, sphere, dictionary);
}
}


// The cosine of 90 degrees is not 0 in floating point, but the pole is a point
static Foam::scalar cosine(const Foam::scalar latitude)
{
    const Foam::scalar c = Foam::cos(latitude);
    return Foam::mag(c) < Foam::SMALL ? 0 : c;
}


Foam::shellSurfaces::sphere::sphere(const dictionary& dict)
:
    revolution(dict, {"radius", "latitudes"}),
    radius_(positive(dict, "radius")),
    latitudes_(pair(dict, "latitudes"))
{
    if
    (
        latitudes_[0] < -90 || latitudes_[1] > 90
     || latitudes_[0] >= latitudes_[1]
    )
    {
        FatalIOErrorInFunction(dict)
            << "latitudes " << latitudes_ << " must ascend, between -90 and"
            << " 90 degrees" << nl << exit(FatalIOError);
    }
}


Foam::scalar Foam::shellSurfaces::sphere::latitude(const scalar v) const
{
    return degToRad((1 - v)*latitudes_[0] + v*latitudes_[1]);
}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::sphere::profile(const scalar v) const
{
    const scalar a = latitude(v);
    return {radius_*cosine(a), radius_*Foam::sin(a)};
}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::sphere::profileNormal(const scalar v) const
{
    const scalar a = latitude(v);
    return {cosine(a), Foam::sin(a)};
}
