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
    collected_(geometry.nRows()),
    flux_(gasKernel::place<dim>::nConserved*geometry.edges().n, 0.0),
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
    const label nRows = geometry.nRows();

    std::fill(sum_.begin(), sum_.end(), uniformRow(0));
    kernels.antidiffusion
    (
        edges, gas, dt, 0, edges.n, data(state.rows), data(rates.rate),
        data(rates.difference), flux_.data(), data(sum_)
    );
    exchange.sum(data(sum_), rowSize, n);

    const long bad = kernels.lowOrderState
    (
        volumes, gas, dt, 0, nRows, data(state.rows), rates.speed.data(),
        data(rates.rate), data(rates.difference), data(boundarySum),
        data(sum_), data(low_), data(limited_)
    );
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
    else
    {
        std::fill(sum_.begin(), sum_.end(), uniformRow(0));
    }

    std::fill
    (
        collected_.begin(), collected_.end(),
        gasRow{{0, 0, 0, 0, -GREAT, -GREAT, -GREAT, -GREAT}}
    );
    kernels.collect
    (
        edges, 0, edges.n, data(sum_), data(limited_), flux_.data(),
        data(collected_)
    );
    exchange.sum(data(collected_), rowSize, 4);
    exchange.max(data(collected_) + 4, rowSize, 4);

    kernels.shares
    (
        volumes.after, slack_, 0, nRows, data(collected_), data(limited_)
    );
    std::fill(sum_.begin(), sum_.end(), uniformRow(0));
    kernels.limitedFlux
    (
        edges, 0, edges.n, data(limited_), flux_.data(), data(sum_)
    );
    exchange.sum(data(sum_), rowSize, n);
    acceptState(geometry, state);
}


template<int dim>
std::vector<double> Foam::fluxCorrector<dim>::refusing
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    label& count
) const
{
    std::vector<double> refuses;
    count = 0;
    for (label a = 0; a < geometry.nNodes(); ++a)
    {
        const gasDynamics::State<dim> s = state.conserved(a);
        if (!gasDynamics::isPhysical<dim>(state.eos, s))
        {
            if (refuses.empty())
            {
                refuses.assign(geometry.nRows(), 0.0);
            }
            refuses[a] = 1;
            ++count;
        }
    }
    reduce(count, sumOp<label>());
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
    const sharedItems& exchange = geometry.mesh().exchange();
    nRefused_ = 0;

    while (true)
    {
        for (label a = 0; a < geometry.nNodes(); ++a)
        {
            const double perVolume = 1/geometry.newNodeVolume(a);
            for (int k = 0; k < n; ++k)
            {
                state.rows[a][k] = low_[a][k] + perVolume*sum_[a][k];
            }
        }

        label count;
        std::vector<double> refuses = refusing(geometry, state, count);
        if (count == 0)
        {
            return;
        }
        nRefused_ += count;
        refuses.resize(geometry.nRows(), 0.0);

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
