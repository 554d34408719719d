/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "twoStep.H"
#include "dictionaryCheck.H"
#include "PstreamReduceOps.H"

template<int dim>
Foam::twoStep<dim>::twoStep
(
    const dictionary& coeffs,
    const gasGeometry<dim>& geometry,
    const shockCapturing<dim>& capturing
)
:
    consistent_(capturing.limits()),
    massIterations_(coeffs.getOrDefault<label>("massIterations", 1)),
    boundarySum_(geometry.nRows(), uniformRow(0))
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
    if (capturing.limits())
    {
        if (massIterations_ != 1)
        {
            FatalIOErrorInFunction(coeffs)
                << "massIterations is " << massIterations_
                << ", but fluxCorrected makes one correction"
                << exit(FatalIOError);
        }
        corrector_.reset(new fluxCorrector<dim>(geometry));
    }
    else
    {
        for (gasRows* rows : {&residual_, &change_, &sum_})
        {
            rows->assign(geometry.nRows(), uniformRow(0));
        }
    }
}


template<int dim>
void Foam::twoStep<dim>::viscousStep
(
    const gasGeometry<dim>& geometry,
    const gasBoundary<dim>& boundary,
    const shockCapturing<dim>& capturing,
    gasRates<dim>& rates,
    gasState<dim>& state,
    const double dt
)
{
    constexpr int n = gasKernel::place<dim>::nConserved;
    constexpr int rowSize = gasKernel::rowSize;
    const auto& kernels = gasKernel::gasKernels<dim>::best();
    const gasKernel::edges edges = geometry.edges();
    const sharedItems& exchange = geometry.mesh().exchange();

    const activeParts& active = geometry.active();
    active.fill(residual_, uniformRow(0));
    long bad = -1;
    for (const activeParts::range& r : active.edges())
    {
        const long found = kernels.highOrderFlux
        (
            edges, state.kernelGas(), dt, r.from, r.to, data(state.rows),
            data(rates.rate), data(rates.difference),
            capturing.nu().empty() ? nullptr : capturing.nu().data(),
            data(residual_)
        );
        bad = bad < 0 ? found : bad;
    }
    const bool isBad = bad >= 0 && bad < geometry.nEdges();
    if (returnReduce(isBad, orOp<bool>()))
    {
        throw
            isBad
          ? unphysicalEdge{edges.first[bad], edges.second[bad]}
          : unphysicalEdge{-1, -1};
    }
    boundary.addFluxes(dt, residual_);
    boundary.addSources(state, dt, residual_);
    if (rates.gravity.valid())
    {
        rates.gravity->addWeight(geometry, state, dt, residual_);
    }
    if (rates.viscous.valid())
    {
        rates.viscous->addHalfStep(geometry, state, rates.rate, dt, residual_);
    }
    exchange.sum(data(residual_), rowSize, n);

    // With the boundary's half-step fluxes, complete on all processors
    boundary.addExcessSums
    (
        boundarySum_, state.hasGravity || rates.viscous.valid(), residual_
    );

    // What the state gains
    using State = gasDynamics::State<dim>;
    State held;
    auto divide = [&](const gasRows& sum, const gasRows* more)
    {
        for (const activeParts::range& r : active.nodes())
        {
            kernels.changes
            (
                geometry.volumes(), r.from, r.to, data(sum),
                more ? data(*more) : nullptr, data(state.rows), data(change_)
            );
        }
        held = boundary.changeBy
        (
            [&](const label a)
            {
                return State(Eigen::Map<State>(change_[a].v));
            },
            [&](const label a) { return geometry.newNodeVolume(a); },
            [&]() { boundary.constrainRates(change_, dt); }
        );
    };
    divide(residual_, nullptr);

    for (label pass = 0; consistent_ && pass < massIterations_; ++pass)
    {
        active.fill(sum_, uniformRow(0));
        for (const activeParts::range& r : active.edges())
        {
            kernels.massCorrection
            (
                edges, r.from, r.to, data(change_), data(sum_)
            );
        }
        exchange.sum(data(sum_), rowSize, n);
        divide(sum_, &residual_);
    }

    for (const activeParts::range& r : active.nodes())
    {
        kernels.addChanges(r.from, r.to, data(change_), data(state.rows));
    }
    boundary.accountHeld(held);
}


template<int dim>
void Foam::twoStep<dim>::step
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
    if (rates.viscous.valid())
    {
        // The boundary's fluxes are set at its own nodes only
        std::fill(boundarySum_.begin(), boundarySum_.end(), uniformRow(0));
    }
    boundary.halfStepFluxes(state, rates.rate, dt, boundarySum_);
    boundary.accountHalfStep(state.pRef, dt);
    boundary.accountSources(state, dt);

    if (corrector_.valid())
    {
        if (rates.viscous.valid())
        {
            rates.viscous->addExcess
            (
                geometry, state, rates.rate, dt, boundarySum_
            );
        }
        boundary.accountHeld(rates.held);
        corrector_().step
        (
            geometry, boundary, rates, state, consistent_, dt, boundarySum_
        );
    }
    else
    {
        viscousStep(geometry, boundary, capturing, rates, state, dt);
    }
}


template class Foam::twoStep<1>;
template class Foam::twoStep<2>;
template class Foam::twoStep<3>;
