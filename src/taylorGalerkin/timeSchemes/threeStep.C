/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "threeStep.H"
#include "dictionaryCheck.H"

template<int dim>
Foam::threeStep<dim>::threeStep(const dictionary& coeffs)
:
    theta_(coeffs.getOrDefault<scalar>("theta", 0.5)),
    updatedEnergyFlux_(true)
{
    checkKeywords(coeffs, {"theta", "energyFlux"});
    if (coeffs.found("energyFlux"))
    {
        updatedEnergyFlux_ =
            selectEntry(coeffs, "energyFlux", {"updated", "printed"}) == 0;
    }
    if (theta_ < 0.5 || theta_ > 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "theta is " << theta_ << ", but must be between 0.5 and 1"
            << exit(FatalIOError);
    }
}


template<int dim>
void Foam::threeStep<dim>::addMomentum
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt
)
{
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        const label* nodes = geometry.nodes(s);
        const auto& B0 = geometry.areas(s);
        const Vec w = geometry.moving() ? geometry.meanW(s) : Vec::Zero();

        gasDynamics::Flux<dim> F = gasDynamics::Flux<dim>::Zero();
        State mean = State::Zero();
        State divergence = State::Zero();
        Vec velocity = Vec::Zero();
        for (int a = 0; a <= dim; ++a)
        {
            const label i = nodes[a];
            const auto Fa =
                gasDynamics::eulerFlux<dim>(state.U[i], state.p[i]);
            F += Fa;
            mean += state.U[i];
            velocity += state.velocity[i];
            divergence += Fa*B0.col(a) - w.dot(B0.col(a))*state.U[i];
        }
        F /= dim + 1;
        mean /= dim + 1;
        velocity /= dim + 1;
        divergence /= geometry.volume(s);
        divergence_[s] = divergence;

        // (G17): the second-order term convects with the velocity relative
        // to the mesh
        const auto& B = geometry.stepAreas(s);
        F -= mean*w.transpose();
        F -= 0.5*dt*divergence*(velocity - w).transpose();
        for (int a = 0; a <= dim; ++a)
        {
            residual_[nodes[a]].template segment<dim>(1) +=
                dt*(F*B.col(a)).template segment<dim>(1);
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::addDensity
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt
)
{
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        const label* nodes = geometry.nodes(s);
        const auto& B = geometry.stepAreas(s);

        Vec flux = Vec::Zero();
        double rho = 0;
        for (int a = 0; a <= dim; ++a)
        {
            flux += massFlux_[nodes[a]];
            rho += state.U[nodes[a]][0];
        }
        flux /= dim + 1;
        if (geometry.moving())
        {
            const double half = rho/(dim + 1) - 0.5*dt*divergence_[s][0];
            flux -= half*geometry.meanW(s);
        }
        for (int a = 0; a <= dim; ++a)
        {
            residual_[nodes[a]][0] += dt*flux.dot(B.col(a));
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::addEnergy
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt
)
{
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        const label* nodes = geometry.nodes(s);
        const auto& B = geometry.stepAreas(s);
        const Vec w = geometry.moving() ? geometry.meanW(s) : Vec::Zero();

        Vec flux = Vec::Zero();
        Vec velocity = Vec::Zero();
        double energy = 0;
        for (int a = 0; a <= dim; ++a)
        {
            const label i = nodes[a];
            flux += (state.U[i][dim + 1] + state.p[i])*carrier_[i];
            velocity += state.velocity[i];
            energy += state.U[i][dim + 1];
        }
        flux -= energy*w;
        flux -= 0.5*dt*divergence_[s][dim + 1]*(velocity - (dim + 1)*w);
        flux /= dim + 1;
        for (int a = 0; a <= dim; ++a)
        {
            residual_[nodes[a]][dim + 1] += dt*flux.dot(B.col(a));
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::addBoundary
(
    const gasBoundary<dim>& boundary,
    const gasState<dim>& state,
    const double dt
)
{
    std::vector<double> wallP;
    for (const fePatch* patch : boundary.walls())
    {
        for (const label node : patch->facets)
        {
            wallP.push_back(state.p[node]);
        }
    }
    boundary.addWallFluxes(wallP, dt, residual_);
    boundary.addFarFieldFluxes(state, dt, residual_);
    boundary.addOpenFluxes(state, dt, residual_);
}


template<int dim>
void Foam::threeStep<dim>::step
(
    const gasGeometry<dim>& geometry,
    gasBoundary<dim>& boundary,
    gasState<dim>& state,
    const double dt
)
{
    const label nNodes = geometry.nNodes();
    residual_.assign(nNodes, State::Zero());
    divergence_.resize(geometry.nSimplices());
    massFlux_.resize(nNodes);
    carrier_.resize(nNodes);

    addBoundary(boundary, state, dt);

    // Momentum, with the walls' normal velocity, so that the density step
    // sees no flux through them
    addMomentum(geometry, state, dt);
    newU_ = state.U;
    auto advance = [&](const label a, const int k)
    {
        newU_[a][k] =
            (geometry.nodeVolume(a)*state.U[a][k] + residual_[a][k])
           /geometry.newNodeVolume(a);
    };
    for (label a = 0; a < nNodes; ++a)
    {
        for (int i = 0; i < dim; ++i)
        {
            advance(a, 1 + i);
        }
    }
    boundary.constrainMomentum(newU_);

    for (label a = 0; a < nNodes; ++a)
    {
        const Vec m = state.U[a].template segment<dim>(1);
        const Vec mNew = newU_[a].template segment<dim>(1);
        massFlux_[a] = m + theta_*(mNew - m);
    }
    addDensity(geometry, state, dt);
    for (label a = 0; a < nNodes; ++a)
    {
        advance(a, 0);
        carrier_[a] =
            updatedEnergyFlux_
          ? Vec(newU_[a].template segment<dim>(1)/newU_[a][0])
          : state.velocity[a];
    }

    addEnergy(geometry, state, dt);
    for (label a = 0; a < nNodes; ++a)
    {
        advance(a, dim + 1);
    }

    // Artificial diffusion acts on the advanced state, eq. (9) of the paper
    residual_.assign(nNodes, State::Zero());
    for (label s = 0; s < geometry.nSimplices(); ++s)
    {
        if (state.mu[s] != 0)
        {
            const auto F = (dt*this->artificialFlux(geometry, state, s)).eval();
            for (int a = 0; a <= dim; ++a)
            {
                residual_[geometry.nodes(s)[a]] -=
                    F*geometry.stepAreas(s).col(a);
            }
        }
    }
    for (label a = 0; a < nNodes; ++a)
    {
        state.U[a] = newU_[a] + residual_[a]/geometry.newNodeVolume(a);
    }
}


template class Foam::threeStep<1>;
template class Foam::threeStep<2>;
template class Foam::threeStep<3>;
