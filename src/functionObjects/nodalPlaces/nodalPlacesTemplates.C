/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "nodalPlaces.H"
#include "ops.H"

template<class Type>
Foam::List<Type> Foam::nodalPlaces::values
(
    const feMesh& mesh,
    const GeometricField<Type, pointPatchField, pointMesh>& field
) const
{
    const label stride = mesh.dim() + 1;
    List<Type> found(size(), Zero);
    forAll(found, i)
    {
        for (label a = 0; holder_[i] == Pstream::myProcNo() && a < stride; ++a)
        {
            const label node = mesh.simplices()[stride*simplices_[i] + a];
            found[i] += weights_[i][a]*field[mesh.pointOfNode()[node]];
        }
    }
    Pstream::listCombineGather(found, plusEqOp<Type>());
    return found;
}
