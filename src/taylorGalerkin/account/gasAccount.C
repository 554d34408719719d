/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasAccount.H"
#include "PstreamReduceOps.H"
#include "ops.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(gasAccount, 0);
}

namespace
{

void addTo(Foam::scalarList& sums, const Foam::gasTotals& more)
{
    const Foam::scalarList values(Foam::gasAccount::amounts(more));
    forAll(sums, i)
    {
        sums[i] += values[i];
    }
}

Foam::scalarList ofAll(Foam::scalarList sums)
{
    for (Foam::scalar& sum : sums)
    {
        Foam::reduce(sum, Foam::sumOp<Foam::scalar>());
    }
    return sums;
}

} // End namespace


Foam::scalarList Foam::gasAccount::amounts(const gasTotals& totals)
{
    const vector& m = totals.momentum;
    return scalarList({totals.mass, m.x(), m.y(), m.z(), totals.energy});
}


Foam::gasAccount::gasAccount(const polyMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            typeName, mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE
        )
    ),
    gas_(nullptr)
{
    now_.sources = scalarList(nAmounts, Zero);
    now_.held = now_.sources;
}


void Foam::gasAccount::open(const taylorGalerkinGas& gas)
{
    gas_ = &gas;
    for (const fePatch& patch : gas.mesh().patches())
    {
        patches_.append(patch.name);
    }
    if (opening_.empty())
    {
        opening_ = totals();
    }
    if (now_.entered.size() != patches_.size())
    {
        now_.entered = List<scalarList>
        (
            patches_.size(), scalarList(nAmounts, Zero)
        );
    }
    old_ = now_;
}


void Foam::gasAccount::continueFrom
(
    const scalarList& opening,
    const List<scalarList>& entered,
    const scalarList& sources,
    const scalarList& held
)
{
    opening_ = opening;
    if (Pstream::master())
    {
        now_.entered = entered;
        now_.sources = sources;
        now_.held = held;
    }
}


void Foam::gasAccount::enter(const label patchi, const gasTotals& more)
{
    addTo(now_.entered[patchi], more);
}


void Foam::gasAccount::addSource(const gasTotals& more)
{
    addTo(now_.sources, more);
}


void Foam::gasAccount::hold(const gasTotals& more)
{
    addTo(now_.held, more);
}


Foam::scalarList Foam::gasAccount::entered(const label patchi) const
{
    return ofAll(now_.entered[patchi]);
}


Foam::scalarList Foam::gasAccount::sources() const
{
    return ofAll(now_.sources);
}


Foam::scalarList Foam::gasAccount::held() const
{
    return ofAll(now_.held);
}
