/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasBoundary.H"
#include "farFieldPointPatchFields.H"
#include "shellInterfacePointPatchVectorField.H"
#include "zeroGradientPointPatchField.H"
#include "calculatedPointPatchField.H"
#include "slipPointPatchField.H"
#include "valuePointPatchField.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"

namespace
{

using namespace Foam;

//- Free: leaves the node's value to the solution
template<class Type>
bool isFree(const pointPatchField<Type>& pf)
{
    return
        isA<zeroGradientPointPatchField<Type>>(pf)
     || isType<calculatedPointPatchField<Type>>(pf)
     || isA<basicSymmetryPointPatchField<Type>>(pf);
}

//- Prescribed: fixedValue, uniformFixedValue, timeVaryingMapped...
template<class Type>
bool isPrescribed(const pointPatchField<Type>& pf)
{
    return
        isA<valuePointPatchField<Type>>(pf)
     && !isType<calculatedPointPatchField<Type>>(pf);
}

template<class Type>
void checkType
(
    const GeometricField<Type, pointPatchField, pointMesh>& field,
    const fePatch& patch
)
{
    const pointPatchField<Type>& pf = field.boundaryField()[patch.index];
    if
    (
        isFree(pf) || isPrescribed(pf) || isA<farFieldPointPatchField<Type>>(pf)
    )
    {
        return;
    }

    FatalErrorInFunction
        << "Field " << field.name() << " has type " << pf.type()
        << " on patch " << patch.name << " (" << field.objectPath() << ")"
        << nl << "    The gas solver knows zeroGradient, fixedValue and its "
        << "relatives, slip, symmetry, symmetryPlane," << nl
        << "    farField and, for U, shellInterface" << exit(FatalError);
}

} // End namespace


template<int dim>
Foam::gasBoundary<dim>::gasBoundary
(
    const gasGeometry<dim>& geometry,
    const gasDynamics::PerfectGas& eos,
    pointScalarField& p,
    pointVectorField& U,
    pointScalarField& T
)
:
    geometry_(geometry),
    eos_(eos),
    p_(p),
    U_(U),
    T_(T),
    walls_(wallPatches()),
    wallConstraints_(geometry, walls_)
{
    classify();
    readOuterStates();
}


template<int dim>
bool Foam::gasBoundary<dim>::isWall(const fePatch& patch) const
{
    return
        patch.type == symmetryPolyPatch::typeName
     || patch.type == symmetryPlanePolyPatch::typeName
     || isA<basicSymmetryPointPatchField<vector>>
        (
            U_.boundaryField()[patch.index]
        );
}


template<int dim>
Foam::List<const Foam::fePatch*>
Foam::gasBoundary<dim>::wallPatches() const
{
    DynamicList<const fePatch*> walls;
    for (const fePatch& patch : geometry_.mesh().patches())
    {
        if (isWall(patch))
        {
            walls.append(&patch);
        }
    }
    return List<const fePatch*>(std::move(walls));
}


template<int dim>
void Foam::gasBoundary<dim>::classify()
{
    DynamicList<const fePatch*> open, farField;

    for (const fePatch& patch : geometry_.mesh().patches())
    {
        checkType(p_, patch);
        checkType(U_, patch);
        checkType(T_, patch);

        const auto& pp = p_.boundaryField()[patch.index];
        const auto& Up = U_.boundaryField()[patch.index];
        const auto& Tp = T_.boundaryField()[patch.index];

        const label nFar =
            label(bool(isA<farFieldPointPatchField<scalar>>(pp)))
          + label(bool(isA<farFieldPointPatchField<vector>>(Up)))
          + label(bool(isA<farFieldPointPatchField<scalar>>(Tp)));

        if (nFar != 0 && nFar != 3)
        {
            FatalErrorInFunction
                << "Patch " << patch.name << " is " << pp.type() << " for p, "
                << Up.type() << " for U and " << Tp.type() << " for T" << nl
                << "    farField needs the outer state of all three"
                << exit(FatalError);
        }

        if (nFar == 3)
        {
            farField.append(&patch);
            continue;
        }
        if (!isWall(patch))
        {
            open.append(&patch);
        }
        if (isPrescribed(pp)) fixedP_.append(patch.index);
        if (isPrescribed(Up)) fixedU_.append(patch.index);
        if (isPrescribed(Tp)) fixedT_.append(patch.index);
    }

    open_.transfer(open);
    farField_.transfer(farField);
}


template<int dim>
void Foam::gasBoundary<dim>::readOuterStates()
{
    const feMesh& mesh = geometry_.mesh();
    outer_.setSize(farField_.size());

    forAll(farField_, i)
    {
        const fePatch& patch = *farField_[i];
        const auto& p = refCast<const farFieldPointPatchField<scalar>>
        (
            p_.boundaryField()[patch.index]
        ).outer();
        const auto& U = refCast<const farFieldPointPatchField<vector>>
        (
            U_.boundaryField()[patch.index]
        ).outer();
        const auto& T = refCast<const farFieldPointPatchField<scalar>>
        (
            T_.boundaryField()[patch.index]
        ).outer();

        const labelList& points =
            p_.boundaryField()[patch.index].patch().meshPoints();
        outer_[i].resize(patch.nodes.size());

        forAll(points, pointi)
        {
            const label node = mesh.nodeOfPoint()[points[pointi]];
            const label local = findLower(patch.nodes, node + 1);
            outer_[i][local] = gasDynamics::conserved<dim>
            (
                eos_,
                eos_.density(p[pointi], T[pointi]),
                mesh.components<dim>(U[pointi]),
                p[pointi]
            );
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::setPrescribed(std::vector<State>& states)
{
    const feMesh& mesh = geometry_.mesh();

    // Conserved state of a node from its own primitive variables, of which
    // the caller changes one
    auto change = [&](const label pointi, auto&& changePrimitive)
    {
        State& s = states[mesh.nodeOfPoint()[pointi]];
        Vec U = gasDynamics::velocity<dim>(s);
        double p = gasDynamics::pressure<dim>(eos_, s);
        double T = eos_.temperature(p, s[0]);
        changePrimitive(p, U, T);
        s = gasDynamics::conserved<dim>(eos_, eos_.density(p, T), U, p);
    };

    for (const label patchi : fixedP_)
    {
        auto& pf = p_.boundaryFieldRef()[patchi];
        pf.evaluate();
        const auto& values = refCast<valuePointPatchField<scalar>>(pf);
        forAll(values, i)
        {
            change
            (
                pf.patch().meshPoints()[i],
                [&](double& p, Vec&, double&) { p = values[i]; }
            );
        }
    }
    for (const label patchi : fixedT_)
    {
        auto& pf = T_.boundaryFieldRef()[patchi];
        pf.evaluate();
        const auto& values = refCast<valuePointPatchField<scalar>>(pf);
        forAll(values, i)
        {
            change
            (
                pf.patch().meshPoints()[i],
                [&](double&, Vec&, double& T) { T = values[i]; }
            );
        }
    }
    for (const label patchi : fixedU_)
    {
        auto& pf = U_.boundaryFieldRef()[patchi];
        pf.evaluate();
        const auto& values = refCast<valuePointPatchField<vector>>(pf);
        forAll(values, i)
        {
            change
            (
                pf.patch().meshPoints()[i],
                [&](double&, Vec& U, double&)
                {
                    U = mesh.components<dim>(values[i]);
                }
            );
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::impose(std::vector<State>& states)
{
    setPrescribed(states);
    wallConstraints_.apply(states);
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
