/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasRates.H"

template<int dim>
Foam::gasRates<dim>::gasRates(const gasGeometry<dim>& geometry)
:
    hasSums_(false),
    rate(geometry.nRows(), uniformRow(0)),
    difference(geometry.nRows(), uniformRow(0)),
    speed(geometry.nRows(), 0.0),
    held(gasDynamics::State<dim>::Zero())
{}


template<int dim>
void Foam::gasRates<dim>::clearSpeeds(const gasGeometry<dim>& geometry)
{
    const activeParts& active = geometry.active();
    active.fill(speed, 0.0);
    if (active.nAsleep())
    {
        // The sums of nodes asleep are not computed, but added up with those
        // of other processors
        for (const label a : geometry.mesh().exchange().shared())
        {
            speed[a] = active.asleep(a) ? 0 : speed[a];
        }
    }
}


template<int dim>
void Foam::gasRates<dim>::sumSpeeds
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    const gasKernel::edges edges = geometry.edges();
    clearSpeeds(geometry);
    for (const activeParts::range& r : geometry.active().edges())
    {
        gasKernel::gasKernels<dim>::best().waveSpeeds
        (
            edges, r.from, r.to, data(state.rows), speed.data()
        );
    }
    geometry.mesh().exchange().sum(speed.data(), 1, 1);
    hasSums_ = false;
}


template<int dim>
void Foam::gasRates<dim>::sumEdges
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    if (hasSums_)
    {
        return;
    }
    const gasKernel::edges edges = geometry.edges();
    const activeParts& active = geometry.active();
    active.fill(rate, uniformRow(0));
    active.fill(difference, uniformRow(0));
    clearSpeeds(geometry);
    for (const activeParts::range& r : active.edges())
    {
        gasKernel::gasKernels<dim>::best().centralFlux
        (
            edges, state.kernelGas(), r.from, r.to,
            data(state.rows), data(rate), data(difference), speed.data()
        );
    }
    geometry.mesh().exchange().sum(speed.data(), 1, 1);

    // Padding
    std::fill(speed.begin() + geometry.nNodes(), speed.end(), 1.0);
    hasSums_ = true;
}


template<int dim>
gasDynamics::State<dim> Foam::gasRates<dim>::constrain
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    const double dt
)
{
    using State = gasDynamics::State<dim>;
    return boundary.changeBy
    (
        [&](const label a) { return State(Eigen::Map<State>(rate[a].v)); },
        [&](const label a)
        {
            return
                0.5*dt*(geometry.nodeVolume(a) + geometry.newNodeVolume(a));
        },
        [&]() { boundary.constrainRates(rate); }
    );
}


template<int dim>
void Foam::gasRates<dim>::compute
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    const gasState<dim>& state,
    const double dt
)
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    constexpr int rowSize = gasKernel::rowSize;

    sumEdges(geometry, state);
    boundary.setFluxes(state);
    boundary.addFluxes(1, rate);
    boundary.addSources(state, 1, rate);
    if (viscous.valid())
    {
        viscous->addPresent(rate);
    }
    if (gravity.valid())
    {
        gravity->update(geometry);
        gravity->addWeight(geometry, state, 1, rate);
        gravity->balance(geometry, state, difference);
    }
    const sharedItems& exchange = geometry.mesh().exchange();
    exchange.sum(data(rate), rowSize, n + dim);
    exchange.sum(data(difference), rowSize, n + 1);

    for (const activeParts::range& r : geometry.active().nodes())
    {
        gasKernel::gasKernels<dim>::best().rates
        (
            geometry.volumes(), dt, r.from, r.to,
            data(state.rows), speed.data(), data(rate), data(difference)
        );
    }
    using State = gasDynamics::State<dim>;
    held = constrain(geometry, boundary, dt);
    held += boundary.changeBy
    (
        [&](const label a)
        {
            return State(Eigen::Map<State>(difference[a].v));
        },
        [&](const label a) { return dt*speed[a]; },
        [&]()
        {
            boundary.constrainDifferences(difference);
            boundary.holdWallTemperatures(difference);
        }
    );
    hasSums_ = false;
}


template class Foam::gasRates<1>;
template class Foam::gasRates<2>;
template class Foam::gasRates<3>;
