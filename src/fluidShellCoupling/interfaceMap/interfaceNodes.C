/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "interfaceNodes.H"
#include "HashSet.H"
#include "UIndirectList.H"
#include "ListOps.H"
#include "FlatOutput.H"

Foam::interfaceNodes::interfaceNodes
(
    const feMesh& mesh,
    const dictionary& dict
)
{
    DynamicList<const fePatch*> patches;
    labelHashSet all;
    for (const word& name : dict.get<wordList>("patches"))
    {
        if (!mesh.patchNames().found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown patch " << name << " in patches" << nl
                << "    Valid patches are " << flatOutput(mesh.patchNames())
                << exit(FatalIOError);
        }
        patches.append(&mesh.patch(name));
        all |= labelHashSet(patches.last()->nodes);
    }
    patches_.transfer(patches);
    nodes_ = all.sortedToc();

    // A node's owner may have none of its facets
    labelList here(mesh.nNodes(), Zero);
    UIndirectList<label>(here, nodes_) = 1;
    mesh.exchange().max(here);
    globalSize_ = 0;
    forAll(here, nodei)
    {
        globalSize_ += (here[nodei] && mesh.exchange().owned(nodei) ? 1 : 0);
    }
    reduce(globalSize_, sumOp<label>());

    indexOf_.setSize(patches_.size());
    forAll(patches_, i)
    {
        const labelList& nodes = patches_[i]->nodes;
        indexOf_[i].setSize(nodes.size());
        forAll(nodes, j)
        {
            indexOf_[i][j] = findLower(nodes_, nodes[j] + 1);
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::interfaceNodes::gather
(
    const UList<vector>& nodeValues
) const
{
    auto tvalues = tmp<vectorField>::New(size());
    vectorField& values = tvalues.ref();
    forAll(nodes_, i)
    {
        values[i] = nodeValues[nodes_[i]];
    }
    return tvalues;
}


Foam::tmp<Foam::vectorField> Foam::interfaceNodes::pressureForces
(
    const taylorGalerkinGas& gas,
    const scalar pRef
) const
{
    auto tforces = tmp<vectorField>::New(size(), Zero);
    vectorField& forces = tforces.ref();
    forAll(patches_, i)
    {
        const vectorField patchForces(gas.pressureForces(*patches_[i], pRef));
        forAll(patchForces, j)
        {
            forces[indexOf_[i][j]] += patchForces[j];
        }
    }
    return tforces;
}


Foam::tmp<Foam::vectorField> Foam::interfaceNodes::areas
(
    const taylorGalerkinGas& gas
) const
{
    // Forces are linear in pRef; the difference has the rounding of pressures
    // over 1e5 Pa
    const scalar unit = 1e5;
    return (pressureForces(gas, 0) - pressureForces(gas, unit))/unit;
}
