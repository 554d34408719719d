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
void Foam::gasBoundary<dim>::addForce
(
    const double pressure,
    const Vec& S,
    gasRow& sum
)
{
    for (int k = 0; k < dim; ++k)
    {
        sum[1 + k] -= pressure*S[k];
        sum[gasKernel::place<dim>::force + k] -= pressure*S[k];
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addFlux
(
    const gasRow& q,
    const double pRef,
    const Vec& S,
    gasRow& sum
)
{
    using place = gasKernel::place<dim>;
    double m = 0;
    for (int k = 0; k < dim; ++k)
    {
        m += q[1 + k]*S[k];
    }
    const double flux = m*q[place::specificVolume];
    for (int k = 0; k < place::nConserved; ++k)
    {
        sum[k] -= flux*q[k];
    }
    sum[place::energy] -= flux*q[place::p];
    addForce(q[place::p] - pRef, S, sum);
}


template<int dim>
void Foam::gasBoundary<dim>::addWallFluxes
(
    const fePatch& patch,
    const gasRows& states,
    const double pRef,
    gasRows& sum
) const
{
    constexpr int pressure = gasKernel::place<dim>::p;
    constexpr int energy = gasKernel::place<dim>::energy;
    const activeParts& active = geometry_.active();
    const bool moving = geometry_.moving();
    const patchSurface<dim>& surface = geometry_.surface(patch);
    for (const auto& node : surface.nodes())
    {
        if (active.asleep(node.a))
        {
            continue;
        }
        const double p = states[node.a][pressure];
        addForce(p - pRef, node.M, sum[node.a]);
        if (moving)
        {
            sum[node.a][energy] -= p*node.M.dot(geometry_.w(node.a));
        }
    }
    for (const auto& pair : surface.pairs())
    {
        if (active.asleep(pair.a) && active.asleep(pair.b))
        {
            continue;
        }
        // The momentum's flux closes the dual volumes, (G16)
        const double pa = states[pair.a][pressure];
        const double pb = states[pair.b][pressure];
        const double mean = 0.5*(pa + pb) - pRef;
        addForce(mean, pair.M, sum[pair.a]);
        addForce(mean, pair.M, sum[pair.b]);
        if (moving)
        {
            const double wa = pair.M.dot(geometry_.w(pair.a));
            const double wb = pair.M.dot(geometry_.w(pair.b));
            const double less = 0.25*(pb - pa)*(wa + wb);
            sum[pair.a][energy] -= pb*wa - less;
            sum[pair.b][energy] -= pa*wb + less;
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addOpenFluxes
(
    const fePatch& patch,
    const gasRows& states,
    const double pRef,
    gasRows& sum
) const
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    const activeParts& active = geometry_.active();
    const bool moving = geometry_.moving();
    const patchSurface<dim>& surface = geometry_.surface(patch);
    for (const auto& node : surface.nodes())
    {
        if (active.asleep(node.a))
        {
            continue;
        }
        addFlux(states[node.a], pRef, node.M, sum[node.a]);
        const double swept =
            moving ? node.M.dot(geometry_.w(node.a)) : 0;
        for (int k = 0; moving && k < n; ++k)
        {
            sum[node.a][k] += swept*states[node.a][k];
        }
    }
    for (const auto& pair : surface.pairs())
    {
        if (active.asleep(pair.a) && active.asleep(pair.b))
        {
            continue;
        }
        const gasRow& qa = states[pair.a];
        const gasRow& qb = states[pair.b];
        const Vec S = 0.5*pair.M;
        gasRow f = uniformRow(0);
        addFlux(qa, pRef, S, f);
        addFlux(qb, pRef, S, f);
        // Exact for uniform gas whatever the motion
        const double sweptA = moving ? S.dot(geometry_.w(pair.b)) : 0;
        const double sweptB = moving ? S.dot(geometry_.w(pair.a)) : 0;
        for (int k = 0; k < gasKernel::rowSize; ++k)
        {
            const double both = k < n ? qa[k] + qb[k] : 0;
            sum[pair.a][k] += f[k] + sweptA*both;
            sum[pair.b][k] += f[k] + sweptB*both;
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::sumFluxes
(
    const gasRows& states,
    const double pRef,
    gasRows& sum
) const
{
    for (const label node : boundaryNodes_)
    {
        sum[node] = uniformRow(0);
    }
    for (const fePatch* patch : walls_)
    {
        addWallFluxes(*patch, states, pRef, sum);
    }
    for (const fePatch* patch : open_)
    {
        addOpenFluxes(*patch, states, pRef, sum);
    }
    for (const farFieldPatch<dim>& flow : farFlow_)
    {
        flow.addFluxes(states, pRef, sum);
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addFluxes(const double dt, gasRows& sum) const
{
    for (const label node : boundaryNodes_)
    {
        if (geometry_.active().asleep(node))
        {
            continue;
        }
        for (int k = 0; k < gasKernel::rowSize; ++k)
        {
            sum[node][k] += dt*present_[node][k];
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
        Eigen::Map<State> s(half.v);
        s += 0.5*dt*Eigen::Map<const State>(rate[node].v);
        const double p = gasDynamics::pressure<dim>(eos_, s);
        if (s[0] > 0 && p > 0)
        {
            half[gasKernel::place<dim>::p] = p;
            half[gasKernel::place<dim>::specificVolume] = 1/s[0];
        }
        else
        {
            // As where an edge has no half-step state
            half = state.rows[node];
        }
    }
    sumFluxes(half_, state.pRef, sum);
    for (const label node : boundaryNodes_)
    {
        for (int k = 0; k < gasKernel::rowSize; ++k)
        {
            sum[node][k] = dt*(sum[node][k] - present_[node][k]);
        }
    }
    geometry_.mesh().exchange().sum
    (
        data(sum), gasKernel::rowSize, gasKernel::place<dim>::nConserved
    );
    accountHeld
    (
        [&](const label a) { return State(Eigen::Map<const State>(sum[a].v)); },
        [](const label) { return 1.0; },
        [&]() { setZeroWherePrescribed(sum); }
    );
    if (state.hasGravity)
    {
        for (label a = 0; a < state.nNodes(); ++a)
        {
            state.addWeight(rate[a], 0.5*dt*dt*meanVolume(a), sum[a]);
        }
    }
}


template<int dim>
template<class Visit>
void Foam::gasBoundary<dim>::forExcess
(
    const bool everywhere,
    const Visit& visit
) const
{
    if (everywhere)
    {
        for (label a = 0; a < geometry_.nNodes(); ++a)
        {
            visit(a);
        }
        return;
    }
    for (const label a : boundaryNodes_)
    {
        if (!geometry_.active().asleep(a))
        {
            visit(a);
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addExcess
(
    const gasRows& excess,
    const bool everywhere,
    const double dt,
    gasRows& rate
) const
{
    forExcess(everywhere, [&](const label a)
    {
        const double perVolume = 1/(dt*meanVolume(a));
        for (int k = 0; k < gasKernel::place<dim>::nConserved; ++k)
        {
            rate[a][k] += perVolume*excess[a][k];
        }
    });
}


template<int dim>
void Foam::gasBoundary<dim>::addExcessSums
(
    const gasRows& excess,
    const bool everywhere,
    gasRows& sum
) const
{
    forExcess(everywhere, [&](const label a)
    {
        for (int k = 0; k < gasKernel::place<dim>::nConserved; ++k)
        {
            sum[a][k] += excess[a][k];
        }
    });
}


template<int dim>
Foam::labelList Foam::gasBoundary<dim>::acting
(
    const gasState<dim>& state
) const
{
    // Fluxes of the states as they are and of half a step that changes nothing
    const gasRows rate(state.rows.size(), uniformRow(0));
    gasRows excess(rate);
    setFluxes(state);
    halfStepFluxes(state, rate, 1, excess);

    DynamicList<label> nodes;
    for (const label node : boundaryNodes_)
    {
        bool acts = false;
        for (int k = 0; k < dim + 2; ++k)
        {
            acts = acts || present_[node][k] != 0 || excess[node][k] != 0;
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
    for (label a = 0; hoop && a < state.nNodes(); ++a)
    {
        if (exchange.owned(a))
        {
            const double force = dt*hoop[a]*(state.p(a) - state.pRef);
            sum[a][1 + geometry_.radial()] += force;
            sum[a][gasKernel::place<dim>::force + geometry_.radial()] += force;
        }
    }
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
