/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "mappedProfile.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "mathematicalConstants.H"
#include "stateInput.H"

namespace Foam
{
    defineTypeNameAndDebug(mappedProfile, 0);
    addToRunTimeSelectionTable(initialState, mappedProfile, dictionary);
}

namespace
{

//- Components of a gasNodes::State
const Foam::label mass = 0;
const Foam::label energy = 4;

} // End namespace


Foam::mappedProfile::mappedProfile
(
    const feMesh& mesh,
    const dictionary& dict
)
:
    dict_(dict),
    geometry_
    (
        geometries
        (
            selectEntry
            (
                dict, "geometry", {"planar", "cylindrical", "spherical"}
            )
        )
    ),
    centre_(dict.get<point>("centre")),
    axis_(Zero)
{
    wordList valid({"geometry", "centre", "file", "case", "time"});
    if (geometry_ == planar || (geometry_ == cylindrical && mesh.dim() == 3))
    {
        valid.append("axis");
    }
    if (geometry_ != planar)
    {
        valid.append("radius");
        valid.append("fraction");
    }
    checkKeywords(dict, valid);

    if (dict.found("file") == dict.found("case"))
    {
        FatalIOErrorInFunction(dict)
            << "A profile needs one of the entries file and case"
            << exit(FatalIOError);
    }
    readAxis(mesh);
}


void Foam::mappedProfile::readAxis(const feMesh& mesh)
{
    // The directions of a wedge scene are more than it solves; on a curved line
    // there is only its own geometry
    const label directions = label(geometry_) + 1;
    const label there = mesh.dim() + mesh.curvature();
    if
    (
        there < directions
     || (mesh.curvature() && mesh.dim() == 1 && there != directions)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "geometry " << dict_.get<word>("geometry") << " needs "
            << directions << " directions, but the scene has " << there
            << exit(FatalIOError);
    }
    if (geometry_ == planar)
    {
        axis_ = sceneDirection(mesh, dict_, "axis");
    }
    else if (geometry_ == cylindrical && mesh.dim() == 3)
    {
        axis_ = sceneDirection(mesh, dict_, "axis");
    }
}


Foam::radialProfile Foam::mappedProfile::profile
(
    const gasDynamics::PerfectGas& gas
) const
{
    List<profileRow> rows;
    if (dict_.found("file"))
    {
        fileName file(dict_.get<fileName>("file"));
        rows = readTable(file.expand(), dict_);
    }
    else
    {
        rows = readCase(gas, dict_);
    }
    return radialProfile(gas, rows, geometry_ != planar, dict_);
}


Foam::convexBody Foam::mappedProfile::body
(
    const feMesh& mesh,
    const radialProfile& source
) const
{
    if (geometry_ == planar)
    {
        const scalarMinMax there(extent(mesh, centre_, axis_));
        const scalar start = max(source.start(), there.min());
        const scalar end = min(source.end(), there.max());
        if (!(start < end))
        {
            FatalIOErrorInFunction(dict_)
                << "The profile goes from r = " << source.start() << " to "
                << source.end() << ", the mesh from " << there.min() << " to "
                << there.max() << exit(FatalIOError);
        }
        return convexBody::Slab(centre_, axis_, start, end);
    }

    const scalar radius =
    (
        dict_.found("radius") ? positive(dict_, "radius") : source.end()
    );
    if (radius > source.end()*(1 + SMALL))
    {
        FatalIOErrorInFunction(dict_)
            << "radius is " << radius << ", but the profile ends at r = "
            << source.end() << exit(FatalIOError);
    }
    if (geometry_ == cylindrical && mesh.dim() == 3)
    {
        return convexBody::Cylinder(centre_, axis_, radius);
    }
    if (geometry_ == cylindrical && mesh.curvature() && mesh.dim() == 2)
    {
        vector axis(Zero);
        axis[mesh.axes()[1 - mesh.radial()]] = 1;
        const point centre((centre_ & axis)*axis);
        return convexBody::Cylinder(centre, axis, radius);
    }
    return convexBody::round(mesh, centre_, radius);
}


Foam::gasNodes::State Foam::mappedProfile::gain
(
    const gasNodes& nodes,
    const radialProfile& source,
    const convexBody& region,
    const bodyShare& share
) const
{
    using constant::mathematical::pi;

    const scalar around[] = {1, 2*pi, 4*pi};
    const radialProfile::State content =
        share.part()*share.across()*around[geometry_]
       *source.integral(region.start(), region.end(), geometry_);

    List<gasNodes::State> before(nodes.size());
    forAll(before, i)
    {
        before[i] = nodes.state(i);
    }
    gasNodes::State wanted =
        -share.correction()*nodes.integral(before, share.f());
    wanted[mass] += content[0];
    wanted[energy] += content[2];
    return wanted;
}


Foam::List<Foam::gasNodes::State> Foam::mappedProfile::changes
(
    const gasNodes& nodes,
    const radialProfile& source,
    const convexBody& region,
    const bodyShare& share
) const
{
    List<gasNodes::State> change(nodes.size(), gasNodes::State::Zero());
    forAll(change, i)
    {
        const scalar f = share.f()[i];
        if (f > 0)
        {
            const point& x = nodes.x(i);
            const scalar r =
                max(region.start(), min(region.end(), region.r(x)));
            const radialProfile::State s = source.at(r);
            const vector e(region.along(x));
            gasNodes::State here;
            here << s[0], s[1]*e.x(), s[1]*e.y(), s[1]*e.z(), s[2];
            change[i] = f*(here - nodes.state(i));
        }
    }
    return change;
}


Foam::scalar Foam::mappedProfile::correction
(
    const gasNodes& nodes,
    const scalarField& change,
    const scalarField& weight,
    const scalar wanted,
    const label i
) const
{
    const scalar defect = wanted - nodes.integral(change);
    const scalar whole = nodes.integral(weight);

    // A profile that is the gas already there
    if (mag(defect) <= 1e-13*mag(nodes.total()[i]))
    {
        return 0;
    }
    if (!(mag(defect) <= 0.1*whole))
    {
        FatalIOErrorInFunction(dict_)
            << "On this mesh the profile's "
            << (i == mass ? "mass" : "energy") << " is off by "
            << 100*mag(defect)/max(whole, VSMALL)
            << " % of what it changes, more than 10 %" << nl
            << "    The mesh is too coarse for the profile: refine it within r "
            << "= " << profile(nodes.gas()).end() << ", or map a later time, "
            << "when the waves are longer" << exit(FatalIOError);
    }
    return defect/whole;
}


Foam::List<Foam::gasNodes::State> Foam::mappedProfile::corrected
(
    const gasNodes& nodes,
    const List<gasNodes::State>& changes,
    const gasNodes::State& wanted,
    scalar& cMass,
    scalar& cEnergy
) const
{
    List<gasNodes::State> states(nodes.size());
    scalarField change(nodes.size());
    scalarField weight(nodes.size());

    // Density, (I6); the velocity stays
    forAll(states, i)
    {
        states[i] = nodes.state(i) + changes[i];
        change[i] = changes[i][mass];
        weight[i] = min(mag(change[i]), states[i][mass]);
    }
    cMass = correction(nodes, change, weight, wanted[mass], mass);
    scalarField inner(nodes.size());
    forAll(states, i)
    {
        gasNodes::State& s = states[i];
        const scalar kinetic = 0.5*s.segment<3>(1).squaredNorm()/s[mass];
        inner[i] = s[energy] - kinetic;
        const scalar part = 1 + cMass*weight[i]/s[mass];
        s[mass] *= part;
        s.segment<3>(1) *= part;
        s[energy] = inner[i] + part*kinetic;
    }

    // Internal energy
    forAll(states, i)
    {
        change[i] = states[i][energy] - nodes.state(i)[energy];
        weight[i] = min(mag(change[i]), inner[i]);
    }
    cEnergy = correction(nodes, change, weight, wanted[energy], energy);
    forAll(states, i)
    {
        states[i][energy] += cEnergy*weight[i];
    }
    return states;
}


void Foam::mappedProfile::checkEnd
(
    const gasNodes& nodes,
    const radialProfile& source,
    const convexBody& region,
    const bodyShare& share
) const
{
    scalarField atEnd(nodes.size(), Zero);
    scalarField difference(nodes.size(), Zero);
    forAll(atEnd, i)
    {
        const scalar f = share.f()[i];
        if (f > SMALL && f < 1 - 1e-9)
        {
            const gasNodes::State here = nodes.state(i);
            const bool low = region.shape() == convexBody::slab
             && 2*region.r(nodes.x(i)) < region.start() + region.end();
            const radialProfile::State s =
                source.at(low ? region.start() : region.end());
            const scalar p = gasDynamics::pressure<1>(nodes.gas(), s);
            atEnd[i] = 1;
            difference[i] = max
            (
                mag(p/nodes.p()[i] - 1), mag(s[0]/here[0] - 1)
            );
        }
    }
    const scalar volume = nodes.integral(atEnd);
    const scalar mean = nodes.integral(difference)/max(volume, VSMALL);
    if (mean > 0.01)
    {
        const radialProfile::State s = source.at(region.end());
        WarningInFunction
            << "The profile ends with p = "
            << gasDynamics::pressure<1>(nodes.gas(), s) << " Pa, rho = "
            << s[0] << " kg/m3: " << 100*mean << " % off the gas around it in "
            << "the mean" << nl << "    Check its units, the radius and the "
            << "values of p and T around" << endl;
    }
}


void Foam::mappedProfile::set(gasNodes& nodes) const
{
    const radialProfile source(profile(nodes.gas()));
    const convexBody region(body(nodes.mesh(), source));
    const bodyShare share(nodes, region, dict_);
    checkEnd(nodes, source, region, share);

    const gasNodes::State wanted = gain(nodes, source, region, share);
    const List<gasNodes::State> change =
        changes(nodes, source, region, share);
    scalar cMass = 0;
    scalar cEnergy = 0;
    const List<gasNodes::State> states =
        corrected(nodes, change, wanted, cMass, cEnergy);
    const gasNodes::State before = nodes.total();

    forAll(states, i)
    {
        if (share.f()[i] > 0)
        {
            nodes.set(i, states[i]);
        }
    }

    const gasNodes::State after = nodes.total();
    Info<< "    profile from r = " << region.start() << " to " << region.end()
        << " m" << endl;
    share.print(region);
    Info<< "    correction of what it changes: mass " << 100*cMass
        << " %, energy " << 100*cEnergy << " %" << nl
        << "    scene: mass " << before[mass] << " -> " << after[mass]
        << " kg, energy " << before[energy] << " -> " << after[energy]
        << " J" << endl;
}
