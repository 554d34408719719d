/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "simplexVolumes.H"

namespace
{

using namespace Foam;

template<int dim>
scalarField volumes(const feMesh& mesh, const pointField& nodes)
{
    const tmp<pointField> tcorners(mesh.cornerPositions(nodes));
    const pointField& corners = tcorners();
    const label* corner = mesh.simplexCorners().cdata();

    scalarField result(mesh.nSimplices());
    for (scalar& volume : result)
    {
        simplexVec<dim> x[dim + 1];
        for (simplexVec<dim>& xa : x)
        {
            xa = mesh.components<dim>(corners[*corner++]);
        }
        volume = simplex::volume<dim>(simplex::edges<dim>(x));
    }
    return result;
}

} // End namespace


Foam::scalarField Foam::simplexVolumes
(
    const feMesh& mesh,
    const pointField& nodes
)
{
    switch (mesh.dim())
    {
        case 1: return volumes<1>(mesh, nodes);
        case 2: return volumes<2>(mesh, nodes);
        default: return volumes<3>(mesh, nodes);
    }
}
