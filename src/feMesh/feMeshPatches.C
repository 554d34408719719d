/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "HashSet.H"
#include "UIndirectList.H"

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


bool Foam::feMesh::isAxis(const polyPatch& pp) const
{
    bool away = false;
    for (const label pointi : pp.meshPoints())
    {
        const label nodei = nodeOfPoint_[pointi];
        away = away || nodes_[nodei][radialComponent_] > 0;
    }
    return curvature_ > 0 && !returnReduce(away, orOp<bool>());
}


Foam::fePatch Foam::feMesh::findPatch
(
    const polyPatch& pp,
    const labelUList& firstSimplex
) const
{
    const label stride = dim_ + 1;
    DynamicList<label> facets(dim_*pp.size());
    DynamicList<label> behind(pp.size());
    DynamicList<label> opposite(pp.size());
    labelHashSet nodes(2*pp.nPoints());

    forAll(pp, i)
    {
        const labelList corners(faceFacets(pp.start() + i));
        for (label k = 0; k < corners.size(); k += dim_)
        {
            const SubList<label> facet(corners, dim_, k);
            label s = firstSimplex[pp.faceCells()[i]];
            while (!holds(&simplexCorners()[stride*s], stride, facet))
            {
                ++s;
            }
            behind.append(s);
            for (label a = 0; a < stride; ++a)
            {
                if (!facet.found(simplexCorners()[stride*s + a]))
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
    return fePatch
    {
        pp.name(),
        pp.type(),
        pp.index(),
        labelList(facets),
        labelList(behind),
        labelList(opposite),
        nodes.sortedToc(),
        labelList()
    };
}


Foam::labelList Foam::feMesh::remoteNodes(const labelUList& nodes) const
{
    labelList onPatch(nNodes(), Zero);
    UIndirectList<label>(onPatch, nodes) = 1;
    const labelList here(onPatch);
    exchange_.max(onPatch);

    DynamicList<label> remote;
    for (const label nodei : exchange_.shared())
    {
        if (onPatch[nodei] && !here[nodei])
        {
            remote.append(nodei);
        }
    }
    return labelList(std::move(remote));
}


void Foam::feMesh::findPatches()
{
    // First simplex of each cell: simplices are stored cell by cell
    labelList firstSimplex(mesh_.nCells() + 1, nSimplices());
    for (label s = nSimplices() - 1; s >= 0; --s)
    {
        firstSimplex[cellOfSimplex_[s]] = s;
    }

    DynamicList<fePatch> patches;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if
        (
            isA<emptyPolyPatch>(pp) || isA<wedgePolyPatch>(pp)
         || pp.coupled() || isAxis(pp)
        )
        {
            continue;
        }
        patches.append(findPatch(pp, firstSimplex));
        patches.last().remoteNodes = remoteNodes(patches.last().nodes);
    }
    patches_.transfer(patches);
    faceFans_.clear();
}
