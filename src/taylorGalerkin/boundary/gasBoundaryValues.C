/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
//  What the boundary prescribes: values, rates and differences

#include "gasBoundary.H"
#include "clockAt.H"
#include "valuePointPatchField.H"

template<int dim>
void Foam::gasBoundary<dim>::evaluatePrescribed(const scalar time)
{
    const feMesh& mesh = geometry_.mesh();
    const clockAt clock(mesh.poly().time(), time);
    const prescription none{-GREAT, -GREAT, {-GREAT, -GREAT, -GREAT}};
    std::fill(values_.begin(), values_.end(), none);

    auto take = [&](auto& field, const labelUList& patches, auto&& set)
    {
        for (const label patchi : patches)
        {
            auto& pf = field.boundaryFieldRef()[patchi];
            pf.evaluate();
            using Type = typename std::decay_t<decltype(pf)>::value_type;
            const auto& values = refCast<const valuePointPatchField<Type>>(pf);
            const labelList& points = pf.patch().meshPoints();
            forAll(points, i)
            {
                const label node = mesh.nodeOfPoint()[points[i]];
                set(values_[placeOfNode_[node]], values[i], points[i]);
            }
        }
    };
    take(p_, fixedP_, [](prescription& v, scalar p, label) { v.p = p; });
    take(T_, fixedT_, [](prescription& v, scalar T, label) { v.T = T; });
    take
    (
        U_, fixedU_,
        [&](prescription& v, const vector& U, const label pointi)
        {
            if (noSlip_.holds(mesh.nodeOfPoint()[pointi]))
            {
                return;
            }
            const Vec components =
                mesh.components<dim>(U, mesh.poly().points()[pointi]);
            std::copy_n(components.data(), dim, v.U);
        }
    );

    // A processor may hold a node of a patch without a face of the patch
    if (Pstream::parRun())
    {
        forAll(prescribed_, i)
        {
            shared_[prescribed_[i]] = values_[i];
        }
        static_assert(sizeof(prescription) == 5*sizeof(double), "no gaps");
        mesh.exchange().max(&shared_.data()->p, 5, 5);
        forAll(prescribed_, i)
        {
            values_[i] = shared_[prescribed_[i]];
        }
    }
}


template<int dim>
typename Foam::gasBoundary<dim>::State
Foam::gasBoundary<dim>::withPrescribed
(
    const prescription& v,
    const State& s
) const
{
    Vec U = gasDynamics::velocity<dim>(s);
    double p = gasDynamics::pressure<dim>(eos_, s);
    double T = eos_.temperature(p, s[0]);
    if (v.p > -GREAT) p = v.p;
    if (v.T > -GREAT) T = v.T;
    if (v.U[0] > -GREAT) U = Eigen::Map<const Vec>(v.U);
    return gasDynamics::conserved<dim>(eos_, eos_.density(p, T), U, p);
}


template<int dim>
void Foam::gasBoundary<dim>::beginStep
(
    const gasRows& states,
    const scalar start,
    const scalar dt
)
{
    for (farFieldPatch<dim>& flow : farFlow_)
    {
        if (flow.varies())
        {
            flow.readOuterStates(start + 0.5*dt);
        }
        flow.beginStep(states, dt);
    }
    if (!hasPrescribed_)
    {
        return;
    }
    evaluatePrescribed(start + dt);
    forAll(prescribed_, i)
    {
        if (isComplete(values_[i]))
        {
            const State s =
                Eigen::Map<const State>(states[prescribed_[i]].v);
            prescribedRate_[i] = (withPrescribed(values_[i], s) - s)/dt;
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::endStep(const gasRows& states, const scalar dt)
{
    for (farFieldPatch<dim>& flow : farFlow_)
    {
        flow.endStep(states, dt);
    }
}


template<int dim>
void Foam::gasBoundary<dim>::impose(gasRows& states)
{
    forAll(prescribed_, i)
    {
        Eigen::Map<State> s(states[prescribed_[i]].v);
        s = withPrescribed(values_[i], s);
    }
    noSlip_.update(U_, T_);
    constrainAtWalls(states);
    holdWallTemperatures(states);
}


template<int dim>
void Foam::gasBoundary<dim>::setZeroWherePrescribed(gasRows& rows) const
{
    forAll(prescribed_, i)
    {
        if (isComplete(values_[i]))
        {
            rows[prescribed_[i]] = uniformRow(0);
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::constrainDifferences(gasRows& rows) const
{
    setZeroWherePrescribed(rows);
    constrainAtWalls(rows);
}


template<int dim>
void Foam::gasBoundary<dim>::constrainRates
(
    gasRows& rates,
    const double duration
) const
{
    forAll(prescribed_, i)
    {
        if (isComplete(values_[i]))
        {
            Eigen::Map<State>(rates[prescribed_[i]].v) =
                duration*prescribedRate_[i];
        }
    }
    constrainAtWalls(rates);
    holdWallTemperatures(rates);
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
