/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "globalNodes.H"
#include "bandCompression.H"
#include "edge.H"
#include "Map.H"
#include "UIndirectList.H"

#include <algorithm>

namespace
{

//- Root of a point's group in a union-find forest, halving paths on the way
Foam::label root(Foam::labelList& parent, Foam::label i)
{
    while (parent[i] != i)
    {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

} // End namespace


void Foam::feMesh::findStations()
{
    const tmp<pointField> tscene(scenePositions(mesh_.points()));
    const pointField& points = mesh_.points();
    const pointField& scene = tscene();
    labelList parent(identity(points.size()));

    if (dim_ < 3)
    {
        // Points joined by an edge across the thickness are one station; the
        // smallest label is the group's root, hence its representative
        for (const edge& e : mesh_.edges())
        {
            const vector d(e.vec(scene));
            scalar inScene = 0;
            for (const direction axis : axes_)
            {
                inScene = max(inScene, mag(d[axis]));
            }
            if (inScene < 1e-6*e.mag(points))
            {
                const label a = root(parent, e[0]);
                const label b = root(parent, e[1]);
                parent[max(a, b)] = min(a, b);
            }
        }
    }

    stationOfPoint_.setSize(points.size());
    labelList groupSize(points.size(), Zero);
    forAll(points, pointi)
    {
        stationOfPoint_[pointi] = root(parent, pointi);
        ++groupSize[stationOfPoint_[pointi]];
    }

    forAll(points, pointi)
    {
        const label expected = stationSize(scene[pointi]);
        const label n = groupSize[stationOfPoint_[pointi]];
        if (n != expected)
        {
            FatalErrorInFunction
                << "A mesh with " << dim_ << " solution direction(s) must be "
                << "one cell thick in the others, with edges straight across:"
                << nl << "    the point at " << points[pointi]
                << " stands in line with " << n - 1
                << " other point(s) instead of " << expected - 1 << nl
                << "    Check the " << (curvature_ ? "wedge and " : "")
                << "empty patches and the mesh's thickness"
                << exit(FatalError);
        }
        if (curvature_ && points[pointi][radialComponent_] < -axisTolerance_)
        {
            FatalErrorInFunction
                << "The point at " << points[pointi] << " lies on the negative "
                << "side of the axis: a mesh with wedge patches must lie where "
                << vector::componentNames[radialComponent_] << " is positive"
                << exit(FatalError);
        }
    }
}


Foam::label Foam::feMesh::stationSize(const point& scenePosition) const
{
    const bool onAxis =
        curvature_ > 0 && scenePosition[radialComponent_] == 0;
    switch (dim_)
    {
        case 1: return !onAxis ? 4 : curvature_ == 1 ? 2 : 1;
        case 2: return onAxis ? 1 : 2;
        default: return 1;
    }
}


void Foam::feMesh::findNodes()
{
    const labelList global
    (
        globalNodeOfPoints
        (
            mesh_, undecomposedLabels(mesh_), stationOfPoint_
        )
    );

    // A node's representative is its first mesh point, which is a station
    Map<label> nodeOfLabel(2*global.size());
    nodeOfPoint_.setSize(global.size());
    DynamicList<label> representative(global.size());
    DynamicList<label> labels(global.size());
    forAll(global, pointi)
    {
        if (nodeOfLabel.insert(global[pointi], representative.size()))
        {
            representative.append(pointi);
            labels.append(global[pointi]);
        }
        nodeOfPoint_[pointi] = nodeOfLabel[global[pointi]];
    }

    pointOfNode_.transfer(representative);
    globalNode_.transfer(labels);
    orderNodes();
    nodes_ = gather(mesh_.points());
}


void Foam::feMesh::orderNodes()
{
    // Neighbours along the mesh's edges, as bandCompression reads them
    auto forPairs = [&](auto&& visit)
    {
        for (const edge& e : mesh_.edges())
        {
            const label a = nodeOfPoint_[e[0]], b = nodeOfPoint_[e[1]];
            if (a != b)
            {
                visit(a, b);
                visit(b, a);
            }
        }
    };
    labelList start(nNodes() + 1, Zero);
    forPairs([&](const label a, label) { ++start[a + 1]; });
    for (label i = 0; i < nNodes(); ++i)
    {
        start[i + 1] += start[i];
    }
    labelList neighbours(start[nNodes()]);
    labelList next(start);
    forPairs
    (
        [&](const label a, const label b) { neighbours[next[a]++] = b; }
    );

    const labelList order(bandCompression(neighbours, start));
    labelList place(nNodes());
    UIndirectList<label>(place, order) = identity(nNodes());
    for (label& nodei : nodeOfPoint_)
    {
        nodei = place[nodei];
    }
    pointOfNode_ = labelList(UIndirectList<label>(pointOfNode_, order));
    globalNode_ = labelList(UIndirectList<label>(globalNode_, order));
}


void Foam::feMesh::findImages()
{
    const tmp<pointField> tscene(scenePositions(mesh_.points()));
    const pointField& points = tscene();
    cornerOfPoint_.setSize(points.size());
    DynamicList<label> imageNode;
    DynamicList<vector> imageShift;

    forAll(points, pointi)
    {
        const label station = stationOfPoint_[pointi];
        const label nodei = nodeOfPoint_[pointi];
        if (pointi != station)
        {
            cornerOfPoint_[pointi] = cornerOfPoint_[station];
        }
        else if (pointi == pointOfNode_[nodei])
        {
            cornerOfPoint_[pointi] = nodei;
        }
        else
        {
            cornerOfPoint_[pointi] = nNodes() + imageNode.size();
            vector shift(Zero);
            for (const direction axis : axes_)
            {
                shift[axis] = points[pointi][axis] - nodes_[nodei][axis];
            }
            imageNode.append(nodei);
            imageShift.append(shift);
        }
    }
    imageNode_.transfer(imageNode);
    imageShift_.transfer(imageShift);
    if (imageNode_.size())
    {
        corners_ = cornerPositions(nodes_);
    }
}


void Foam::feMesh::setNodesOfSimplices()
{
    if (imageNode_.empty())
    {
        simplices_.transfer(simplexCorners_);
        return;
    }

    const label stride = dim_ + 1;
    simplices_.setSize(simplexCorners_.size());
    forAll(simplexCorners_, i)
    {
        simplices_[i] = nodeOfCorner(simplexCorners_[i]);
    }

    for (label s = 0; s < nSimplices(); ++s)
    {
        const label* nodes = &simplices_[stride*s];
        for (label a = 0; a < stride; ++a)
        {
            if (std::count(nodes, nodes + stride, nodes[a]) > 1)
            {
                const label celli = cellOfSimplex_[s];
                FatalErrorInFunction
                    << "Cell " << celli << " at "
                    << mesh_.cellCentres()[celli] << " has two cyclic patches "
                    << "as its sides: one of its simplices holds the node at "
                    << nodes_[nodes[a]] << " twice" << nl
                    << "    Make the mesh at least two cells long between "
                    << "cyclic patches; nothing can vary over one cell, which "
                    << "empty sides compute with fewer nodes"
                    << exit(FatalError);
            }
        }
    }
}
