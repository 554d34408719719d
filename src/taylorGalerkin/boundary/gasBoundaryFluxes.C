/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasBoundary.H"

template<int dim>
void Foam::gasBoundary<dim>::facetForces
(
    const double* pressures,
    const Vec& area,
    Vec* forces
)
{
    double sum = 0;
    for (int b = 0; b < dim; ++b)
    {
        sum += pressures[b];
    }
    for (int a = 0; a < dim; ++a)
    {
        forces[a] = (sum + pressures[a])/(dim*(dim + 1))*area;
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addWallFluxes
(
    const std::vector<double>& wallP,
    const double dt,
    std::vector<State>& residual
) const
{
    const double* p = wallP.data();
    for (const fePatch* patch : walls_)
    {
        forAll(patch->facetSimplex, i)
        {
            Vec force[dim];
            facetForces(p, geometry_.facetArea(*patch, i), force);
            p += dim;

            for (int a = 0; a < dim; ++a)
            {
                const label node = patch->facets[dim*i + a];
                State& r = residual[node];
                r.template segment<dim>(1) -= dt*force[a];
                if (geometry_.moving())
                {
                    r[dim + 1] -= dt*force[a].dot(geometry_.w(node));
                }
            }
        }
    }
}


template<int dim>
template<class NodeFlux>
void Foam::gasBoundary<dim>::addFacetFlux
(
    const fePatch& patch,
    const label facei,
    const NodeFlux& nodeFlux,
    const double dt,
    std::vector<State>& residual
) const
{
    const label* nodes = &patch.facets[dim*facei];
    const Vec S = geometry_.facetArea(patch, facei)/(dim*(dim + 1));

    State sum = State::Zero();
    State own[dim];
    for (int b = 0; b < dim; ++b)
    {
        own[b] = nodeFlux(nodes[b], S);
        sum += own[b];
    }
    for (int a = 0; a < dim; ++a)
    {
        residual[nodes[a]] -= dt*(sum + own[a]);
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addFarFieldFluxes
(
    const gasState<dim>& state,
    const double dt,
    std::vector<State>& residual
) const
{
    forAll(farField_, patchi)
    {
        const fePatch& patch = *farField_[patchi];
        auto flux = [&](const label node, const Vec& S)
        {
            return gasDynamics::hllcFlux<dim>
            (
                eos_,
                state.U[node],
                outer_[patchi][findLower(patch.nodes, node + 1)],
                S,
                nodeVelocity(node)
            );
        };
        forAll(patch.facetSimplex, i)
        {
            addFacetFlux(patch, i, flux, dt, residual);
        }
    }
}


template<int dim>
void Foam::gasBoundary<dim>::addOpenFluxes
(
    const gasState<dim>& state,
    const double dt,
    std::vector<State>& residual
) const
{
    auto flux = [&](const label node, const Vec& S)
    {
        return gasDynamics::fluxThrough<dim>
        (
            state.U[node], state.p[node], S, nodeVelocity(node)
        );
    };
    for (const fePatch* patch : open_)
    {
        forAll(patch->facetSimplex, i)
        {
            addFacetFlux(*patch, i, flux, dt, residual);
        }
    }
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
