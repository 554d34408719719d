/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "revolution.H"
#include "dictionaryCheck.H"
#include "ListOps.H"
#include "scalarList.H"
#include "unitConversion.H"

namespace Foam
{

static vector unitVector(const dictionary& dict, const word& keyword)
{
    const vector v(dict.get<vector>(keyword));
    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " " << v << " is no direction" << nl
            << exit(FatalIOError);
    }
    return normalised(v);
}


static vector startDirection(const dictionary& dict, const vector& axis)
{
    const vector start(unitVector(dict, "start"));
    const vector normal(start - (start & axis)*axis);
    if (mag(normal) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "start " << start << " is along the axis; it must point from"
            << " the axis to where u = 0 lies" << nl << exit(FatalIOError);
    }
    return normalised(normal);
}


static scalar turn(const dictionary& dict)
{
    const scalar angle = dict.lookupOrDefault<scalar>("angle", 360);
    if (angle <= 0 || angle > 360)
    {
        FatalIOErrorInFunction(dict)
            << "angle " << angle << " must be above 0 and at most 360 degrees"
            << nl << exit(FatalIOError);
    }
    return degToRad(angle);
}

} // End namespace Foam


Foam::shellSurfaces::revolution::revolution
(
    const dictionary& dict,
    const wordList& own
)
:
    origin_(dict.get<vector>("origin")),
    axis_(unitVector(dict, "axis")),
    start_(startDirection(dict, axis_)),
    across_(axis_ ^ start_),
    angle_(turn(dict))
{
    wordList valid({"type", "origin", "axis", "start", "angle"});
    valid.append(own);
    checkKeywords(dict, valid);
}


Foam::scalar Foam::shellSurfaces::revolution::positive
(
    const dictionary& dict,
    const word& keyword
)
{
    const scalar value = dict.get<scalar>(keyword);
    if (value <= 0)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " " << value << " must be positive" << nl
            << exit(FatalIOError);
    }
    return value;
}


Foam::Pair<Foam::scalar> Foam::shellSurfaces::revolution::pair
(
    const dictionary& dict,
    const word& keyword
)
{
    const scalarList values(dict.get<scalarList>(keyword));
    if (values.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " must be two numbers, at v = 0 and v = 1, not "
            << flatOutput(values) << nl << exit(FatalIOError);
    }
    return Pair<scalar>(values[0], values[1]);
}


Foam::vector Foam::shellSurfaces::revolution::turned
(
    const scalar u,
    const scalar r,
    const scalar z
) const
{
    const scalar a = u*angle_;
    return z*axis_ + r*(Foam::cos(a)*start_ + Foam::sin(a)*across_);
}


Foam::vector Foam::shellSurfaces::revolution::position
(
    const scalar u,
    const scalar v
) const
{
    const profilePoint p(profile(v));
    return origin_ + turned(u, p.r, p.z);
}


Foam::vector Foam::shellSurfaces::revolution::normal
(
    const scalar u,
    const scalar v
) const
{
    const profilePoint n(profileNormal(v));

    // On the axis all directions meet: their mean
    return pole(v) ? vector(sign(n.z)*axis_) : turned(u, n.r, n.z);
}


bool Foam::shellSurfaces::revolution::closedU() const
{
    return angle_ > (1 - SMALL)*constant::mathematical::twoPi;
}


bool Foam::shellSurfaces::revolution::pole(const scalar v) const
{
    return profile(v).r == 0;
}
