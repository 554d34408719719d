/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "globalNodes.H"
#include "sharedItems.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "labelIOList.H"
#include "syncTools.H"
#include "bitSet.H"

namespace
{

using namespace Foam;

//- A cyclic that does not shift but turns would couple vectors by a rotation
void checkCoupledPatches(const polyMesh& mesh)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const bool isCyclic =
            isType<cyclicPolyPatch>(pp) || isA<processorCyclicPolyPatch>(pp);

        if (pp.coupled() && !isCyclic && !isA<processorPolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " has type " << pp.type() << nl
                << "    Coupled patches must be of type cyclic (conforming)"
                << exit(FatalError);
        }

        // A cyclic knows its transformation only where it has faces
        if
        (
            isCyclic && pp.size()
         && !refCast<const coupledPolyPatch>(pp).parallel()
        )
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is a rotational cyclic" << nl
                << "    Only cyclics with a translation are available: "
                << "compute the whole circle, a part of it between symmetry "
                << "planes, or an axisymmetric scene" << exit(FatalError);
        }
    }
}


//- Processors can share a point without sharing a face next to it: the keys
//  find those points too
sharedItems sharedPoints(const polyMesh& mesh, const labelUList& undecomposed)
{
    bitSet onBoundary(mesh.nPoints());
    for (label i = mesh.nInternalFaces(); i < mesh.nFaces(); ++i)
    {
        onBoundary.set(mesh.faces()[i]);
    }
    const labelList points(onBoundary.toc());
    List<labelPair> keys(points.size());
    forAll(points, i)
    {
        keys[i] = labelPair(undecomposed[points[i]], undecomposed[points[i]]);
    }
    return sharedItems(mesh.nPoints(), points, keys);
}


//- Smallest label of each station's points, given to all of them
void minOfStations(labelList& labels, const labelUList& station)
{
    forAll(labels, pointi)
    {
        label& smallest = labels[station[pointi]];
        smallest = min(smallest, labels[pointi]);
    }
    forAll(labels, pointi)
    {
        labels[pointi] = labels[station[pointi]];
    }
}

} // End namespace


Foam::labelList Foam::undecomposedLabels(const polyMesh& mesh)
{
    if (!Pstream::parRun())
    {
        return identity(mesh.nPoints());
    }

    IOobject io
    (
        "pointProcAddressing",
        mesh.facesInstance(),
        polyMesh::meshSubDir,
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!io.typeHeaderOk<labelIOList>(true))
    {
        FatalErrorInFunction
            << "There is no file " << io.objectPath() << nl
            << "    A parallel run needs it to recognise nodes on different "
            << "processors: decompose the mesh with decomposePar"
            << exit(FatalError);
    }

    const labelIOList labels(io);
    if (labels.size() != mesh.nPoints())
    {
        FatalErrorInFunction
            << "File " << io.objectPath() << " has " << labels.size()
            << " labels, the mesh has " << mesh.nPoints() << " points" << nl
            << "    Run decomposePar again" << exit(FatalError);
    }
    return labelList(labels);
}


Foam::labelList Foam::globalNodeOfPoints
(
    const polyMesh& mesh,
    const labelUList& undecomposed,
    const labelUList& station
)
{
    checkCoupledPatches(mesh);
    const sharedItems points(sharedPoints(mesh, undecomposed));

    // The smallest label spreads through stations, processors and cyclics
    // until nothing changes
    labelList labels(undecomposed);
    bool changed = true;
    while (changed)
    {
        const labelList before(labels);
        minOfStations(labels, station);
        points.min(labels);
        syncTools::syncPointList(mesh, labels, minEqOp<label>(), labelMax);
        changed = returnReduce(labels != before, orOp<bool>());
    }
    return labels;
}
