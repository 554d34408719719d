/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "planarShock.H"
#include "gasDynamics/ShockRelations.hpp"
#include "addToRunTimeSelectionTable.H"
#include "dictionaryCheck.H"

namespace Foam
{
    defineTypeNameAndDebug(planarShock, 0);
    addToRunTimeSelectionTable(initialState, planarShock, dictionary);
}


Foam::planarShock::planarShock(const feMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    machNumber_(positive(dict, "machNumber")),
    point_(dict.get<point>("point")),
    normal_(sceneDirection(mesh, dict, "normal")),
    ahead_(mesh, dict.subDict("ahead"))
{
    checkKeywords(dict, {"machNumber", "point", "normal", "ahead"});
    checkKeywords(dict.subDict("ahead"), {"p", "T", "U"});

    if (machNumber_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "machNumber is " << machNumber_
            << ", but a shock has one of at least 1" << exit(FatalIOError);
    }
}


Foam::scalar Foam::planarShock::tolerance() const
{
    return 1e-9*mesh_.poly().bounds().mag();
}


Foam::gasNodes::State Foam::planarShock::behind
(
    const gasDynamics::PerfectGas& gas
) const
{
    const scalar un = ahead_.U & normal_;
    const gasDynamics::Primitive1D w = gasDynamics::behindShock
    (
        gas, {gas.density(ahead_.p, ahead_.T), un, ahead_.p}, machNumber_
    );
    return conservedState
    (
        gas,
        w.p,
        ahead_.U + (w.u - un)*normal_,
        gas.temperature(w.p, w.rho)
    );
}


template<class Lies>
void Foam::planarShock::checkImages(const feMesh& mesh, const Lies& lies)
{
    for (label c = mesh.nNodes(); c < mesh.nCorners(); ++c)
    {
        const point& x = mesh.nodes()[mesh.nodeOfCorner(c)];
        if (lies(x) != lies(mesh.corners()[c]))
        {
            FatalErrorInFunction
                << "The shock makes the two sides of a cyclic patch differ at "
                << x << " and " << mesh.corners()[c] << nl
                << "    Use a normal along the cyclic patch, or other patches"
                << exit(FatalError);
        }
    }
}


void Foam::planarShock::set(gasNodes& nodes) const
{
    const gasDynamics::PerfectGas& gas = nodes.gas();
    const gasNodes::State b = behind(gas);
    const scalar p = gasDynamics::pressure<3>(gas, b);
    const scalar T = gas.temperature(p, b[0]);
    const vector U(b[1]/b[0], b[2]/b[0], b[3]/b[0]);
    const scalar cAhead =
        gas.soundSpeed(ahead_.p, gas.density(ahead_.p, ahead_.T));

    auto lies = [&](const point& x)
    {
        return ((x - point_) & normal_) <= tolerance();
    };
    checkImages(nodes.mesh(), lies);

    boolList isBehind(nodes.size(), false);
    boolList differs(nodes.size(), false);
    for (label i = 0; i < nodes.size(); ++i)
    {
        isBehind[i] = lies(nodes.x(i));
        if (isBehind[i])
        {
            nodes.set(i, p, U, T);
        }
        else
        {
            differs[i] =
                mag(nodes.p()[i] - ahead_.p) > 1e-6*ahead_.p
             || mag(nodes.T()[i] - ahead_.T) > 1e-6*ahead_.T
             || mag(nodes.U()[i] - ahead_.U) > 1e-6*cAhead;
        }
    }

    Info<< "    ahead : p = " << ahead_.p << " Pa, T = " << ahead_.T
        << " K, rho = " << gas.density(ahead_.p, ahead_.T) << " kg/m3, U = "
        << ahead_.U << " m/s" << nl
        << "    behind: p = " << p << " Pa, T = " << T << " K, rho = " << b[0]
        << " kg/m3, U = " << U << " m/s" << nl
        << "    speed of the shock "
        << (ahead_.U & normal_) + machNumber_*cAhead << " m/s, "
        << nodes.count(isBehind) << " nodes behind it" << endl;

    const label n = nodes.count(differs);
    if (n)
    {
        Info<< "    " << n << " nodes in front of it have another state than "
            << "the one ahead" << endl;
    }
}
