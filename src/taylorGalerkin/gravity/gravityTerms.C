/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gravityTerms.H"

template<int dim>
Foam::gravityTerms<dim>::gravityTerms
(
    const Vec& g,
    const List<const fePatch*>& open,
    const List<const fePatch*>& farField
)
:
    g_(g),
    open_(open),
    farField_(farField)
{}


template<int dim>
double Foam::gravityTerms<dim>::meanDensity
(
    const double rhoA,
    const double rhoB
)
{
    // The quotient of differences would lose all digits where they are equal
    const double sum = rhoA + rhoB;
    const double f = (rhoB - rhoA)/sum, u = f*f;
    if (u < 1e-3)
    {
        // What is left out is u^6/13
        return
            0.5*sum
           /(1 + u*(1.0/3 + u*(1.0/5 + u*(1.0/7 + u*(1.0/9 + u/11)))));
    }
    return (rhoB - rhoA)/std::log(rhoB/rhoA);
}


template<int dim>
typename Foam::gravityTerms<dim>::difference
Foam::gravityTerms<dim>::between
(
    const gasState<dim>& state,
    const label a,
    const label b,
    const double fall
)
{
    const double rhoA = state.rho(a), rhoB = state.rho(b);
    const double pressurePerDensity =
        0.5*(state.p(a)/rhoA + state.p(b)/rhoB);
    const Vec U = 0.5*(state.velocity(a) + state.velocity(b));

    difference d;
    d.p = meanDensity(rhoA, rhoB)*fall;
    const double rho = d.p/pressurePerDensity;
    d.U[0] = rho;
    d.U.template segment<dim>(1) = rho*U;
    d.U[dim + 1] =
        d.p/(state.eos.gamma() - 1) + 0.5*rho*U.squaredNorm();
    return d;
}


template<int dim>
void Foam::gravityTerms<dim>::update(const gasGeometry<dim>& geometry)
{
    if (fall_.size() && !geometry.moving())
    {
        return;
    }
    const std::vector<Vec> along(geometry.edgeVectors());
    fall_.resize(along.size());
    for (std::size_t e = 0; e < along.size(); ++e)
    {
        fall_[e] = g_.dot(along[e]);
    }
}


template<int dim>
double Foam::gravityTerms<dim>::fallBetween
(
    const feMesh& mesh,
    const label a,
    const label b
) const
{
    const label first = min(a, b), second = max(a, b);
    for
    (
        label e = mesh.firstEdge()[first];
        e < mesh.firstEdge()[first + 1];
        ++e
    )
    {
        if (mesh.edges()[e][1] == second)
        {
            return a == first ? fall_[e] : -fall_[e];
        }
    }
    FatalErrorInFunction
        << "No edge joins the nodes " << a << " and " << b
        << abort(FatalError);
    return 0;
}


template<int dim>
void Foam::gravityTerms<dim>::addAtPatches
(
    const List<const fePatch*>& patches,
    const double share,
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt,
    gasRows& sum
) const
{
    for (const fePatch* patch : patches)
    {
        for (const auto& pair : geometry.surface(*patch).pairs())
        {
            const double half =
                0.5*dt*fallBetween(geometry.mesh(), pair.a, pair.b);
            const double rhoA = state.rho(pair.a), rhoB = state.rho(pair.b);
            const double rho = share*meanDensity(rhoA, rhoB);
            for (int k = 0; k < dim; ++k)
            {
                const double there = hasWeightAlong(geometry, k);
                sum[pair.a][1 + k] += pair.M[k]*(rho - there*rhoA)*half;
                sum[pair.b][1 + k] -= pair.M[k]*(rho - there*rhoB)*half;
            }
        }
    }
}


template<int dim>
void Foam::gravityTerms<dim>::addWeight
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt,
    gasRows& sum
) const
{
    const sharedItems& exchange = geometry.mesh().exchange();
    for (label a = 0; a < state.nNodes(); ++a)
    {
        if (exchange.owned(a))
        {
            const double volume =
                0.5*(geometry.nodeVolume(a) + geometry.newNodeVolume(a));
            state.addWeight(state.rows[a], dt*volume, sum[a]);
        }
    }

    const gasKernel::edges edges = geometry.edges();
    for (label e = 0; e < geometry.nEdges(); ++e)
    {
        const label a = edges.first[e], b = edges.second[e];
        const double rhoA = state.rho(a), rhoB = state.rho(b);
        const double rho = meanDensity(rhoA, rhoB);
        const double half = 0.5*dt*fall_[geometry.meshEdge(e)];
        for (int k = 0; k < dim; ++k)
        {
            const double S = edges.area[k][e];
            const double there = hasWeightAlong(geometry, k);
            sum[a][1 + k] += S*(rho - there*rhoA)*half;
            sum[b][1 + k] += S*(rho - there*rhoB)*half;
        }
    }

    // As gasBoundary takes the pressure there. On walls it acts along their
    // normal, in which they hold the gas.
    addAtPatches(open_, 1, geometry, state, dt, sum);
    addAtPatches(farField_, 0, geometry, state, dt, sum);
}


template<int dim>
template<class Visit>
void Foam::gravityTerms<dim>::forDiffusion
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const Visit& visit
) const
{
    const gasKernel::edges edges = geometry.edges();
    for (label e = 0; e < geometry.nEdges(); ++e)
    {
        const label a = edges.first[e], b = edges.second[e];
        Vec S;
        for (int k = 0; k < dim; ++k)
        {
            S[k] = edges.area[k][e];
        }
        const double sweep = edges.sweep ? edges.sweep[e] : 0;
        auto speed = [&](const label node)
        {
            return
                mag(state.velocity(node).dot(S) - sweep)
              + state.soundSpeed(node)*edges.magArea[e];
        };
        const double d = 0.5*max(speed(a), speed(b));
        difference rest =
            between(state, a, b, fall_[geometry.meshEdge(e)]);
        rest.p *= d;
        rest.U *= d;
        visit(e, a, b, rest);
    }
}


template<int dim>
void Foam::gravityTerms<dim>::balance
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    gasRows& differences
) const
{
    constexpr int p = gasKernel::place<dim>::differenceOfP;
    forDiffusion
    (
        geometry,
        state,
        [&](const label, const label a, const label b, const difference& rest)
        {
            for (int k = 0; k < dim + 2; ++k)
            {
                differences[a][k] -= rest.U[k];
                differences[b][k] += rest.U[k];
            }
            differences[a][p] -= rest.p;
            differences[b][p] += rest.p;
        }
    );
}


template<int dim>
void Foam::gravityTerms<dim>::balanceAntidiffusion
(
    const gasGeometry<dim>& geometry,
    const gasState<dim>& state,
    const double dt,
    std::vector<double>& flux,
    gasRows& sum
) const
{
    const std::size_t n = geometry.edges().n;
    forDiffusion
    (
        geometry,
        state,
        [&](const label e, const label a, const label b, const difference& rest)
        {
            for (int k = 0; k < dim + 2; ++k)
            {
                const double f = dt*rest.U[k];
                flux[k*n + e] -= f;
                sum[a][k] += f;
                sum[b][k] -= f;
            }
        }
    );
}


template class Foam::gravityTerms<1>;
template class Foam::gravityTerms<2>;
template class Foam::gravityTerms<3>;
