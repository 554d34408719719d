/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "edge.H"

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


void Foam::feMesh::findNodes()
{
    const pointField& points = mesh_.points();
    labelList parent(identity(points.size()));

    if (dim_ < 3)
    {
        // Points joined by an edge across the thickness are one node; the
        // smallest label is the group's root, hence its representative
        for (const edge& e : mesh_.edges())
        {
            const vector d(e.vec(points));
            scalar inScene = 0;
            for (const direction axis : axes_)
            {
                inScene = max(inScene, mag(d[axis]));
            }
            if (inScene < 1e-6*mag(d))
            {
                const label a = root(parent, e[0]);
                const label b = root(parent, e[1]);
                parent[max(a, b)] = min(a, b);
            }
        }
    }

    nodeOfPoint_.setSize(points.size());
    labelList groupSize(points.size(), Zero);
    DynamicList<label> representative(points.size());

    forAll(points, pointi)
    {
        const label r = root(parent, pointi);
        if (r == pointi)
        {
            nodeOfPoint_[pointi] = representative.size();
            representative.append(pointi);
        }
        else
        {
            nodeOfPoint_[pointi] = nodeOfPoint_[r];
        }
        ++groupSize[r];
    }

    pointOfNode_.transfer(representative);
    nodes_ = gather(points);

    const label expected = (dim_ == 3 ? 1 : dim_ == 2 ? 2 : 4);
    for (const label pointi : pointOfNode_)
    {
        if (groupSize[pointi] != expected)
        {
            FatalErrorInFunction
                << "A mesh with " << dim_ << " solution direction(s) must be "
                << "one cell thick in the others, with edges straight across:"
                << nl << "    the point at " << points[pointi]
                << " stands in line with " << groupSize[pointi] - 1
                << " other point(s) instead of " << expected - 1 << nl
                << "    Check the empty patches and the mesh's thickness"
                << exit(FatalError);
        }
    }
}
