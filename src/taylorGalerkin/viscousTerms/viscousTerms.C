/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "viscousTerms.H"

template<int dim>
Foam::viscousTerms<dim>::viscousTerms
(
    const gasDynamics::Transport& transport,
    const List<const fePatch*>& open,
    const List<const fePatch*>& farField
)
:
    transport_(transport),
    open_(open)
{
    open_.append(farField);
}


template<int dim>
Foam::simplexTerms<dim> Foam::viscousTerms<dim>::terms
(
    const gasGeometry<dim>& geometry,
    const label simplexi
) const
{
    const feMesh& mesh = geometry.mesh();
    const label* corner = mesh.simplexCorners().cdata() + (dim + 1)*simplexi;
    Vec x[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        x[a] = mesh.components<dim>(mesh.corners()[corner[a]]);
        if (geometry.moving())
        {
            x[a] += geometry.halfMove(mesh.nodeOfCorner(corner[a]));
        }
    }
    return simplexTerms<dim>(x, geometry.curvature(), geometry.radial());
}


template<int dim>
Foam::simplexViscosity<dim> Foam::viscousTerms<dim>::viscosity
(
    const gasGeometry<dim>& geometry,
    const simplexTerms<dim>& terms,
    const label simplexi
) const
{
    const label* node =
        geometry.mesh().simplices().cdata() + (dim + 1)*simplexi;
    Vec U[dim + 1];
    double T[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        U[a] = values_[node[a]].U;
        T[a] = values_[node[a]].T;
    }
    return
        simplexViscosity<dim>(terms, geometry.radial(), transport_, U, T);
}


template<int dim>
void Foam::viscousTerms<dim>::setValues
(
    const gasState<dim>& state,
    const gasRows* rate,
    const double dt
)
{
    using State = gasDynamics::State<dim>;
    values_.resize(state.nNodes());
    for (label a = 0; a < state.nNodes(); ++a)
    {
        State s(state.conserved(a));
        if (rate)
        {
            const State half
            (
                s + 0.5*dt*Eigen::Map<const State>((*rate)[a].v)
            );
            if (gasDynamics::isPhysical<dim>(state.eos, half))
            {
                s = half;
            }
        }
        const double p = gasDynamics::pressure<dim>(state.eos, s);
        values_[a].U = gasDynamics::velocity<dim>(s);
        values_[a].T = state.eos.temperature(p, s[0]);
    }
}


template<int dim>
void Foam::viscousTerms<dim>::addTerms
(
    const gasGeometry<dim>& geometry,
    const double factor,
    gasRows& sum,
    double* nodal
) const
{
    const feMesh& mesh = geometry.mesh();
    const int radial = geometry.radial();
    const double depth = mesh.depth();
    const double scale = factor*depth;
    for (label s = 0; s < mesh.nSimplices(); ++s)
    {
        const simplexTerms<dim> t(terms(geometry, s));
        const simplexViscosity<dim> v(viscosity(geometry, t, s));
        const label* node = mesh.simplices().cdata() + (dim + 1)*s;
        for (int a = 0; a <= dim; ++a)
        {
            const Vec f(scale*v.force(t, radial, a));
            gasRow& row = sum[node[a]];
            for (int k = 0; k < dim; ++k)
            {
                row[1 + k] += f[k];
            }
            row[dim + 1] += scale*v.heating(t, a);
            if (nodal)
            {
                nodal[node[a]] +=
                    depth*v.mu*simplexViscosity<dim>::halfRow(t, a);
            }
        }
    }
    addOpenTerms(geometry, factor, sum);
}


template<int dim>
void Foam::viscousTerms<dim>::addOpenTerms
(
    const gasGeometry<dim>& geometry,
    const double factor,
    gasRows& sum
) const
{
    for (const fePatch* patch : open_)
    {
        const label number = geometry.patchNumber(*patch);
        forAll(patch->facetSimplex, i)
        {
            const label s = patch->facetSimplex[i];
            const simplexViscosity<dim> v
            (
                viscosity(geometry, terms(geometry, s), s)
            );
            const auto& facet = geometry.facet(number, i);
            for (int a = 0; a < dim; ++a)
            {
                Vec S = Vec::Zero();
                for (int b = 0; b < dim; ++b)
                {
                    S += facet.M[a][b];
                }
                const Vec f(factor*(v.stress*S));
                gasRow& row = sum[patch->facets[dim*i + a]];
                for (int k = 0; k < dim; ++k)
                {
                    row[1 + k] += f[k];
                }
                row[dim + 1] += factor*v.power.dot(S);
            }
        }
    }
}


template<int dim>
void Foam::viscousTerms<dim>::correct
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    setValues(state, nullptr, 0);
    present_.assign(geometry.nRows(), uniformRow(0));
    nodal_.assign(geometry.nRows(), 0.0);
    addTerms(geometry, 1, present_, nodal_.data());

    // Diffusivities over mu/rho: of the deviator of a symmetric gradient (or of
    // one along a line), and of internal energy
    const double shear = dim > 1 || geometry.curvature() ? 2 : 4.0/3;
    const double conduction = transport_.kappaOverMu()/state.eos.Cv();
    const double perMu = std::max(shear, conduction);
    geometry.mesh().exchange().sum(nodal_.data(), 1, 1);
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        nodal_[a] *= perMu/state.rho(a);
    }
}


template<int dim>
void Foam::viscousTerms<dim>::addPresent(gasRows& sum) const
{
    for (std::size_t a = 0; a < present_.size(); ++a)
    {
        for (int k = 1; k <= dim + 1; ++k)
        {
            sum[a][k] += present_[a][k];
        }
    }
}


template<int dim>
void Foam::viscousTerms<dim>::addHalfStep
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt,
    gasRows& sum
)
{
    setValues(state, &rate, dt);
    addTerms(geometry, dt, sum);
}


template<int dim>
void Foam::viscousTerms<dim>::addExcess
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt,
    gasRows& sum
)
{
    excess_.assign(geometry.nRows(), uniformRow(0));
    addHalfStep(geometry, state, rate, dt, excess_);
    for (std::size_t a = 0; a < present_.size(); ++a)
    {
        for (int k = 1; k <= dim + 1; ++k)
        {
            excess_[a][k] -= dt*present_[a][k];
        }
    }
    geometry.mesh().exchange().sum
    (
        data(excess_) + 1, gasKernel::rowSize, dim + 1
    );
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        for (int k = 1; k <= dim + 1; ++k)
        {
            sum[a][k] += excess_[a][k];
        }
    }
}


template class Foam::viscousTerms<1>;
template class Foam::viscousTerms<2>;
template class Foam::viscousTerms<3>;
