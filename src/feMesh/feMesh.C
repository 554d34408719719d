/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "feMesh.H"
#include "FlatOutput.H"

namespace Foam
{
    defineTypeNameAndDebug(feMesh, 0);
}


Foam::feMesh::feMesh(const polyMesh& mesh)
:
    MeshObject<polyMesh, MoveableMeshObject, feMesh>(mesh),
    dim_(0),
    curvature_(0),
    radial_(0),
    radialComponent_(0),
    acrossComponent_(0),
    axisTolerance_(0),
    depth_(1),
    splitCounts_(label(0))
{
    findDirections();
    findStations();
    findNodes();
    findImages();
    shareNodes();
    splitCells();
    setNodesOfSimplices();
    findEdges();
    shareEdges();
    findPatches();
}


Foam::wordList Foam::feMesh::patchNames() const
{
    wordList names(patches_.size());
    forAll(patches_, i)
    {
        names[i] = patches_[i].name;
    }
    return names;
}


const Foam::fePatch& Foam::feMesh::patch(const word& name) const
{
    for (const fePatch& p : patches_)
    {
        if (p.name == name)
        {
            return p;
        }
    }

    FatalErrorInFunction
        << "There is no patch " << name << " that bounds the scene" << nl
        << "    Valid patches are " << flatOutput(patchNames())
        << exit(FatalError);

    return patches_.first();
}


Foam::tmp<Foam::pointField> Foam::feMesh::gather
(
    const pointField& meshPoints
) const
{
    auto tvalues = tmp<pointField>::New(nNodes());
    pointField& values = tvalues.ref();
    forAll(values, nodei)
    {
        values[nodei] = scenePosition(meshPoints[pointOfNode_[nodei]]);
    }
    return tvalues;
}


Foam::tmp<Foam::pointField> Foam::feMesh::cornerPositions
(
    const pointField& nodes
) const
{
    if (imageNode_.empty())
    {
        return tmp<pointField>(nodes);
    }
    auto tcorners = tmp<pointField>::New(nCorners());
    pointField& corners = tcorners.ref();
    forAll(nodes, nodei)
    {
        corners[nodei] = nodes[nodei];
    }
    forAll(imageNode_, i)
    {
        corners[nNodes() + i] = nodes[imageNode_[i]] + imageShift_[i];
    }
    return tcorners;
}


void Foam::feMesh::moveNodes(const pointField& newNodes)
{
    nodes_ = newNodes;
    if (imageNode_.size())
    {
        corners_ = cornerPositions(nodes_);
    }
}


bool Foam::feMesh::movePoints()
{
    moveNodes(gather(mesh_.points()));
    return true;
}


namespace
{

//- Barycentric coordinates of a point in a simplex
template<int dim>
Eigen::Matrix<double, dim + 1, 1> barycentric
(
    const Foam::feMesh& mesh,
    const Foam::label simplexi,
    const Foam::point& pt
)
{
    Foam::simplexVec<dim> x[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        x[a] = mesh.components<dim>
        (
            mesh.corners()[mesh.simplexCorners()[(dim + 1)*simplexi + a]]
        );
    }
    const Foam::simplexVec<dim> local =
        Foam::simplex::edges<dim>(x).partialPivLu().solve
        (
            mesh.components<dim>(pt) - x[0]
        );
    Eigen::Matrix<double, dim + 1, 1> b;
    b[0] = 1 - local.sum();
    b.template tail<dim>() = local;
    return b;
}


//- Whether the simplex holds the point; sets the weights if so
template<int dim>
bool holds
(
    const Foam::feMesh& mesh,
    const Foam::label simplexi,
    const Foam::point& pt,
    Foam::scalarList& weights
)
{
    // A point on an edge or a face is inside, whatever the rounding
    const double tolerance = 1e-9;

    const auto b = barycentric<dim>(mesh, simplexi, pt);
    if (b.minCoeff() < -tolerance)
    {
        return false;
    }
    weights.setSize(dim + 1);
    for (int a = 0; a <= dim; ++a)
    {
        weights[a] = b[a];
    }
    return true;
}

} // End namespace


bool Foam::feMesh::inSimplex
(
    const label simplexi,
    const point& pt,
    scalarList& weights
) const
{
    switch (dim_)
    {
        case 1: return holds<1>(*this, simplexi, pt, weights);
        case 2: return holds<2>(*this, simplexi, pt, weights);
        default: return holds<3>(*this, simplexi, pt, weights);
    }
}


Foam::label Foam::feMesh::findSimplex
(
    const point& pt,
    scalarList& weights
) const
{
    for (label s = 0; s < nSimplices(); ++s)
    {
        if (inSimplex(s, pt, weights))
        {
            return s;
        }
    }
    return -1;
}
