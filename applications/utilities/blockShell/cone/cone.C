/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "cone.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace shellSurfaces
{
    defineTypeNameAndDebug(cone, 0);
    addToRunTimeSelectionTable(shellSurface, cone, dictionary);
}
}


Foam::shellSurfaces::cone::cone(const dictionary& dict)
:
    revolution(dict, {"radii", "height"}),
    radii_(pair(dict, "radii")),
    height_(dict.get<scalar>("height"))
{
    if (min(radii_[0], radii_[1]) < 0 || max(radii_[0], radii_[1]) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "radii " << radii_ << " must not be negative, nor both 0" << nl
            << exit(FatalIOError);
    }
    if (height_ < 0 || (height_ == 0 && radii_[0] == radii_[1]))
    {
        FatalIOErrorInFunction(dict)
            << "height " << height_ << " with radii " << radii_
            << ": the height must be positive, or 0 with different radii"
            << nl << exit(FatalIOError);
    }
}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::cone::profile(const scalar v) const
{
    return {(1 - v)*radii_[0] + v*radii_[1], v*height_};
}


Foam::shellSurfaces::revolution::profilePoint
Foam::shellSurfaces::cone::profileNormal(const scalar) const
{
    const scalar fall = radii_[0] - radii_[1];
    const scalar slant = Foam::sqrt(sqr(height_) + sqr(fall));
    return {height_/slant, fall/slant};
}
