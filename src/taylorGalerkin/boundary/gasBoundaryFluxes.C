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
            forces[a] += 0.5*(pressures[a] + pressures[b])*facet.M[a][b];
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
    for (const fePatch* patch : walls_)
    {
        const label number = geometry_.patchNumber(*patch);
        forAll(patch->facetSimplex, i)
        {
            const label* nodes = &patch->facets[dim*i];
            const auto& facet = geometry_.facet(number, i);
            double p[dim];
            Vec force[dim];
            for (int b = 0; b < dim; ++b)
            {
                p[b] = states[nodes[b]][pressure] - pRef;
            }
            facetForces(p, facet, force);

            for (int a = 0; a < dim; ++a)
            {
                gasRow& row = sum[nodes[a]];
                for (int k = 0; k < dim; ++k)
                {
                    row[1 + k] -= dt*force[a][k];
                }
                if (geometry_.moving())
                {
                    // The work is that of the whole pressure
                    for (int b = 0; b < dim; ++b)
                    {
                        force[a] += pRef*facet.M[a][b];
                    }
                    row[dim + 1] -= dt*force[a].dot(geometry_.w(nodes[a]));
                }
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
    for (const fePatch* patch : open_)
    {
        const label number = geometry_.patchNumber(*patch);
        forAll(patch->facetSimplex, i)
        {
            const label* nodes = &patch->facets[dim*i];
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
                double swept = 0;
                for (int b = 0; b < dim; ++b)
                {
                    const Vec S = 0.5*facet.M[a][b];
                    f += flux(a, S) + flux(b, S);
                    swept += geometry_.w(nodes[b]).dot(facet.M[a][b]);
                }
                Eigen::Map<State> row(sum[nodes[a]].v);
                row -= dt*f;
                if (geometry_.moving())
                {
                    row += dt*swept
                       *Eigen::Map<const State>(states[nodes[a]].v);
                }
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
    forAll(farField_, patchi)
    {
        const fePatch& patch = *farField_[patchi];
        const label number = geometry_.patchNumber(patch);
        forAll(patch.facetSimplex, i)
        {
            const label* nodes = &patch.facets[dim*i];
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
                State f = gasDynamics::hllcFlux<dim>
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
void Foam::gasBoundary<dim>::halfStepFluxes
(
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt,
    gasRows& sum
) const
{
    for (const label node : boundaryNodes_)
    {
        sum[node] = uniformRow(0);
        gasRow& half = half_[node];
        half = state.rows[node];
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
}


template<int dim>
void Foam::gasBoundary<dim>::addHoop
(
    const gasState<dim>& state,
    const double dt,
    gasRows& sum
) const
{
    const double* hoop = geometry_.hoop();
    if (!hoop)
    {
        return;
    }
    const feMesh& mesh = geometry_.mesh();
    for (label a = 0; a < mesh.nNodes(); ++a)
    {
        if (mesh.exchange().owned(a))
        {
            sum[a][1 + geometry_.radial()] +=
                dt*hoop[a]*(state.p(a) - state.pRef);
        }
    }
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
