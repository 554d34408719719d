/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "tntCharge.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"
#include "stateInput.H"

namespace
{

// source: Baker, Cox, Westine, Kulesz, Strehlow, Explosion Hazards and
// Evaluation, Elsevier 1983, table of TNT equivalence: 4520 kJ/kg, 1.60 Mg/m3
const Foam::scalar tntEnergy = 4.52e6;
const Foam::scalar tntDensity = 1600;

//- The shock must have gathered this many times the charge's mass of air,
//  (I9), and be this many radii of the bulb away
const Foam::scalar gatheredMasses = 10;
const Foam::scalar bulbRadii = 5;


//- The entry when it is there, positive
Foam::scalar positiveOr
(
    const Foam::dictionary& dict,
    const Foam::word& keyword,
    const Foam::scalar value
)
{
    return dict.found(keyword) ? Foam::positive(dict, keyword) : value;
}

} // End namespace


Foam::tntCharge::tntCharge(const feMesh& mesh, const dictionary& dict)
:
    dict_(dict),
    mass_(0),
    specificEnergy_(positiveOr(dict, "specificEnergy", tntEnergy)),
    radius_(0)
{
    checkKeywords(dict, {"mass", "specificEnergy", "density", "radius"});
    mass_ = positive(dict, "mass");
    if (dict.found("density") && dict.found("radius"))
    {
        FatalIOErrorInFunction(dict)
            << "A charge of TNT takes one of the entries radius and density"
            << exit(FatalIOError);
    }
    const label directions = mesh.dim() + mesh.curvature();
    if (directions != 3)
    {
        FatalIOErrorInFunction(dict)
            << "A charge of TNT is a ball, but the scene has " << directions
            << " direction(s)" << nl << "    Use a mesh in space, a wedge "
            << "with an axis or a spherical line; or give sphericalCharge "
            << "mass, energy and radius" << exit(FatalIOError);
    }
    if (dict.found("radius"))
    {
        radius_ = positive(dict, "radius");
    }
    else
    {
        const scalar density = positiveOr(dict, "density", tntDensity);
        radius_ = cbrt(3*mass_/(4*constant::mathematical::pi*density));
    }
}


Foam::scalar Foam::tntCharge::volume() const
{
    return 4*constant::mathematical::pi/3*pow3(radius_);
}


void Foam::tntCharge::check(const scalar ambientDensity) const
{
    if (mass_ > ambientDensity*volume())
    {
        return;
    }
    FatalIOErrorInFunction(dict_)
        << "A bulb of radius " << radius_ << " m displaces "
        << ambientDensity*volume() << " kg of gas, not less than the charge's "
        << mass_ << " kg" << nl << "    Give a smaller radius: that of the "
        << "charge itself is "
        << cbrt(3*mass_/(4*constant::mathematical::pi*tntDensity)) << " m"
        << exit(FatalIOError);
}


Foam::scalar Foam::tntCharge::leastScaledDistance
(
    const scalar ambientDensity
) const
{
    // (I9)
    const scalar gathered =
        gatheredMasses*3/(4*constant::mathematical::pi*ambientDensity);
    return max(cbrt(gathered), bulbRadii*radius_/cbrt(mass_));
}


void Foam::tntCharge::print(const scalar ambientDensity) const
{
    const scalar Z = leastScaledDistance(ambientDensity);
    Info<< "    TNT: " << mass_ << " kg of " << specificEnergy_
        << " J/kg, density " << mass_/volume() << " kg/m3" << nl
        << "    near field: results are not to be trusted below the scaled "
        << "distance " << Z << " m/kg^(1/3), " << Z*cbrt(mass_)
        << " m from the centre" << endl;
}
