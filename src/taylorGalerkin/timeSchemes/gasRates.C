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
    speed(geometry.nRows(), 0.0)
{}


template<int dim>
void Foam::gasRates<dim>::sumSpeeds
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state
)
{
    const gasKernel::edges edges = geometry.edges();
    std::fill(speed.begin(), speed.end(), 0.0);
    gasKernel::gasKernels<dim>::best().waveSpeeds
    (
        edges, 0, edges.n, data(state.rows), speed.data()
    );
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
    std::fill(rate.begin(), rate.end(), uniformRow(0));
    std::fill(difference.begin(), difference.end(), uniformRow(0));
    std::fill(speed.begin(), speed.end(), 0.0);
    gasKernel::gasKernels<dim>::best().centralFlux
    (
        edges, state.kernelGas(), 0, edges.n,
        data(state.rows), data(rate), data(difference), speed.data()
    );
    geometry.mesh().exchange().sum(speed.data(), 1, 1);

    // Padding
    std::fill(speed.begin() + geometry.nNodes(), speed.end(), 1.0);
    hasSums_ = true;
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
    boundary.addFluxes(state, 1, rate);
    boundary.addSources(state, 1, rate);
    if (viscous.valid())
    {
        viscous->addPresent(rate);
    }
    boundary.closeForce(state, rate);
    const sharedItems& exchange = geometry.mesh().exchange();
    exchange.sum(data(rate), rowSize, n + dim);
    exchange.sum(data(difference), rowSize, n + 1);

    gasKernel::gasKernels<dim>::best().rates
    (
        geometry.volumes(), dt, 0, geometry.nRows(),
        data(state.rows), speed.data(), data(rate), data(difference)
    );
    boundary.constrainRates(rate);

    // As if the gas went on behind a wall, mirrored
    boundary.constrainAtWalls(difference);
    boundary.holdWallTemperatures(difference);
    hasSums_ = false;
}


template class Foam::gasRates<1>;
template class Foam::gasRates<2>;
template class Foam::gasRates<3>;
