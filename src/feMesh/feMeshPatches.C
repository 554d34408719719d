/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "emptyPolyPatch.H"
#include "HashSet.H"

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
            const labelHashSet onFace(faceCorners(pp.start() + i));
            for (const label corneri : onFace)
            {
                nodes.insert(nodeOfCorner(corneri));
            }
            const label celli = pp.faceCells()[i];

            for
            (
                label s = firstSimplex[celli];
                s < nSimplices() && cellOfSimplex_[s] == celli;
                ++s
            )
            {
                // A facet lies on the face when all nodes but one do
                label off = -1;
                label nOff = 0;
                for (label a = 0; a < stride; ++a)
                {
                    if (!onFace.found(simplexCorners()[stride*s + a]))
                    {
                        off = a;
                        ++nOff;
                    }
                }
                if (nOff != 1)
                {
                    continue;
                }
                for (label a = 0; a < stride; ++a)
                {
                    if (a != off)
                    {
                        facets.append(simplices_[stride*s + a]);
                    }
                }
                behind.append(s);
                opposite.append(off);
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
}
