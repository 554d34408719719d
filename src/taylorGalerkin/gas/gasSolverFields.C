/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasSolver.H"
#include "PstreamReduceOps.H"
#include "Time.H"

#include <cmath>

template<int dim>
void Foam::gasSolver<dim>::readState()
{
    for (label a = 0; a < mesh_.nNodes(); ++a)
    {
        const label pointi = mesh_.pointOfNode()[a];
        state_.conserved(a) = gasDynamics::conserved<dim>
        (
            state_.eos,
            state_.eos.density(p_[pointi], T_[pointi]),
            mesh_.components<dim>(U_[pointi], mesh_.poly().points()[pointi]),
            p_[pointi]
        );
    }
    if (mesh_.poly().time().timeIndex() == 0)
    {
        // Not on what an earlier run wrote: its walls may have been in motion,
        // and a step begins with what the walls and patches prescribe anyway
        boundary_.startAtWalls(state_.rows);
        boundary_.impose(state_.rows);
    }

    const label bad = state_.derive(geometry_.active());
    if (bad >= 0 && bad < mesh_.nNodes())
    {
        const label pointi = mesh_.pointOfNode()[bad];
        FatalErrorInFunction
            << "The initial state is not physical at the point "
            << mesh_.nodes()[bad] << ": p = " << p_[pointi] << " Pa, T = "
            << T_[pointi] << " K, U = " << U_[pointi] << nl
            << "    Change " << p_.objectPath() << ", T or U"
            << exit(FatalError);
    }
    findReferences();
    updateFields();
}


template<int dim>
void Foam::gasSolver<dim>::findReferences()
{
    // The median: ambient gas fills at least half of most scenes
    std::vector<double> p(mesh_.nNodes());
    for (label a = 0; a < mesh_.nNodes(); ++a)
    {
        p[a] = state_.p(a);
    }
    // Of the first processor that has nodes
    label teller = p.empty() ? labelMax : Pstream::myProcNo();
    reduce(teller, minOp<label>());
    state_.pRef = -GREAT;
    if (teller == Pstream::myProcNo())
    {
        std::nth_element(p.begin(), p.begin() + p.size()/2, p.end());
        state_.pRef = p[p.size()/2];
    }
    reduce(state_.pRef, maxOp<scalar>());

    // The least momentum that gas at its speed of sound has: (G80)
    scalar least = GREAT;
    for (label a = 0; a < mesh_.nNodes(); ++a)
    {
        least = min(least, state_.rho(a)*state_.soundSpeed(a));
    }
    reduce(least, minOp<scalar>());
    int exponent;
    std::frexp(least, &exponent);
    state_.momentumScale = std::ldexp(1.5, exponent);
    state_.derive(geometry_.active());
}


template<int dim>
void Foam::gasSolver<dim>::updateFields()
{
    const gasDynamics::PerfectGas& eos = state_.eos;

    // The whole value of a point, boundary points included
    auto& p = p_.primitiveFieldRef();
    auto& U = U_.primitiveFieldRef();
    auto& T = T_.primitiveFieldRef();
    auto& rho = rho_.primitiveFieldRef();

    for (const activeParts::range& r : geometry_.active().nodes())
    {
        const label end = firstPoint_[min(label(r.to), mesh_.nNodes())];
        for (label i = firstPoint_[r.from]; i < end; ++i)
        {
            const label pointi = points_[i];
            const label a = mesh_.nodeOfPoint()[pointi];
            rho[pointi] = state_.rho(a);
            p[pointi] = state_.p(a);
            T[pointi] = eos.temperature(state_.p(a), state_.rho(a));
            U[pointi] = mesh_.fullVector<dim>
            (
                state_.velocity(a), mesh_.poly().points()[pointi]
            );
        }
    }
    if (mesh_.poly().time().writeTime())
    {
        zones_.report(Info);
    }
}


template<int dim>
void Foam::gasSolver<dim>::writeState()
{
    // The state may belong to a time before the run's
    Time& runTime = const_cast<Time&>(mesh_.poly().time());
    if (stateTime_ != runTime.value())
    {
        runTime.setTime(stateTime_, max(runTime.timeIndex() - 1, label(0)));
    }
    updateFields();
    p_.write();
    U_.write();
    T_.write();
    rho_.write();
    writeMesh();

    // Tells a run that starts here that an earlier one has written the state
    runTime.writeTimeDict();
}


template<int dim>
void Foam::gasSolver<dim>::writeMesh()
{
    polyMesh& poly = const_cast<polyMesh&>(mesh_.poly());
    const pointField shift
    (
        mesh_.nodes() - mesh_.gather(poly.points())
    );
    if (returnReduce(gMax(mag(shift)) > 0, orOp<bool>()) || poly.moving())
    {
        // The polyMesh follows at the end of the run's step only
        poly.movePoints
        (
            poly.points() + pointField(shift, mesh_.nodeOfPoint())
        );
        poly.write();
    }
}


template<int dim>
void Foam::gasSolver<dim>::storeOldState()
{
    old_.rows = state_.rows;
    old_.time = stateTime_;
    geometry_.store(old_.geometry);
    boundary_.storeOldState();
    if (gasAccount* found = account())
    {
        found->storeOldState();
    }
}


template<int dim>
void Foam::gasSolver<dim>::restoreOldState()
{
    if (old_.rows.empty())
    {
        FatalErrorInFunction
            << "There is no stored state of the gas to go back to"
            << abort(FatalError);
    }
    state_.rows = old_.rows;
    stateTime_ = old_.time;
    geometry_.restore(old_.geometry);
    boundary_.restoreOldState();
    if (gasAccount* found = account())
    {
        found->restoreOldState();
    }

    // Sums, viscosities and the stable step are found again. What has woken
    // since stays awake, which changes no bit (quiescentZones)
    rates_.clear();
    stableIsUpToDate_ = false;
}


template<int dim>
Foam::tmp<Foam::vectorField> Foam::gasSolver<dim>::pressureForces
(
    const fePatch& patch,
    const scalar pRef
) const
{
    auto tforces = tmp<vectorField>::New(patch.nodes.size(), Zero);
    vectorField& forces = tforces.ref();

    forAll(patch.facetSimplex, i)
    {
        double p[dim];
        Vec force[dim];
        for (int b = 0; b < dim; ++b)
        {
            p[b] = state_.p(patch.facets[dim*i + b]) - pRef;
        }
        gasBoundary<dim>::facetForces
        (
            p, geometry_.presentFacet(patch, i), force
        );
        for (int b = 0; b < dim; ++b)
        {
            const label local =
                findLower(patch.nodes, patch.facets[dim*i + b] + 1);
            forces[local] += mesh_.fullVector<dim>(force[b]);
        }
    }
    return tforces;
}


template<int dim>
Foam::gasTotals Foam::gasSolver<dim>::totals() const
{
    const activeParts& active = geometry_.active();
    const bool first = blockTotals_.empty();
    blockTotals_.resize(active.nBlocks(), State::Zero());
    State sum = State::Zero();
    for (label b = 0; b < active.nBlocks(); ++b)
    {
        if (first || !active.blockAsleep(b))
        {
            State& total = blockTotals_[b];
            total = State::Zero();
            const activeParts::range r = active.rows(b);
            for (label a = r.from; a < r.to && a < mesh_.nNodes(); ++a)
            {
                if (mesh_.exchange().owned(a))
                {
                    total += geometry_.nodeVolume(a)*State(state_.conserved(a));
                }
            }
        }
        sum += blockTotals_[b];
    }
    for (int k = 0; k < dim + 2; ++k)
    {
        reduce(sum[k], sumOp<scalar>());
    }
    return gasTotals
    {
        sum[0],
        mesh_.fullVector<dim>(Vec(sum.template segment<dim>(1))),
        sum[dim + 1]
    };
}


template<int dim>
Foam::gasExtrema Foam::gasSolver<dim>::extrema() const
{
    gasExtrema e{GREAT, -GREAT, GREAT, -GREAT, GREAT, -GREAT, 0};
    scalar square = 0;
    auto take = [&](const scalar p, const scalar rho)
    {
        const scalar T = state_.eos.temperature(p, rho);
        e.minP = min(e.minP, p);
        e.maxP = max(e.maxP, p);
        e.minRho = min(e.minRho, rho);
        e.maxRho = max(e.maxRho, rho);
        e.minT = min(e.minT, T);
        e.maxT = max(e.maxT, T);
    };
    for (const activeParts::range& r : geometry_.active().nodes())
    {
        for (label a = r.from; a < r.to && a < mesh_.nNodes(); ++a)
        {
            take(state_.p(a), state_.rho(a));
            square = max(square, state_.velocity(a).squaredNorm());
        }
    }
    if (geometry_.active().nAsleep() && zones_.sleeping())
    {
        const gasRow& still = zones_.still();
        take(still[gasKernel::place<dim>::p], still[0]);
    }
    for (scalar* least : {&e.minP, &e.minRho, &e.minT})
    {
        reduce(*least, minOp<scalar>());
    }
    e.maxSpeed = std::sqrt(square);
    for (scalar* largest : {&e.maxP, &e.maxRho, &e.maxT, &e.maxSpeed})
    {
        reduce(*largest, maxOp<scalar>());
    }
    return e;
}


template class Foam::gasSolver<1>;
template class Foam::gasSolver<2>;
template class Foam::gasSolver<3>;
