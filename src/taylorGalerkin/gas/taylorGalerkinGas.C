/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasSolver.H"

Foam::autoPtr<Foam::taylorGalerkinGas> Foam::taylorGalerkinGas::New
(
    polyMesh& mesh
)
{
    feMesh& fe = const_cast<feMesh&>(feMesh::New(mesh));
    taylorGalerkinGas* gas = nullptr;
    switch (fe.dim())
    {
        case 1: gas = new gasSolver<1>(fe); break;
        case 2: gas = new gasSolver<2>(fe); break;
        default: gas = new gasSolver<3>(fe); break;
    }
    return autoPtr<taylorGalerkinGas>(gas);
}
