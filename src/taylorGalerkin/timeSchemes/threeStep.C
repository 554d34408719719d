/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "threeStep.H"
#include "dictionaryCheck.H"

namespace
{

//- What an edge is to a flux: nodes, dual area, volume swept per time
template<int dim>
struct fluxEdge
{
    int i, j;
    Foam::simplexVec<dim> S;
    double sweep;

    fluxEdge(const gasKernel::edges& e, const std::size_t k)
    :
        i(e.first[k]),
        j(e.second[k]),
        sweep(e.sweep ? e.sweep[k] : 0)
    {
        for (int c = 0; c < dim; ++c)
        {
            S[c] = e.area[c][k];
        }
    }
};

} // End namespace


template<int dim>
Foam::threeStep<dim>::threeStep
(
    const dictionary& coeffs,
    const gasGeometry<dim>& geometry
)
:
    theta_(coeffs.getOrDefault<scalar>("theta", 0.5)),
    updatedEnergyFlux_(true),
    massFlux_(geometry.nRows(), Vec::Zero()),
    carrier_(geometry.nRows(), Vec::Zero()),
    residual_(geometry.nRows(), uniformRow(0)),
    newU_(geometry.nRows(), State::Zero())
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
void Foam::threeStep<dim>::advance
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const int from,
    const int to
)
{
    geometry.mesh().exchange().sum
    (
        data(residual_) + from, gasKernel::rowSize, to - from
    );
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        for (int k = from; k < to; ++k)
        {
            newU_[a][k] =
                (geometry.nodeVolume(a)*state.rows[a][k] + residual_[a][k])
               /geometry.newNodeVolume(a);
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::addMomentum
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt
)
{
    const gasKernel::edges edges = geometry.edges();
    for (label k = 0; k < geometry.nEdges(); ++k)
    {
        // (G17): the second-order term convects with the velocity relative
        // to the mesh
        const fluxEdge<dim> e(edges, k);
        const double ui = state.velocity(e.i).dot(e.S) - e.sweep;
        const double uj = state.velocity(e.j).dot(e.S) - e.sweep;
        const double p = 0.5*(state.p(e.i) + state.p(e.j)) - state.pRef;
        const double convected = 0.25*dt*0.5*(ui + uj);
        for (int c = 0; c < dim; ++c)
        {
            const int m = 1 + c;
            const double f = dt*
            (
                0.5*(ui*state.rows[e.i][m] + uj*state.rows[e.j][m])
              + p*e.S[c]
              + convected*(rate[e.i][m] + rate[e.j][m])
            );
            residual_[e.i][m] -= f;
            residual_[e.j][m] += f;
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::addDensity
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt
)
{
    const gasKernel::edges edges = geometry.edges();
    for (label k = 0; k < geometry.nEdges(); ++k)
    {
        const fluxEdge<dim> e(edges, k);
        const double rho =
            0.5*(state.rho(e.i) + state.rho(e.j))
          + 0.25*dt*(rate[e.i][0] + rate[e.j][0]);
        const double f = dt*
        (
            0.5*(massFlux_[e.i] + massFlux_[e.j]).dot(e.S) - e.sweep*rho
        );
        residual_[e.i][0] -= f;
        residual_[e.j][0] += f;
    }
}


template<int dim>
void Foam::threeStep<dim>::addEnergy
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const gasRows& rate,
    const double dt
)
{
    constexpr int E = dim + 1;
    const gasKernel::edges edges = geometry.edges();
    for (label k = 0; k < geometry.nEdges(); ++k)
    {
        const fluxEdge<dim> e(edges, k);
        const double relative =
            0.5*(state.velocity(e.i) + state.velocity(e.j)).dot(e.S) - e.sweep;
        auto carried = [&](const int a)
        {
            return
                (state.rows[a][E] + state.p(a))*carrier_[a].dot(e.S)
              - e.sweep*state.rows[a][E];
        };
        const double f = dt*
        (
            0.5*(carried(e.i) + carried(e.j))
          + 0.25*dt*relative*(rate[e.i][E] + rate[e.j][E])
        );
        residual_[e.i][E] -= f;
        residual_[e.j][E] += f;
    }
}


template<int dim>
void Foam::threeStep<dim>::addViscosity
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const std::vector<double>& nu,
    const double dt
)
{
    // Artificial diffusion acts on the advanced state, eq. (9) of the paper
    constexpr int n = gasKernel::place<dim>::nConserved;
    std::fill(residual_.begin(), residual_.end(), uniformRow(0));
    const gasKernel::edges edges = geometry.edges();
    for (label k = 0; k < geometry.nEdges(); ++k)
    {
        const int i = edges.first[k], j = edges.second[k];
        for (int c = 0; c < n; ++c)
        {
            const double f =
                dt*nu[k]*(state.rows[i][c] - state.rows[j][c]);
            residual_[i][c] -= f;
            residual_[j][c] += f;
        }
    }
    geometry.mesh().exchange().sum(data(residual_), gasKernel::rowSize, n);
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        for (int c = 0; c < n; ++c)
        {
            newU_[a][c] += residual_[a][c]/geometry.newNodeVolume(a);
        }
    }
}


template<int dim>
void Foam::threeStep<dim>::step
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    const shockCapturing<dim>& capturing,
    gasRates<dim>& rates,
    gasState<dim>& state,
    const double dt
)
{
    rates.compute(geometry, boundary, state, dt);

    // The walls' constraint on the new momentum takes the present density
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        newU_[a] = state.conserved(a);
    }
    std::fill(residual_.begin(), residual_.end(), uniformRow(0));
    boundary.addFluxes(dt, residual_);
    boundary.addSources(state, dt, residual_);
    boundary.accountFluxes(state.rows, state.pRef, dt);
    boundary.accountSources(state, dt);
    if (rates.gravity.valid())
    {
        rates.gravity->addWeight(geometry, state, dt, residual_);
    }
    if (rates.viscous.valid())
    {
        rates.viscous->addHalfStep(geometry, state, rates.rate, dt, residual_);
    }

    // Momentum, with the walls' normal velocity, so that the density step
    // sees no flux through them
    addMomentum(geometry, state, rates.rate, dt);
    advance(geometry, state, 1, 1 + dim);
    boundary.accountHeld
    (
        [&](const label a) { return newU_[a]; },
        [&](const label a) { return geometry.newNodeVolume(a); },
        [&]() { boundary.constrainMomentum(newU_); }
    );

    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        const Vec m = state.conserved(a).template segment<dim>(1);
        const Vec mNew = newU_[a].template segment<dim>(1);
        massFlux_[a] = m + theta_*(mNew - m);
    }
    addDensity(geometry, state, rates.rate, dt);
    advance(geometry, state, 0, 1);

    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        carrier_[a] =
            updatedEnergyFlux_
          ? Vec(newU_[a].template segment<dim>(1)/newU_[a][0])
          : Vec(state.velocity(a));
    }
    addEnergy(geometry, state, rates.rate, dt);
    advance(geometry, state, dim + 1, dim + 2);

    if (!capturing.nu().empty())
    {
        addViscosity(geometry, state, capturing.nu(), dt);
    }
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        state.conserved(a) = newU_[a];
    }
}


template class Foam::threeStep<1>;
template class Foam::threeStep<2>;
template class Foam::threeStep<3>;
