/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "twoStep.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::twoStep<dim>::twoStep(const dictionary& coeffs)
:
    consistent_(false),
    massIterations_(coeffs.getOrDefault<label>("massIterations", 3))
{
    checkKeywords(coeffs, {"massMatrix", "massIterations"});
    if (coeffs.found("massMatrix"))
    {
        consistent_ =
            selectEntry(coeffs, "massMatrix", {"lumped", "consistent"}) == 1;
    }
    if (massIterations_ < 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "massIterations must be at least 1, not " << massIterations_
            << exit(FatalIOError);
    }
}


template<int dim>
typename Foam::twoStep<dim>::State Foam::twoStep<dim>::halfStep
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const label s,
    const double dt,
    State& mean
) const
{
    const label* nodes = geometry.nodes(s);
    const auto& B = geometry.areas(s);

    mean = State::Zero();
    State divergence = State::Zero();
    for (int a = 0; a <= dim; ++a)
    {
        mean += state.U[nodes[a]];
        divergence += nodeFlux_[nodes[a]]*B.col(a);
    }
    mean /= dim + 1;

    if (geometry.moving())
    {
        const Vec w = geometry.meanW(s);
        for (int a = 0; a <= dim; ++a)
        {
            divergence -= w.dot(B.col(a))*state.U[nodes[a]];
        }
    }
    return mean - 0.5*dt/geometry.volume(s)*divergence;
}


template<int dim>
void Foam::twoStep<dim>::addInterior
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt
)
{
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        State mean;
        const State half = halfStep(geometry, state, s, dt, mean);
        const double p = gasDynamics::pressure<dim>(state.eos, half);
        if (!(half[0] > 0 && p > 0))
        {
            throw unphysicalSimplex{s, half[0], p};
        }

        gasDynamics::Flux<dim> F = gasDynamics::eulerFlux<dim>(half, p);
        if (geometry.moving())
        {
            F -= half*geometry.meanW(s).transpose();
        }
        const label* nodes = geometry.nodes(s);
        if (state.mu[s] != 0)
        {
            F -= this->artificialFlux(geometry, state, s);
        }
        F *= dt;

        const auto& B = geometry.stepAreas(s);
        for (int a = 0; a <= dim; ++a)
        {
            residual_[nodes[a]] += F*B.col(a);
        }
    }
}


template<int dim>
void Foam::twoStep<dim>::addBoundary
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    const gasState<dim>& state,
    const double dt
)
{
    // Wall pressure at the half step: the node's, changed in the ratio in
    // which the simplex behind changes, eq. (G16)
    wallP_.clear();
    for (const fePatch* patch : boundary.walls())
    {
        forAll(patch->facetSimplex, i)
        {
            State mean;
            const State half =
                halfStep(geometry, state, patch->facetSimplex[i], dt, mean);
            const double ratio =
                gasDynamics::pressure<dim>(state.eos, half)
               /gasDynamics::pressure<dim>(state.eos, mean);
            for (int b = 0; b < dim; ++b)
            {
                wallP_.push_back(ratio*state.p[patch->facets[dim*i + b]]);
            }
        }
    }
    boundary.addWallFluxes(wallP_, dt, residual_);
    boundary.addFarFieldFluxes(state, dt, residual_);
    boundary.addOpenFluxes(state, dt, residual_);
}


template<int dim>
template<class Volume>
void Foam::twoStep<dim>::addMassTerm
(
    const gasGeometry<dim>& geometry,
    const std::vector<State>& U,
    const Volume& volume,
    const double sign
)
{
    const double c = sign/((dim + 1)*(dim + 2));
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        const label* nodes = geometry.nodes(s);
        State sum = State::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            sum += U[nodes[a]];
        }
        for (int a = 0; a <= dim; ++a)
        {
            massTerm_[nodes[a]] += c*volume(s)*(sum + U[nodes[a]]);
        }
    }
}


template<int dim>
void Foam::twoStep<dim>::solveConsistent
(
    const gasGeometry<dim>& geometry,
    gasState<dim>& state
)
{
    oldU_ = state.U;
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        state.U[a] =
            (geometry.nodeVolume(a)*oldU_[a] + residual_[a])
           /geometry.newNodeVolume(a);
    }
    for (label pass = 1; pass < massIterations_; ++pass)
    {
        massTerm_ = residual_;
        auto before = [&](const label s) { return geometry.volume(s); };
        auto after = [&](const label s) { return geometry.newVolume(s); };
        addMassTerm(geometry, oldU_, before, 1);
        addMassTerm(geometry, state.U, after, -1);
        for (label a = 0; a < geometry.nNodes(); ++a)
        {
            state.U[a] += massTerm_[a]/geometry.newNodeVolume(a);
        }
    }
}


template<int dim>
void Foam::twoStep<dim>::step
(
    const gasGeometry<dim>& geometry,
    gasBoundary<dim>& boundary,
    gasState<dim>& state,
    const double dt
)
{
    const label nNodes = geometry.nNodes();
    residual_.assign(nNodes, State::Zero());
    nodeFlux_.resize(nNodes);
    for (label a = 0; a < nNodes; ++a)
    {
        nodeFlux_[a] = gasDynamics::eulerFlux<dim>(state.U[a], state.p[a]);
    }

    addInterior(geometry, state, dt);
    addBoundary(geometry, boundary, state, dt);

    if (consistent_)
    {
        solveConsistent(geometry, state);
    }
    else
    {
        for (label a = 0; a < nNodes; ++a)
        {
            state.U[a] =
                (geometry.nodeVolume(a)*state.U[a] + residual_[a])
               /geometry.newNodeVolume(a);
        }
    }
}


template class Foam::twoStep<1>;
template class Foam::twoStep<2>;
template class Foam::twoStep<3>;
