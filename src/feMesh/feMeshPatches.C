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

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        DynamicList<label> facets(dim_*pp.size());
        DynamicList<label> behind(pp.size());
        DynamicList<label> opposite(pp.size());
        labelHashSet nodes(2*pp.nPoints());

        forAll(pp, i)
        {
            const labelHashSet onFace(faceNodes(pp.start() + i));
            nodes |= onFace;
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
                    if (!onFace.found(simplices_[stride*s + a]))
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
                nodes.sortedToc()
            }
        );
    }

    patches_.transfer(patches);
}
