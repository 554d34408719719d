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
    const gasRates<dim>& rates,
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
    exchange.sum(data(sum_), rowSize, n);

    long bad = -1;
    for (const activeParts::range& r : active.nodes())
    {
        const long found = kernels.lowOrderState
        (
            volumes, gas, dt, !consistentMass, r.from, r.to, data(state.rows),
            rates.speed.data(), data(rates.rate), data(rates.difference),
            data(boundarySum), data(sum_), data(low_), data(limited_),
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
            edges, r.from, r.to, data(sum_), data(limited_), flux_.data(),
            signs_.data(), data(collected_)
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
            double* bounds = data(collected_) + place::size*a;
            const double perEnergy = 1/(state.eos.Cv()*T);
            for (int k = 0; k < 2; ++k)
            {
                const double slack = k == 0 ? slack_ : -slack_;
                double& bound = bounds[place::rhoBound + k];
                bound = max
                (
                    bound,
                    (1 + slack)*perEnergy*bounds[place::energyBound + k]
                );
                bounds[place::energyBound + k] = GREAT;
            }
        }
    );

    for (const activeParts::range& r : active.nodes())
    {
        kernels.shares
        (
            volumes.after, slack_, r.from, r.to, data(state.rows),
            data(collected_), data(sum_), data(limited_)
        );
    }
    for (const activeParts::range& r : active.edges())
    {
        kernels.limitedFlux
        (
            edges, r.from, r.to, data(limited_), signs_.data(), flux_.data(),
            data(sum_)
        );
    }
    exchange.sum(data(sum_), rowSize, n);
    acceptState(geometry, state);
}


template<int dim>
std::vector<double> Foam::fluxCorrector<dim>::refusing
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const long found
)
{
    std::vector<double> refuses(geometry.nRows(), 0.0);
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        const gasDynamics::State<dim> s = state.conserved(a);
        if (a == found || !gasDynamics::isPhysical<dim>(state.eos, s))
        {
            refuses[a] = 1;
            ++nRefused_;
        }
    }
    return refuses;
}


template<int dim>
void Foam::fluxCorrector<dim>::acceptState
(
    const gasGeometry<dim>& geometry,
    gasState<dim>& state
)
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    const gasKernel::edges edges = geometry.edges();
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    const sharedItems& exchange = geometry.mesh().exchange();
    nRefused_ = 0;

    while (true)
    {
        long bad = -1;
        for (const activeParts::range& r : geometry.active().nodes())
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

        const std::vector<double> refuses = refusing(geometry, state, bad);
        std::fill(sum_.begin(), sum_.end(), uniformRow(0));
        for (std::size_t e = 0; e < edges.n; ++e)
        {
            const int i = edges.first[e], j = edges.second[e];
            for (int k = 0; k < n; ++k)
            {
                double& f = flux_[k*edges.n + e];
                if (refuses[i] + refuses[j] > 0)
                {
                    f = 0;
                }
                sum_[i][k] -= f;
                sum_[j][k] += f;
            }
        }
        exchange.sum(data(sum_), gasKernel::rowSize, n);
    }
}


template class Foam::fluxCorrector<1>;
template class Foam::fluxCorrector<2>;
template class Foam::fluxCorrector<3>;
