/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
//  What the boundary gives the gas, patch by patch, for a gasAccount

#include "gasBoundary.H"
#include "HashSet.H"

template<int dim>
void Foam::gasBoundary<dim>::setAccount(gasAccount* account)
{
    account_ = account;
    if (!account || accountNodes_.size())
    {
        return;
    }
    DynamicList<label> nodes(boundaryNodes_);
    const labelHashSet known(boundaryNodes_);
    for (label a = 0; geometry_.curvature() && a < geometry_.nNodes(); ++a)
    {
        if (geometry_.position(a)[geometry_.radial()] == 0 && !known.found(a))
        {
            nodes.append(a);
        }
    }
    accountNodes_.transfer(nodes);
}


template<int dim>
Foam::gasTotals Foam::gasBoundary<dim>::totalsOf(const State& s) const
{
    return gasTotals
    {
        s[0],
        geometry_.mesh().template fullVector<dim>
        (
            Vec(s.template segment<dim>(1))
        ),
        s[dim + 1]
    };
}


template<int dim>
void Foam::gasBoundary<dim>::enterThrough
(
    const fePatch& patch,
    const double pRef,
    const double dt,
    gasRows& sum
) const
{
    // The same sums as sumFluxes', of one patch
    const double less = dt*(pRef - account_->ambient());
    State entered = State::Zero();
    for (const auto& node : geometry_.surface(patch).nodes())
    {
        if (!geometry_.active().asleep(node.a))
        {
            entered += dt*Eigen::Map<const State>(sum[node.a].v);
        }
        entered.template segment<dim>(1) -= less*node.S;
        sum[node.a] = uniformRow(0);
    }
    account_->enter(geometry_.patchNumber(patch), totalsOf(entered));
}


template<int dim>
void Foam::gasBoundary<dim>::accountFluxes
(
    const gasRows& states,
    const double pRef,
    const double dt
) const
{
    if (!account_)
    {
        return;
    }
    // Zero between patches: enterThrough leaves it so
    gasRows& sum = entering_;
    sum.resize(states.size(), uniformRow(0));
    for (const fePatch* patch : walls_)
    {
        addWallFluxes(*patch, states, pRef, sum);
        enterThrough(*patch, pRef, dt, sum);
    }
    for (const fePatch* patch : open_)
    {
        addOpenFluxes(*patch, states, pRef, sum);
        enterThrough(*patch, pRef, dt, sum);
    }
    for (const farFieldPatch<dim>& flow : farFlow_)
    {
        flow.addFluxes(states, pRef, sum);
        enterThrough(flow.patch(), pRef, dt, sum);
    }
}


template<int dim>
void Foam::gasBoundary<dim>::accountSources
(
    const gasState<dim>& state,
    const double dt
) const
{
    if (!account_ || !geometry_.hoop())
    {
        return;
    }
    State source = State::Zero();
    for (label a = 0; a < state.nNodes(); ++a)
    {
        if (geometry_.mesh().exchange().owned(a))
        {
            source[1 + geometry_.radial()] +=
                dt*geometry_.hoop()[a]*(state.p(a) - account_->ambient());
        }
    }
    account_->addSource(totalsOf(source));
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
