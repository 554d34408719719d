/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "nodeVolumes.H"

namespace
{

template<int dim>
void addVolumes(const Foam::feMesh& mesh, Foam::scalarField& volumes)
{
    using namespace Foam;

    const labelList& simplices = mesh.simplices();
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        const label* nodes = &simplices[(dim + 1)*s];
        const label* corners = &mesh.simplexCorners()[(dim + 1)*s];
        simplexVec<dim> x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = mesh.components<dim>(mesh.corners()[corners[a]]);
        }
        const scalar share =
            mesh.depth()*simplex::volume<dim>(simplex::edges<dim>(x))
           /(dim + 1);
        for (int a = 0; a <= dim; ++a)
        {
            volumes[nodes[a]] += share;
        }
    }
}

} // End namespace


Foam::tmp<Foam::scalarField> Foam::nodeVolumes(const feMesh& mesh)
{
    auto tvolumes = tmp<scalarField>::New(mesh.nNodes(), Zero);
    switch (mesh.dim())
    {
        case 1: addVolumes<1>(mesh, tvolumes.ref()); break;
        case 2: addVolumes<2>(mesh, tvolumes.ref()); break;
        default: addVolumes<3>(mesh, tvolumes.ref()); break;
    }
    return tvolumes;
}


void Foam::sumCopies(const feMesh& mesh, scalarField& nodeValues)
{
    mesh.exchange().sum(nodeValues.data(), 1, 1);
}
