/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sphericalCharge.H"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"
#include "stateInput.H"

namespace Foam
{
    defineTypeNameAndDebug(sphericalCharge, 0);
    addToRunTimeSelectionTable(initialState, sphericalCharge, dictionary);
}

namespace
{

//- The edge of the ball is smeared over two spacings: with fewer nodes along
//  the radius that is more than a fifth of it
const Foam::scalar fewNodes = 10;

} // End namespace


Foam::sphericalCharge::sphericalCharge
(
    const feMesh& mesh,
    const dictionary& dict
)
:
    dict_(dict),
    centre_(dict.get<point>("centre")),
    byMass_(dict.found("mass") || dict.found("energy"))
{
    if (dict.found("TNT"))
    {
        checkKeywords(dict, {"centre", "TNT", "fraction"});
        tnt_.reset(new tntCharge(mesh, dict.subDict("TNT")));
        return;
    }
    if (!byMass_)
    {
        checkKeywords(dict, {"centre", "radius", "p", "T", "U", "fraction"});
        gasInput(mesh, dict);
        positive(dict, "radius");
        return;
    }

    checkKeywords
    (
        dict, {"centre", "mass", "energy", "radius", "density", "fraction"}
    );
    positive(dict, "mass");
    positive(dict, "energy");
    if (dict.found("radius") == dict.found("density"))
    {
        FatalIOErrorInFunction(dict)
            << "A charge of given mass and energy needs one of the entries "
            << "radius and density" << exit(FatalIOError);
    }
    positive(dict, dict.found("radius") ? "radius" : "density");
}


Foam::scalar Foam::sphericalCharge::radius(const feMesh& mesh) const
{
    if (tnt_.valid())
    {
        return tnt_->radius();
    }
    if (dict_.found("radius"))
    {
        return positive(dict_, "radius");
    }
    const scalar volume = positive(dict_, "mass")/positive(dict_, "density");
    const convexBody unit(convexBody::round(mesh, centre_, 1));
    const label power[] = {1, 2, 3};
    return Foam::pow
    (
        volume/unit.volume(unit.across(mesh)), 1.0/power[unit.shape()]
    );
}


Foam::gasNodes::State Foam::sphericalCharge::inside
(
    const gasNodes& nodes,
    const bodyShare& share,
    const scalar volume
) const
{
    if (!byMass_ && !tnt_.valid())
    {
        const gasInput in(nodes.mesh(), dict_);
        return conservedState(nodes.gas(), in.p, in.U, in.T);
    }

    gasNodes::State s = gasNodes::State::Zero();
    if (tnt_.valid())
    {
        // (I8); in uniform surroundings p is p0 everywhere
        const scalar held = nodes.integral(share.f());
        const scalar p0 =
            nodes.integral((nodes.p()*share.f())())/held;
        const scalar air = displaced(nodes, share)[0];
        tnt_->check(air);
        tnt_->print(air);
        s[0] = tnt_->mass()/volume;
        s[4] = tnt_->energy()/volume + p0/(nodes.gas().gamma() - 1);
        return s;
    }
    s[0] = positive(dict_, "mass")/volume;
    s[4] = positive(dict_, "energy")/volume;
    return s;
}


Foam::gasNodes::State Foam::sphericalCharge::displaced
(
    const gasNodes& nodes,
    const bodyShare& share
) const
{
    List<gasNodes::State> states(nodes.size());
    forAll(states, i)
    {
        states[i] = nodes.state(i);
    }
    return nodes.integral(states, share.f())/nodes.integral(share.f());
}


void Foam::sphericalCharge::set(gasNodes& nodes) const
{
    const convexBody body
    (
        convexBody::round(nodes.mesh(), centre_, radius(nodes.mesh()))
    );
    const bodyShare share(nodes, body, dict_);
    const gasNodes::State inner =
        inside(nodes, share, body.volume(share.across()));
    const gasNodes::State before = nodes.total();

    // (I4)
    const scalar k = share.correction();
    for (label i = 0; i < nodes.size(); ++i)
    {
        const scalar f = share.f()[i];
        if (f > 0)
        {
            const gasNodes::State s = nodes.state(i);
            nodes.set(i, s + k*f*(inner - s));
        }
    }

    report(nodes, share, body, inner, before);
}


void Foam::sphericalCharge::report
(
    const gasNodes& nodes,
    const bodyShare& share,
    const convexBody& body,
    const gasNodes::State& inside,
    const gasNodes::State& before
) const
{
    const gasDynamics::PerfectGas& gas = nodes.gas();
    const scalar p = gasDynamics::pressure<3>(gas, inside);
    const scalar volume = body.volume(share.across());
    const gasNodes::State after = nodes.total();
    const scalar n = share.nodesPerRadius(nodes, body);

    Info<< "    radius " << body.end() << " m, p = " << p << " Pa, T = "
        << gas.temperature(p, inside[0]) << " K, rho = " << inside[0]
        << " kg/m3" << nl
        << "    whole charge: mass " << inside[0]*volume << " kg, energy "
        << inside[4]*volume << " J" << endl;
    share.print(body);
    Info<< "    correction of what it adds to the gas around it: "
        << 100*(share.correction() - 1) << " %" << nl
        << "    scene: mass " << before[0] << " -> " << after[0]
        << " kg, energy " << before[4] << " -> " << after[4] << " J" << nl
        << "    nodes along the radius: " << n << endl;

    if (n < fewNodes)
    {
        WarningInFunction
            << "The charge has only " << n << " nodes along its radius: mass "
            << "and energy are exact, but its edge is smeared over "
            << 200/n << " % of the radius" << endl;
    }
}
