/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellVector.H"

using positionalShell::fullIndex;

Foam::tmp<Foam::vectorField> Foam::nodeVectors
(
    const positionalShell::Vector& full,
    const positionalShell::Component first
)
{
    auto tvalues =
        tmp<vectorField>::New(label(full.size()/positionalShell::dofsPerNode));
    vectorField& values = tvalues.ref();

    forAll(values, nodei)
    {
        values[nodei] =
            toFoam(full.segment<3>(fullIndex(nodei, first)));
    }
    return tvalues;
}


void Foam::setNodeVectors
(
    const UList<vector>& values,
    const positionalShell::Component first,
    positionalShell::Vector& full
)
{
    forAll(values, nodei)
    {
        full.segment<3>(fullIndex(nodei, first)) = toShell(values[nodei]);
    }
}


Foam::tmp<Foam::scalarField> Foam::nodeScalars
(
    const positionalShell::Vector& full,
    const positionalShell::Component component
)
{
    auto tvalues =
        tmp<scalarField>::New(label(full.size()/positionalShell::dofsPerNode));
    scalarField& values = tvalues.ref();

    forAll(values, nodei)
    {
        values[nodei] = full[fullIndex(nodei, component)];
    }
    return tvalues;
}


void Foam::setNodeScalars
(
    const UList<scalar>& values,
    const positionalShell::Component component,
    positionalShell::Vector& full
)
{
    forAll(values, nodei)
    {
        full[fullIndex(nodei, component)] = values[nodei];
    }
}
