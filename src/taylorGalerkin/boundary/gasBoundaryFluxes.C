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
        forAll(patch.facetSimplex, i)
        {
            const Vec S = geometry_.facetArea(patch, i)/(dim*(dim + 1));
            State sum = State::Zero();
            State own[dim];
            for (int b = 0; b < dim; ++b)
            {
                const label node = patch.facets[dim*i + b];
                const label local = findLower(patch.nodes, node + 1);
                const Vec w =
                    geometry_.moving()
                  ? Vec(geometry_.w(node)) : Vec(Vec::Zero());
                own[b] = gasDynamics::hllcFlux<dim>
                (
                    eos_, state.U[node], outer_[patchi][local], S, w
                );
                sum += own[b];
            }
            for (int a = 0; a < dim; ++a)
            {
                residual[patch.facets[dim*i + a]] -= dt*(sum + own[a]);
            }
        }
    }
}


template class Foam::gasBoundary<1>;
template class Foam::gasBoundary<2>;
template class Foam::gasBoundary<3>;
