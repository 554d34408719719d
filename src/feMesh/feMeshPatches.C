/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "emptyPolyPatch.H"
#include "HashSet.H"

#include <algorithm>

namespace
{

//- Whether all of the facet is in the simplex
bool holds
(
    const Foam::label* simplex,
    const Foam::label stride,
    const Foam::labelUList& facet
)
{
    return std::all_of
    (
        facet.begin(), facet.end(), [&](const Foam::label corneri)
        {
            return
                std::find(simplex, simplex + stride, corneri)
             != simplex + stride;
        }
    );
}

} // End namespace


void Foam::feMesh::findPatches()
{
    const label stride = dim_ + 1;

    // First simplex of each cell: simplices are stored cell by cell
    labelList firstSimplex(mesh_.nCells() + 1, nSimplices());
    for (label s = nSimplices() - 1; s >= 0; --s)
    {
        firstSimplex[cellOfSimplex_[s]] = s;
    }

    DynamicList<fePatch> patches;
    labelList onPatch(nNodes());

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp) || pp.coupled())
        {
            continue;
        }

        DynamicList<label> facets(dim_*pp.size());
        DynamicList<label> behind(pp.size());
        DynamicList<label> opposite(pp.size());
        labelHashSet nodes(2*pp.nPoints());

        forAll(pp, i)
        {
            const label celli = pp.faceCells()[i];
            const labelList corners(faceFacets(pp.start() + i));
            for (label k = 0; k < corners.size(); k += dim_)
            {
                const SubList<label> facet(corners, dim_, k);
                label s = firstSimplex[celli];
                while (!holds(&simplexCorners()[stride*s], stride, facet))
                {
                    ++s;
                }
                behind.append(s);
                for (label a = 0; a < stride; ++a)
                {
                    const label corneri = simplexCorners()[stride*s + a];
                    if (!facet.found(corneri))
                    {
                        opposite.append(a);
                    }
                }
                for (const label corneri : facet)
                {
                    facets.append(nodeOfCorner(corneri));
                    nodes.insert(nodeOfCorner(corneri));
                }
            }
        }

        // Nodes that lie on the patch by faces of other processors only
        onPatch = 0;
        for (const label nodei : nodes)
        {
            onPatch[nodei] = 1;
        }
        exchange_.max(onPatch);
        DynamicList<label> remote;
        for (const label nodei : exchange_.shared())
        {
            if (onPatch[nodei] && !nodes.found(nodei))
            {
                remote.append(nodei);
            }
        }

        patches.append
        (
            fePatch
            {
                pp.name(),
                pp.type(),
                pp.index(),
                labelList(facets),
                labelList(behind),
                labelList(opposite),
                nodes.sortedToc(),
                labelList(remote)
            }
        );
    }

    patches_.transfer(patches);
    faceFans_.clear();
}
