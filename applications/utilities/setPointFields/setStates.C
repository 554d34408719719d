/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "setStates.H"
#include "entryList.H"
#include "fieldValues.H"
#include "gasProperties.H"
#include "IOdictionary.H"
#include "initialState.H"
#include "syncTools.H"

namespace
{

//- Error when a field differs between the copies of a point; the copies on
//  other processors were made equal by the states, so it is a cyclic patch
void checkCopies(const Foam::pointScalarField& field)
{
    using namespace Foam;

    const polyMesh& mesh = field.mesh()();
    scalarField low(field.primitiveField());
    scalarField high(low);
    syncTools::syncPointList(mesh, low, minEqOp<scalar>(), GREAT);
    syncTools::syncPointList(mesh, high, maxEqOp<scalar>(), -GREAT);
    forAll(low, pointi)
    {
        if (high[pointi] - low[pointi] > 1e-9*high[pointi])
        {
            FatalErrorInFunction
                << field.name() << " at " << mesh.points()[pointi]
                << " would be " << low[pointi] << " and " << high[pointi]
                << " on the two sides of a cyclic patch" << nl
                << "    Keep the states away from cyclic patches that they do "
                << "not repeat across" << exit(FatalError);
        }
    }
}

//- Vectors in the scene's directions, of which the radial one of a wedge scene
//  differs from point to point
template<int dim>
Foam::vectorField inScene
(
    const Foam::feMesh& mesh,
    const Foam::vectorField& U
)
{
    Foam::vectorField result(mesh.nNodes());
    forAll(result, i)
    {
        const Foam::label pointi = mesh.pointOfNode()[i];
        result[i] = mesh.fullVector<dim>
        (
            mesh.components<dim>(U[pointi], mesh.poly().points()[pointi])
        );
    }
    return result;
}

template<int dim>
Foam::vectorField atPoints
(
    const Foam::feMesh& mesh,
    const Foam::vectorField& U
)
{
    Foam::vectorField result(mesh.nodeOfPoint().size());
    forAll(result, pointi)
    {
        result[pointi] = mesh.fullVector<dim>
        (
            mesh.components<dim>(U[mesh.nodeOfPoint()[pointi]]),
            mesh.poly().points()[pointi]
        );
    }
    return result;
}

Foam::vectorField inScene
(
    const Foam::feMesh& mesh,
    const Foam::vectorField& U
)
{
    return
        mesh.dim() == 1 ? inScene<1>(mesh, U)
      : mesh.dim() == 2 ? inScene<2>(mesh, U)
      : inScene<3>(mesh, U);
}

Foam::vectorField atPoints
(
    const Foam::feMesh& mesh,
    const Foam::vectorField& U
)
{
    return
        mesh.dim() == 1 ? atPoints<1>(mesh, U)
      : mesh.dim() == 2 ? atPoints<2>(mesh, U)
      : atPoints<3>(mesh, U);
}

} // End namespace


void Foam::setStates
(
    const polyMesh& mesh,
    const dictionary& dict,
    const word& keyword
)
{
    const PtrList<entry> states(readEntryList(dict, keyword));
    if (states.empty())
    {
        return;
    }

    const IOdictionary properties
    (
        IOobject
        (
            "thermophysicalProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    const feMesh& fe = feMesh::New(mesh);
    auto& p = casePointField<scalar>(mesh, "p");
    auto& U = casePointField<vector>(mesh, "U");
    auto& T = casePointField<scalar>(mesh, "T");
    gasNodes nodes
    (
        fe,
        readPerfectGas(properties),
        scalarField(p.primitiveField(), fe.pointOfNode()),
        inScene(fe, U.primitiveField()),
        scalarField(T.primitiveField(), fe.pointOfNode())
    );

    for (const entry& state : states)
    {
        Info<< "State " << state.keyword() << endl;
        initialState::New(state.keyword(), fe, state.dict())->set(nodes);
    }

    p.primitiveFieldRef() = scalarField(nodes.p(), fe.nodeOfPoint());
    U.primitiveFieldRef() = atPoints(fe, nodes.U());
    T.primitiveFieldRef() = scalarField(nodes.T(), fe.nodeOfPoint());
    checkCopies(p);
    checkCopies(T);
}
