/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "nodeVolumes.H"
#include "simplexPiece.H"

namespace
{

template<int dim>
void addVolumes(const Foam::feMesh& mesh, Foam::scalarField& volumes)
{
    using namespace Foam;

    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        const label* nodes = &mesh.simplices()[(dim + 1)*s];
        const simplexPiece<dim> whole(mesh, s, plainVolume<dim>(mesh, s));
        typename simplexPiece<dim>::Bary integrals =
            simplexPiece<dim>::Bary::Zero();
        whole.addIntegrals(mesh.curvature(), integrals);
        for (int a = 0; a <= dim; ++a)
        {
            volumes[nodes[a]] += integrals[a];
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
