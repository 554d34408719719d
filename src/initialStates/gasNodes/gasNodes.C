/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasNodes.H"
#include "nodeVolumes.H"
#include "PstreamReduceOps.H"

namespace
{

Foam::gasNodes::State sumOfProcessors(Foam::gasNodes::State sum)
{
    for (int i = 0; i < sum.size(); ++i)
    {
        Foam::scalar part = sum[i];
        Foam::reduce(part, Foam::sumOp<Foam::scalar>());
        sum[i] = part;
    }
    return sum;
}

} // End namespace


Foam::gasNodes::State Foam::conservedState
(
    const gasDynamics::PerfectGas& gas,
    const scalar p,
    const vector& U,
    const scalar T
)
{
    return gasDynamics::conserved<3>
    (
        gas, gas.density(p, T), {U.x(), U.y(), U.z()}, p
    );
}


Foam::gasNodes::gasNodes
(
    const feMesh& mesh,
    const gasDynamics::PerfectGas& gas,
    const scalarField& p,
    const vectorField& U,
    const scalarField& T
)
:
    mesh_(mesh),
    gas_(gas),
    p_(p),
    U_(U),
    T_(T),
    volumePart_(nodeVolumes(mesh)),
    volume_(volumePart_)
{
    sumCopies(mesh_, volume_);

    if
    (
        p_.size() != mesh.nNodes()
     || U_.size() != mesh.nNodes()
     || T_.size() != mesh.nNodes()
    )
    {
        FatalErrorInFunction
            << "The mesh has " << mesh.nNodes() << " nodes, but p, U and T "
            << "have " << p_.size() << ", " << U_.size() << " and "
            << T_.size() << " values" << abort(FatalError);
    }

    forAll(p_, i)
    {
        if (!(p_[i] > 0) || !(T_[i] > 0))
        {
            FatalErrorInFunction
                << "The gas at " << x(i) << " has p = " << p_[i]
                << " Pa and T = " << T_[i] << " K before any state is set: "
                << "both must be positive" << nl
                << "    Set them in the files p and T, or with "
                << "defaultFieldValues and regions" << exit(FatalError);
        }
    }
}


Foam::gasNodes::State Foam::gasNodes::state(const label nodei) const
{
    return conservedState(gas_, p_[nodei], U_[nodei], T_[nodei]);
}


void Foam::gasNodes::set(const label nodei, const State& s)
{
    const scalar p = gasDynamics::pressure<3>(gas_, s);
    if (!gasDynamics::isPhysical<3>(gas_, s))
    {
        FatalErrorInFunction
            << "The initial state at " << x(nodei) << " would not be "
            << "physical: density " << s[0] << " kg/m3, pressure " << p
            << " Pa" << nl << "    Refine the mesh there" << exit(FatalError);
    }
    const auto U = gasDynamics::velocity<3>(s);
    set
    (
        nodei, p, vector(U[0], U[1], U[2]), gas_.temperature(p, s[0])
    );
}


void Foam::gasNodes::set
(
    const label nodei,
    const scalar p,
    const vector& U,
    const scalar T
)
{
    p_[nodei] = p;
    U_[nodei] = U;
    T_[nodei] = T;
}


Foam::scalar Foam::gasNodes::integral(const scalarField& nodeValues) const
{
    scalar sum = 0;
    forAll(nodeValues, i)
    {
        sum += volumePart_[i]*nodeValues[i];
    }
    return returnReduce(sum, sumOp<scalar>());
}


Foam::gasNodes::State Foam::gasNodes::integral
(
    const List<State>& states,
    const scalarField& weights
) const
{
    State sum = State::Zero();
    forAll(states, i)
    {
        sum += volumePart_[i]*weights[i]*states[i];
    }
    return sumOfProcessors(sum);
}


Foam::gasNodes::State Foam::gasNodes::total() const
{
    State sum = State::Zero();
    for (label i = 0; i < size(); ++i)
    {
        sum += volumePart_[i]*state(i);
    }
    return sumOfProcessors(sum);
}


Foam::label Foam::gasNodes::count(const boolList& chosen) const
{
    scalarField copies(size(), 1.0);
    sumCopies(mesh_, copies);
    scalar n = 0;
    forAll(chosen, i)
    {
        n += (chosen[i] ? 1/copies[i] : 0);
    }
    return label(std::round(returnReduce(n, sumOp<scalar>())));
}
