/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "movingPart.H"
#include "bitSet.H"

bool Foam::movingPart::add
(
    const feMesh& mesh,
    const pointField& from,
    const pointField& to
)
{
    nodeMoves_.setSize(mesh.nNodes(), false);
    simplexMoves_.setSize(mesh.nSimplices(), false);

    DynamicList<label> added;
    forAll(nodeMoves_, a)
    {
        if (!nodeMoves_[a] && from[a] != to[a])
        {
            nodeMoves_[a] = true;
            added.append(a);
        }
    }
    added_.transfer(added);
    if (found_ && added_.empty())
    {
        return false;
    }
    found_ = true;
    findItems(mesh);
    return true;
}


void Foam::movingPart::findItems(const feMesh& mesh)
{
    const label nCorners = mesh.dim() + 1;
    const label nPairs = nCorners*mesh.dim()/2;
    bitSet nodes(mesh.nNodes());
    bitSet edges(mesh.nEdges());
    nodes.set(mesh.exchange().shared());
    edges.set(mesh.edgeExchange().shared());

    DynamicList<label> simplices(simplices_.size());
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        const SubList<label> corners(mesh.simplices(), nCorners, nCorners*s);
        for (const label a : corners)
        {
            simplexMoves_[s] = simplexMoves_[s] || nodeMoves_[a];
        }
        if (simplexMoves_[s])
        {
            simplices.append(s);
            nodes.set(corners);
            edges.set(SubList<label>(mesh.simplexEdges(), nPairs, nPairs*s));
        }
    }
    simplices_.transfer(simplices);
    nodes_ = nodes.sortedToc();
    edges_ = edges.sortedToc();

    facets_.setSize(mesh.patches().size());
    forAll(facets_, patchi)
    {
        const labelList& simplexOf = mesh.patches()[patchi].facetSimplex;
        DynamicList<label> facets;
        forAll(simplexOf, i)
        {
            if (simplexMoves_[simplexOf[i]])
            {
                facets.append(i);
            }
        }
        facets_[patchi].transfer(facets);
    }
}
