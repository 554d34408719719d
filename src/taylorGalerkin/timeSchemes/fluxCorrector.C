/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "fluxCorrector.H"
#include "PstreamReduceOps.H"

template<int dim>
Foam::fluxCorrector<dim>::fluxCorrector(const gasGeometry<dim>& geometry)
:
    sum_(geometry.nRows(), uniformRow(0)),
    low_(geometry.nRows(), uniformRow(0)),
    limited_(geometry.nRows(), uniformRow(0)),
    bounds_(geometry.nRows(), uniformRow(0)),
    collected_(2*geometry.nRows()),
    flux_(gasKernel::place<dim>::nConserved*geometry.edges().n, 0.0),
    signs_(geometry.edges().n),
    nRefused_(0)
{}


template<int dim>
void Foam::fluxCorrector<dim>::step
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    gasRates<dim>& rates,
    gasState<dim>& state,
    const bool consistentMass,
    const double dt,
    gasRows& boundarySum
)
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    constexpr int rowSize = gasKernel::rowSize;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    const gasKernel::edges edges = geometry.edges();
    const gasKernel::volumes volumes = geometry.volumes();
    const gasKernel::gas gas = state.kernelGas();
    const sharedItems& exchange = geometry.mesh().exchange();
    const activeParts& active = geometry.active();

    active.fill(sum_, uniformRow(0));
    for (const activeParts::range& r : active.edges())
    {
        kernels.antidiffusion
        (
            edges, gas, dt, r.from, r.to, data(state.rows), data(rates.rate),
            data(rates.difference), flux_.data(), data(sum_)
        );
    }
    if (rates.gravity.valid())
    {
        rates.gravity->balanceAntidiffusion(geometry, state, dt, flux_, sum_);
    }
    exchange.sum(data(sum_), rowSize, n);
    boundary.addExcess
    (
        boundarySum, state.hasGravity || rates.viscous.valid(), dt, rates.rate
    );

    // The half step's pressure pushes a wall, not its gas: that would be
    // kinetic energy which the bounds of internal energy miss
    boundary.accountHeld(rates.constrain(geometry, boundary, dt));

    long bad = -1;
    for (const activeParts::range& r : active.nodes())
    {
        const long found = kernels.lowOrderState
        (
            volumes, gas, dt, !consistentMass, r.from, r.to, data(state.rows),
            rates.speed.data(), data(rates.rate), data(rates.difference),
            data(sum_), data(low_), data(limited_), data(bounds_),
            data(collected_)
        );
        bad = bad < 0 ? found : bad;
    }
    const bool isBad = bad >= 0 && bad < geometry.nNodes();
    if (returnReduce(isBad, orOp<bool>()))
    {
        if (!isBad)
        {
            throw unphysicalNode{-1, 0, 0};
        }
        const Eigen::Map<const gasDynamics::State<dim>> s(low_[bad].v);
        throw unphysicalNode
        {
            label(bad), s[0], gasDynamics::pressure<dim>(state.eos, s)
        };
    }
    if (consistentMass)
    {
        boundary.constrainRates(sum_, dt);
    }

    using place = gasKernel::collectedPlace;
    for (const activeParts::range& r : active.edges())
    {
        kernels.collect
        (
            edges, r.from, r.to, data(sum_), data(limited_), data(bounds_),
            flux_.data(), signs_.data(), data(collected_)
        );
    }
    exchange.sum(data(collected_), place::size, place::nSums);
    exchange.max
    (
        data(collected_) + place::nSums, place::size,
        place::size - place::nSums
    );

    // Where a wall holds the temperature density follows pressure, whose
    // bounds are those of internal energy; that itself needs none
    boundary.noSlip().atTemperature
    (
        [&](const label a, const double T)
        {
            using gasKernel::boundPlace;
            double* bounds =
                data(collected_) + place::size*a + place::bounds;
            const double perEnergy = 1/(state.eos.Cv()*T);
            for (int k = 0; k < 2; ++k)
            {
                const double slack = k == 0 ? slack_ : -slack_;
                double& rho = bounds[boundPlace::rho + k];
                double& energy = bounds[boundPlace::energy + k];
                rho = max(rho, (1 + slack)*perEnergy*energy);
                energy = GREAT;
            }
        }
    );

    for (const activeParts::range& r : active.nodes())
    {
        kernels.shares
        (
            volumes.after, slack_, r.from, r.to, data(state.rows),
            data(collected_), data(bounds_), data(sum_), data(limited_)
        );
    }
    acceptState(geometry, state);
}


template<int dim>
void Foam::fluxCorrector<dim>::refuse
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const long found
)
{
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        const gasDynamics::State<dim> s = state.conserved(a);
        if (a == found || !gasDynamics::isPhysical<dim>(state.eos, s))
        {
            limited_[a] = uniformRow(0);
            ++nRefused_;
        }
    }
}


template<int dim>
void Foam::fluxCorrector<dim>::acceptState
(
    const gasGeometry<dim>& geometry,
    gasState<dim>& state
)
{
    const gasKernel::edges edges = geometry.edges();
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    const activeParts& active = geometry.active();
    nRefused_ = 0;

    while (true)
    {
        for (const activeParts::range& r : active.edges())
        {
            kernels.limitedFlux
            (
                edges, r.from, r.to, data(limited_), signs_.data(),
                flux_.data(), data(sum_)
            );
        }
        geometry.mesh().exchange().sum
        (
            data(sum_), gasKernel::rowSize, gasKernel::place<dim>::nConserved
        );

        long bad = -1;
        for (const activeParts::range& r : active.nodes())
        {
            const long found = kernels.newState
            (
                state.kernelGas(), geometry.volumes().after, r.from, r.to,
                data(low_), data(sum_), data(state.rows)
            );
            bad = bad < 0 ? found : bad;
        }
        const bool isBad = bad >= 0 && bad < geometry.nNodes();
        if (!returnReduce(isBad, orOp<bool>()))
        {
            return;
        }

        // No share at a node: none of its edges passes anything
        refuse(geometry, state, bad);
        active.fill(sum_, uniformRow(0));
    }
}


template class Foam::fluxCorrector<1>;
template class Foam::fluxCorrector<2>;
template class Foam::fluxCorrector<3>;
