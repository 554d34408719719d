/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasBoundary.H"
#include "clockAt.H"
#include "farFieldPointPatchFields.H"
#include "noSlipPointPatchVectorField.H"
#include "shellInterfacePointPatchVectorField.H"
#include "zeroGradientPointPatchField.H"
#include "calculatedPointPatchField.H"
#include "slipPointPatchField.H"
#include "valuePointPatchField.H"
#include "PstreamReduceOps.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "wallPolyPatch.H"

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
     && !isType<calculatedPointPatchField<Type>>(pf)
     && !isA<farFieldPointPatchField<Type>>(pf);
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
        << "    farField and, for U, noSlip and shellInterface"
        << exit(FatalError);
}

} // End namespace


template<int dim>
Foam::gasBoundary<dim>::gasBoundary
(
    const gasGeometry<dim>& geometry,
    const gasDynamics::PerfectGas& eos,
    pointScalarField& p,
    pointVectorField& U,
    pointScalarField& T,
    const bool viscous
)
:
    geometry_(geometry),
    eos_(eos),
    p_(p),
    U_(U),
    T_(T),
    walls_(wallPatches()),
    outerVaries_(false),
    half_(geometry.nRows(), uniformRow(0)),
    present_(geometry.nRows(), uniformRow(0)),
    hasPrescribed_(false),
    wallConstraints_(geometry, walls_),
    noSlip_(geometry, eos, noSlipPatches(), U, T)
{
    checkWalls(viscous);
    classify();
    const scalar time = geometry.mesh().poly().time().value();
    findBoundaryNodes();
    if (hasPrescribed_)
    {
        evaluatePrescribed(time);
    }
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
        )
     || isNoSlip(patch);
}


template<int dim>
bool Foam::gasBoundary<dim>::isNoSlip(const fePatch& patch) const
{
    const auto& Up = U_.boundaryField()[patch.index];
    return
        isA<noSlipPointPatchVectorField>(Up)
     || (patch.type == wallPolyPatch::typeName && isPrescribed(Up));
}


template<int dim>
Foam::List<const Foam::fePatch*>
Foam::gasBoundary<dim>::noSlipPatches() const
{
    DynamicList<const fePatch*> patches;
    for (const fePatch* patch : walls_)
    {
        if (isNoSlip(*patch))
        {
            patches.append(patch);
        }
    }
    return List<const fePatch*>(std::move(patches));
}


template<int dim>
void Foam::gasBoundary<dim>::checkWalls(const bool viscous) const
{
    for (const fePatch* patch : walls_)
    {
        const word where(" on the wall " + patch->name);
        const word type(U_.boundaryField()[patch->index].type());
        const bool sticks = isNoSlip(*patch);
        if (sticks && !viscous)
        {
            FatalErrorInFunction
                << "U is " << type.c_str() << where.c_str() << " ("
                << U_.objectPath() << "), but the gas is inviscid" << nl
                << "    Choose slip, or a viscosity in "
                << "constant/thermophysicalProperties," << nl
                << "    or for inflow the type patch in "
                << "constant/polyMesh/boundary" << exit(FatalError);
        }
        if (sticks && isPrescribed(p_.boundaryField()[patch->index]))
        {
            FatalErrorInFunction
                << "p is prescribed" << where.c_str() << " ("
                << p_.objectPath() << "), through which no mass passes" << nl
                << "    Choose zeroGradient" << exit(FatalError);
        }
        if
        (
            viscous && !sticks
         && isPrescribed(T_.boundaryField()[patch->index])
        )
        {
            FatalErrorInFunction
                << "T is prescribed" << where.c_str() << " ("
                << T_.objectPath() << "), where U is " << type.c_str() << nl
                << "    A wall with a temperature needs U noSlip, or T "
                << "zeroGradient" << exit(FatalError);
        }
    }
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
        if (isNoSlip(patch))
        {
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
    for (const fePatch* patch : farField_)
    {
        farFlow_.append
        (
            new farFieldPatch<dim>(geometry_, eos_, *patch, p_, U_, T_)
        );
        outerVaries_ = outerVaries_ || farFlow_.last().varies();
    }
}


template<int dim>
void Foam::gasBoundary<dim>::findBoundaryNodes()
{
    const feMesh& mesh = geometry_.mesh();

    std::vector<double> fixed(mesh.nNodes(), 0.0), any(mesh.nNodes(), 0.0);
    for (const fePatch& patch : mesh.patches())
    {
        for (const label node : patch.nodes)
        {
            any[node] = 1;
        }
    }
    auto mark = [&](const auto& field, const labelUList& patches)
    {
        for (const label patchi : patches)
        {
            const auto& pf = field.boundaryField()[patchi];
            for (const label pointi : pf.patch().meshPoints())
            {
                fixed[mesh.nodeOfPoint()[pointi]] = 1;
            }
        }
    };
    mark(p_, fixedP_);
    mark(T_, fixedT_);
    mark(U_, fixedU_);
    mesh.exchange().max(fixed.data(), 1, 1);
    mesh.exchange().max(any.data(), 1, 1);

    DynamicList<label> prescribed, boundary;
    placeOfNode_.setSize(mesh.nNodes(), -1);
    for (label a = 0; a < mesh.nNodes(); ++a)
    {
        if (fixed[a] > 0)
        {
            placeOfNode_[a] = prescribed.size();
            prescribed.append(a);
        }
        if (any[a] > 0)
        {
            boundary.append(a);
        }
    }
    prescribed_.transfer(prescribed);
    boundaryNodes_.transfer(boundary);
    values_.resize(prescribed_.size());
    prescribedRate_.assign(prescribed_.size(), State::Zero());
    hasPrescribed_ = returnReduce(prescribed_.size() > 0, orOp<bool>());

    const prescription none{-GREAT, -GREAT, {-GREAT, -GREAT, -GREAT}};
    shared_.assign(Pstream::parRun() ? mesh.nNodes() : 0, none);
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
