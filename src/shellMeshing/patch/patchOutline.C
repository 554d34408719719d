/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "patchOutline.H"
#include "polyBoundaryMesh.H"
#include "polyMesh.H"
#include "unitConversion.H"

namespace Foam
{

//- Places in a closed loop of points where it turns by more than the angle
static labelList cornersOf
(
    const labelList& loop,
    const pointField& points,
    const scalar leastCosine
)
{
    DynamicList<label> corners;
    forAll(loop, i)
    {
        const point& here = points[loop[i]];
        const vector before(here - points[loop[loop.rcIndex(i)]]);
        const vector after(points[loop[loop.fcIndex(i)]] - here);
        if ((before & after) < leastCosine*mag(before)*mag(after))
        {
            corners.append(i);
        }
    }
    return labelList(std::move(corners));
}


//- The edges of a loop from one place to another, round its end
static edgeList piece
(
    const labelList& loop,
    const label from,
    const label to
)
{
    DynamicList<edge> edges;
    label i = from;
    do
    {
        const label next = loop.fcIndex(i);
        edges.append(edge(loop[i], loop[next]));
        i = next;
    } while (i != to);
    return edgeList(std::move(edges));
}


//- Names of the other patches that have a mesh edge
static wordHashSet othersAt(const polyPatch& patch, const label meshEdge)
{
    const polyBoundaryMesh& patches = patch.boundaryMesh();
    const polyMesh& mesh = patches.mesh();

    wordHashSet names;
    for (const label face : mesh.edgeFaces()[meshEdge])
    {
        if (!mesh.isInternalFace(face))
        {
            const label other = patches.whichPatch(face);
            if (other != patch.index())
            {
                names.insert(patches[other].name());
            }
        }
    }
    return names;
}

} // End namespace Foam


Foam::patchOutline::patchOutline
(
    const polyPatch& patch,
    const scalar featureAngle
)
{
    const scalar leastCosine = Foam::cos(degToRad(featureAngle));

    DynamicList<edgeList> found;
    for (const labelList& loop : patch.edgeLoops())
    {
        const labelList places
        (
            cornersOf(loop, patch.localPoints(), leastCosine)
        );
        if (places.empty())
        {
            found.append(piece(loop, 0, 0));
        }
        forAll(places, i)
        {
            corners.append(loop[places[i]]);
            found.append
            (
                piece(loop, places[i], places[places.fcIndex(i)])
            );
        }
    }
    pieces.transfer(found);

    HashTable<DynamicList<edge>> shared;
    DynamicList<edge> all;
    for (label i = patch.nInternalEdges(); i < patch.nEdges(); ++i)
    {
        all.append(patch.edges()[i]);
        for (const word& name : othersAt(patch, patch.meshEdges()[i]))
        {
            shared(name).append(patch.edges()[i]);
        }
    }
    boundary.transfer(all);
    forAllConstIters(shared, iter)
    {
        neighbours.insert(iter.key(), edgeList(iter.val()));
    }
}
