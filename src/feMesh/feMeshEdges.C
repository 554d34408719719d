/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "bitSet.H"

#include <algorithm>

void Foam::feMesh::findEdges()
{
    const label stride = dim_ + 1;

    // Second ends by first end, repeated as often as simplices hold the edge
    labelList start(nNodes() + 1, Zero);
    auto forPairs = [&](auto&& visit)
    {
        for (label s = 0; s < nSimplices(); ++s)
        {
            const label* nodes = &simplices_[stride*s];
            for (label a = 0; a < dim_; ++a)
            {
                for (label b = a + 1; b < stride; ++b)
                {
                    visit(min(nodes[a], nodes[b]), max(nodes[a], nodes[b]));
                }
            }
        }
    };
    forPairs([&](label first, label) { ++start[first + 1]; });
    for (label i = 0; i < nNodes(); ++i)
    {
        start[i + 1] += start[i];
    }
    labelList second(start[nNodes()]);
    labelList next(start);
    forPairs([&](label first, label end) { second[next[first]++] = end; });

    // Each once, ascending
    firstEdge_.setSize(nNodes() + 1);
    DynamicList<edge> edges(second.size()/2);
    for (label i = 0; i < nNodes(); ++i)
    {
        firstEdge_[i] = edges.size();
        label* begin = second.begin() + start[i];
        label* end = second.begin() + start[i + 1];
        std::sort(begin, end);
        end = std::unique(begin, end);
        for (const label* j = begin; j != end; ++j)
        {
            edges.append(edge(i, *j));
        }
    }
    firstEdge_[nNodes()] = edges.size();
    edges_.transfer(edges);

    simplexEdges_.setSize(nSimplices()*(stride*dim_)/2);
    label at = 0;
    forPairs
    (
        [&](const label first, const label end)
        {
            const auto row = edges_.begin() + firstEdge_[first];
            simplexEdges_[at++] = firstEdge_[first] + std::distance
            (
                row,
                std::lower_bound
                (
                    row,
                    edges_.begin() + firstEdge_[first + 1],
                    end,
                    [](const edge& e, const label j) { return e[1] < j; }
                )
            );
        }
    );
}


void Foam::feMesh::shareNodes()
{
    // Only nodes on the boundary of this processor's part have copies
    bitSet onBoundary(nNodes());
    for (label i = mesh_.nInternalFaces(); i < mesh_.nFaces(); ++i)
    {
        for (const label pointi : mesh_.faces()[i])
        {
            onBoundary.set(nodeOfPoint_[pointi]);
        }
    }
    const labelList candidates(onBoundary.toc());
    List<labelPair> keys(candidates.size());
    forAll(candidates, i)
    {
        const label g = globalNode_[candidates[i]];
        keys[i] = labelPair(g, g);
    }
    exchange_ = sharedItems(nNodes(), candidates, keys);
}


void Foam::feMesh::shareEdges()
{
    bitSet shared(nNodes());
    shared.set(exchange_.shared());

    DynamicList<label> candidates;
    DynamicList<labelPair> keys;
    forAll(edges_, edgei)
    {
        const edge& e = edges_[edgei];
        if (shared.test(e[0]) && shared.test(e[1]))
        {
            const label a = globalNode_[e[0]];
            const label b = globalNode_[e[1]];
            candidates.append(edgei);
            keys.append(labelPair(min(a, b), max(a, b)));
        }
    }
    edgeExchange_ = sharedItems(nEdges(), candidates, keys);
}
