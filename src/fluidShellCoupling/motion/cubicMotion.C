/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "cubicMotion.H"

Foam::cubicMotion::cubicMotion(const label size)
:
    duration_(1),
    d0_(size, Zero),
    d1_(size, Zero),
    v0_(size, Zero),
    v1_(size, Zero)
{}


void Foam::cubicMotion::reset
(
    const vectorField& displacement,
    const vectorField& velocity
)
{
    d1_ = displacement;
    v1_ = velocity*duration_;
}


void Foam::cubicMotion::advance
(
    const scalar duration,
    const vectorField& displacement,
    const vectorField& velocity
)
{
    d0_.swap(d1_);
    v0_ = v1_*(duration/duration_);
    duration_ = duration;
    setEnd(displacement, velocity);
}


void Foam::cubicMotion::setEnd
(
    const vectorField& displacement,
    const vectorField& velocity
)
{
    d1_ = displacement;
    v1_ = velocity*duration_;
}


Foam::tmp<Foam::pointField> Foam::cubicMotion::at
(
    const pointField& undisplaced,
    const scalar s
) const
{
    // Hermite polynomials; exact at both ends
    if (s >= 1)
    {
        return undisplaced + d1_;
    }
    const scalar h1 = s*s*(3 - 2*s);
    const scalar g0 = s*(1 - s)*(1 - s);
    const scalar g1 = -s*s*(1 - s);
    auto tplaces = tmp<pointField>::New(undisplaced.size());
    pointField& places = tplaces.ref();
    forAll(places, i)
    {
        places[i] =
            undisplaced[i]
          + ((1 - h1)*d0_[i] + h1*d1_[i] + g0*v0_[i] + g1*v1_[i]);
    }
    return tplaces;
}
