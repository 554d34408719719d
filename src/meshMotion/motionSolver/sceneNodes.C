/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "sceneNodes.H"
#include "wedgePolyPatch.H"

namespace
{

//- Root of a point's group, halving paths on the way
Foam::label root(Foam::labelList& parent, Foam::label i)
{
    while (parent[i] != i)
    {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}


bool before(const Foam::point& p, const Foam::point& q)
{
    for (Foam::direction a = 0; a < 3; ++a)
    {
        if (p[a] != q[a])
        {
            return p[a] < q[a];
        }
    }
    return false;
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sceneNodes::sceneNodes(const polyMesh& mesh, const pointField& points)
:
    points_(points),
    isWedge_(false)
{
    findDirections(mesh);
    findNodes(mesh);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::sceneNodes::findDirections(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            const auto& wedge = refCast<const wedgePolyPatch>(patch);
            directions_.append(wedge.axis());
            isWedge_ = true;
            return;
        }
    }

    for (direction a = 0; a < 3; ++a)
    {
        if (mesh.geometricD()[a] > 0)
        {
            vector unit(Zero);
            unit[a] = 1;
            directions_.append(unit);
        }
    }
}


void Foam::sceneNodes::findNodes(const polyMesh& mesh)
{
    labelList parent(identity(points_.size()));
    if (dim() < 3)
    {
        for (const edge& e : mesh.edges())
        {
            if (sameNode(e[0], e[1]))
            {
                parent[root(parent, e[0])] = root(parent, e[1]);
            }
        }
    }

    nodeOfPoint_.setSize(points_.size(), -1);
    DynamicList<label> representatives(points_.size());
    forAll(points_, pointi)
    {
        const label r = root(parent, pointi);
        if (nodeOfPoint_[r] < 0)
        {
            nodeOfPoint_[r] = representatives.size();
            representatives.append(pointi);
        }
        const label node = nodeOfPoint_[pointi] = nodeOfPoint_[r];
        if (before(points_[pointi], points_[representatives[node]]))
        {
            representatives[node] = pointi;
        }
    }
    pointOfNode_.transfer(representatives);
}


bool Foam::sceneNodes::sameNode(const label p, const label q) const
{
    const vector inScene
    (
        toScene(p, points_[p]) - toScene(q, points_[q])
    );
    return mag(inScene) < 1e-6*mag(points_[p] - points_[q]);
}


Foam::vector Foam::sceneNodes::radial(const label pointi) const
{
    const vector& axis = directions_[0];
    const point& p = points_[pointi];
    const vector fromAxis(p - axis*(axis & p));
    const scalar r = mag(fromAxis);

    return r > SMALL*mag(p) ? vector(fromAxis/r) : vector(Zero);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::sceneNodes::toScene
(
    const label pointi,
    const vector& v
) const
{
    vector components(Zero);
    forAll(directions_, a)
    {
        components[a] = directions_[a] & v;
    }
    if (isWedge_)
    {
        components[1] = radial(pointi) & v;
    }
    return components;
}


Foam::vector Foam::sceneNodes::toMesh
(
    const label pointi,
    const vector& components
) const
{
    vector v(Zero);
    forAll(directions_, a)
    {
        v += components[a]*directions_[a];
    }
    if (isWedge_)
    {
        v += components[1]*radial(pointi);
    }
    return v;
}
