/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "nodeParity.H"

#include <algorithm>
#include <deque>

namespace
{

using namespace Foam;

//- The nodes that a mesh edge joins to each node
struct nodeGraph
{
    labelList start;
    labelList neighbours;

    nodeGraph
    (
        const polyMesh& mesh,
        const labelUList& nodeOfPoint,
        const label nNodes
    )
    :
        start(nNodes + 1, Zero)
    {
        // Edges across the thickness join a node to itself
        auto forEdges = [&](auto&& visit)
        {
            for (const edge& e : mesh.edges())
            {
                const label a = nodeOfPoint[e[0]];
                const label b = nodeOfPoint[e[1]];
                if (a != b)
                {
                    visit(a, b);
                    visit(b, a);
                }
            }
        };
        forEdges([&](label a, label) { ++start[a + 1]; });
        for (label i = 0; i < nNodes; ++i)
        {
            start[i + 1] += start[i];
        }
        neighbours.setSize(start[nNodes]);
        labelList next(start);
        forEdges([&](label a, label b) { neighbours[next[a]++] = b; });
    }

    SubList<label> of(const label nodei) const
    {
        return SubList<label>
        (
            neighbours, start[nodei + 1] - start[nodei], start[nodei]
        );
    }
};


//- Connected parts of this processor's nodes, without those beyond
label findParts(const nodeGraph& graph, labelList& part)
{
    label nParts = 0;
    part = -1;
    DynamicList<label> front;
    forAll(part, seed)
    {
        if (part[seed] >= 0)
        {
            continue;
        }
        part[seed] = nParts;
        front.append(seed);
        while (front.size())
        {
            const label nodei = front.remove();
            for (const label nbr : graph.of(nodei))
            {
                if (part[nbr] < 0)
                {
                    part[nbr] = nParts;
                    front.append(nbr);
                }
            }
        }
        ++nParts;
    }
    return nParts;
}


//- Smallest global label of the whole connected part that holds each node
labelList smallestOfPart
(
    const nodeGraph& graph,
    const labelUList& globalNode,
    const sharedItems& exchange
)
{
    labelList part(globalNode.size());
    const label nParts = findParts(graph, part);
    labelList smallest(globalNode);

    bool changed = true;
    while (changed)
    {
        labelList ofPart(nParts, labelMax);
        forAll(part, nodei)
        {
            label& s = ofPart[part[nodei]];
            s = min(s, smallest[nodei]);
        }
        const labelList before(smallest);
        forAll(part, nodei)
        {
            smallest[nodei] = ofPart[part[nodei]];
        }
        exchange.min(smallest);
        changed = returnReduce(smallest != before, orOp<bool>());
    }
    return smallest;
}


//- Lower the distances around the seeds, nearest first
void spread
(
    const nodeGraph& graph,
    std::deque<label> seeds,
    labelList& distance
)
{
    std::sort
    (
        seeds.begin(), seeds.end(), [&](const label a, const label b)
        {
            return distance[a] < distance[b];
        }
    );
    std::deque<label> front;
    while (seeds.size() || front.size())
    {
        const bool fromSeeds =
            front.empty()
         || (seeds.size() && distance[seeds.front()] < distance[front.front()]);
        std::deque<label>& nearest = fromSeeds ? seeds : front;
        const label nodei = nearest.front();
        nearest.pop_front();
        for (const label nbr : graph.of(nodei))
        {
            if (distance[nodei] + 1 < distance[nbr])
            {
                distance[nbr] = distance[nodei] + 1;
                front.push_back(nbr);
            }
        }
    }
}

} // End namespace


Foam::labelList Foam::nodeParity
(
    const polyMesh& mesh,
    const labelUList& nodeOfPoint,
    const labelUList& globalNode,
    const sharedItems& exchange
)
{
    const nodeGraph graph(mesh, nodeOfPoint, globalNode.size());
    const labelList root(smallestOfPart(graph, globalNode, exchange));

    labelList distance(globalNode.size(), labelMax);
    std::deque<label> seeds;
    forAll(root, nodei)
    {
        if (root[nodei] == globalNode[nodei])
        {
            distance[nodei] = 0;
            seeds.push_back(nodei);
        }
    }

    // From processor to processor until no distance becomes smaller
    bool changed = true;
    while (changed)
    {
        spread(graph, seeds, distance);
        const labelList before(distance);
        exchange.min(distance);
        seeds.clear();
        for (const label nodei : exchange.shared())
        {
            if (distance[nodei] < before[nodei])
            {
                seeds.push_back(nodei);
            }
        }
        changed = returnReduce(seeds.size() > 0, orOp<bool>());
    }

    for (label& d : distance)
    {
        d %= 2;
    }
    return distance;
}
