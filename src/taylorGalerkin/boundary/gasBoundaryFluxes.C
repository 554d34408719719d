/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasBoundary.H"

template<int dim>
void Foam::gasBoundary<dim>::facetForces
(
    const double* pressures,
    const typename gasGeometry<dim>::facetIntegrals& facet,
    Vec* forces
)
{
    for (int a = 0; a < dim; ++a)
    {
        forces[a] = Vec::Zero();
        for (int b = 0; b < dim; ++b)
        {
            forces[a] += pressures[b]*facet.M[a][b];
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addWallFluxes
(
    const gasRows& states,
    const double pRef,
    const double dt,
    gasRows& sum
) const
{
    constexpr int pressure = gasKernel::place<dim>::p;
    const activeParts& active = geometry_.active();
    for (const fePatch* patch : walls_)
    {
        const label number = geometry_.patchNumber(*patch);
        forAll(patch->facetSimplex, i)
        {
            const label* nodes = &patch->facets[dim*i];
            if (active.asleep(nodes, dim))
            {
                continue;
            }
            const auto& facet = geometry_.facet(number, i);
            double p[dim];
            for (int b = 0; b < dim; ++b)
            {
                p[b] = states[nodes[b]][pressure];
            }
            for (int a = 0; a < dim; ++a)
            {
                // The momentum's flux closes the dual volumes, (G16)
                Vec force = Vec::Zero();
                double work = 0;
                for (int b = 0; b < dim; ++b)
                {
                    const Vec& M = facet.M[a][b];
                    force += (0.5*(p[a] + p[b]) - pRef)*M;
                    if (geometry_.moving())
                    {
                        const Vec& wa = geometry_.w(nodes[a]);
                        const Vec& wb = geometry_.w(nodes[b]);
                        work +=
                            p[b]*M.dot(wa)
                          - 0.25*(p[b] - p[a])*M.dot(wa + wb);
                    }
                }
                gasRow& row = sum[nodes[a]];
                for (int k = 0; k < dim; ++k)
                {
                    row[1 + k] -= dt*force[k];
                }
                row[dim + 1] -= dt*work;
            }
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addOpenFluxes
(
    const gasRows& states,
    const double pRef,
    const double dt,
    gasRows& sum
) const
{
    constexpr int pressure = gasKernel::place<dim>::p;
    const activeParts& active = geometry_.active();
    for (const fePatch* patch : open_)
    {
        const label number = geometry_.patchNumber(*patch);
        forAll(patch->facetSimplex, i)
        {
            const label* nodes = &patch->facets[dim*i];
            if (active.asleep(nodes, dim))
            {
                continue;
            }
            const auto& facet = geometry_.facet(number, i);

            auto flux = [&](const int b, const Vec& S) -> State
            {
                const gasRow& row = states[nodes[b]];
                const Eigen::Map<const State> s(row.v);
                const Vec U = gasDynamics::velocity<dim>(s);
                State f = s*U.dot(S);
                f.template segment<dim>(1) += (row[pressure] - pRef)*S;
                f[dim + 1] += row[pressure]*U.dot(S);
                return f;
            };

            for (int a = 0; a < dim; ++a)
            {
                State f = State::Zero();
                for (int b = 0; b < dim; ++b)
                {
                    const Vec S = 0.5*facet.M[a][b];
                    f += flux(a, S) + flux(b, S);
                    if (geometry_.moving())
                    {
                        // Exact for uniform gas whatever the motion
                        const double swept = geometry_.w(nodes[b]).dot(S);
                        f -= swept*Eigen::Map<const State>(states[nodes[a]].v);
                        f -= swept*Eigen::Map<const State>(states[nodes[b]].v);
                    }
                }
                Eigen::Map<State>(sum[nodes[a]].v) -= dt*f;
            }
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addFarFieldFluxes
(
    const gasRows& states,
    const double pRef,
    const double dt,
    gasRows& sum
) const
{
    const activeParts& active = geometry_.active();
    forAll(farField_, patchi)
    {
        const fePatch& patch = *farField_[patchi];
        const label number = geometry_.patchNumber(patch);
        forAll(patch.facetSimplex, i)
        {
            const label* nodes = &patch.facets[dim*i];
            if (active.asleep(nodes, dim))
            {
                continue;
            }
            const auto& facet = geometry_.facet(number, i);
            for (int a = 0; a < dim; ++a)
            {
                Vec S = Vec::Zero();
                double swept = 0;
                for (int b = 0; b < dim; ++b)
                {
                    S += facet.M[a][b];
                    swept += facet.M[a][b].dot(geometry_.w(nodes[b]));
                }
                // The velocity along S that sweeps the same volume
                const Vec w = swept/S.squaredNorm()*S;
                State f = gasDynamics::farFieldFlux<dim>
                (
                    eos_, Eigen::Map<const State>(states[nodes[a]].v),
                    outer_[patchi][outerOf_[patchi][dim*i + a]], S, w
                );
                f.template segment<dim>(1) -= pRef*S;
                Eigen::Map<State>(sum[nodes[a]].v) -= dt*f;
            }
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addFluxes
(
    const gasRows& states,
    const double pRef,
    const double dt,
    gasRows& sum
) const
{
    addWallFluxes(states, pRef, dt, sum);
    addOpenFluxes(states, pRef, dt, sum);
    addFarFieldFluxes(states, pRef, dt, sum);
}


template<int dim>
void Foam::gasBoundary<dim>::closeForce
(
    const gasState<dim>& state,
    gasRows& rates
) const
{
    constexpr int force = gasKernel::place<dim>::force;
    const activeParts& active = geometry_.active();
    for (const auto* patches : {&walls_, &open_, &farField_})
    {
        for (const fePatch* patch : *patches)
        {
            const label number = geometry_.patchNumber(*patch);
            forAll(patch->facetSimplex, i)
            {
                const label* nodes = &patch->facets[dim*i];
                if (active.asleep(nodes, dim))
                {
                    continue;
                }
                const auto& facet = geometry_.facet(number, i);
                for (int a = 0; a < dim; ++a)
                {
                    for (int b = 0; b < dim; ++b)
                    {
                        const double mean =
                            0.5*(state.p(nodes[a]) + state.p(nodes[b]))
                          - state.pRef;
                        for (int k = 0; k < dim; ++k)
                        {
                            rates[nodes[a]][force + k] -=
                                mean*facet.M[a][b][k];
                        }
                    }
                }
            }
        }
    }
    const double* hoop = geometry_.hoop();
    for (label a = 0; hoop && a < state.nNodes(); ++a)
    {
        if (geometry_.mesh().exchange().owned(a))
        {
            rates[a][force + geometry_.radial()] +=
                hoop[a]*(state.p(a) - state.pRef);
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::halfStepFluxes
(
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt,
    gasRows& sum
) const
{
    if (state.hasGravity)
    {
        std::fill(sum.begin(), sum.end(), uniformRow(0));
    }
    for (const label node : boundaryNodes_)
    {
        gasRow& half = half_[node];
        half = state.rows[node];
        if (geometry_.active().asleep(node))
        {
            // May share a facet with nodes that are awake
            continue;
        }
        sum[node] = uniformRow(0);
        Eigen::Map<State> s(half.v);
        s += 0.5*dt*Eigen::Map<const State>(rate[node].v);
        const double p = gasDynamics::pressure<dim>(eos_, s);
        if (s[0] > 0 && p > 0)
        {
            half[gasKernel::place<dim>::p] = p;
        }
        else
        {
            // As where an edge has no half-step state
            half = state.rows[node];
        }
    }
    addFluxes(half_, state.pRef, dt, sum);
    addFluxes(state.rows, state.pRef, -dt, sum);
    geometry_.mesh().exchange().sum
    (
        data(sum), gasKernel::rowSize, gasKernel::place<dim>::nConserved
    );
    setZeroWherePrescribed(sum);
    if (state.hasGravity)
    {
        for (label a = 0; a < state.nNodes(); ++a)
        {
            addWeight(state, rate[a], 0.5*dt*dt*meanVolume(a), sum[a]);
        }
    }
}


template<int dim>
Foam::labelList Foam::gasBoundary<dim>::acting
(
    const gasState<dim>& state
) const
{
    // Fluxes of the states as they are and of half a step that changes nothing
    const gasRows rate(state.rows.size(), uniformRow(0));
    gasRows sum(rate), excess(rate);
    addFluxes(state.rows, state.pRef, 1, sum);
    halfStepFluxes(state, rate, 1, excess);

    DynamicList<label> nodes;
    for (const label node : boundaryNodes_)
    {
        bool acts = false;
        for (int k = 0; k < dim + 2; ++k)
        {
            acts = acts || sum[node][k] != 0 || excess[node][k] != 0;
        }
        if (acts)
        {
            nodes.append(node);
        }
    }

    // Values that may change with time
    for (const fePatch* patch : farField_)
    {
        if (outerVaries_)
        {
            nodes.append(patch->nodes);
        }
    }
    const auto& p = p_.boundaryField();
    const auto& U = U_.boundaryField();
    const auto& T = T_.boundaryField();
    auto mark = [&](const auto& field, const labelUList& patches)
    {
        for (const label patchi : patches)
        {
            if (field[patchi].type() != "fixedValue")
            {
                for (const label i : field[patchi].patch().meshPoints())
                {
                    nodes.append(geometry_.mesh().nodeOfPoint()[i]);
                }
            }
        }
    };
    mark(p, fixedP_);
    mark(U, fixedU_);
    mark(T, fixedT_);
    return labelList(std::move(nodes));
}


template<int dim>
void Foam::gasBoundary<dim>::addSources
(
    const gasState<dim>& state,
    const double dt,
    gasRows& sum
) const
{
    const double* hoop = geometry_.hoop();
    const sharedItems& exchange = geometry_.mesh().exchange();
    for
    (
        label a = 0;
        (hoop || state.hasGravity) && a < state.nNodes();
        ++a
    )
    {
        if (!exchange.owned(a))
        {
            continue;
        }
        if (hoop)
        {
            sum[a][1 + geometry_.radial()] +=
                dt*hoop[a]*(state.p(a) - state.pRef);
        }
        if (state.hasGravity)
        {
            addWeight(state, state.rows[a], dt*meanVolume(a), sum[a]);
        }
    }
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
