// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over the integration points of a batch of elements with assumed strains,
// (A8)-(A12). Included once for each instruction set.

#include "AssumedStrain.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

//- What the assumed strains of a state are made from, and the gap that belongs to its
//  stress: its own unless said otherwise
struct AssumedState
{
    Pack f[maxAreaPoints][F::size];
    EdgeVectors edges[nEdgePoints];
    MidStrain gap[maxAreaPoints];
};

//- All but the gap
inline void makeFields
(
    const ElementRule& rule,
    const ElementVector& q,
    AssumedState& state
)
{
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        interpolate(rule.area[p], q, state.f[p]);
    }
    for (int s = 0; s < nEdgePoints; ++s)
    {
        state.edges[s] = edgeVectors(rule.assumed.edge[s], q);
    }
}

inline void makeState
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    AssumedState& state
)
{
    makeFields(rule, q, state);
    stateGap(rule, batch, q, state.f, state.edges, state.gap);
    if (batch.gaps.empty()) return;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (int k = 0; k < M::size; ++k)
        {
            Pack& v = state.gap[p].v[k];
            v = v - Pack(batch.gaps[p].v[k]);
        }
    }
}

inline void strainGap
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    ReferenceGap* gap
)
{
    AssumedState state;
    makeState(rule, batch, q, state);
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (int k = 0; k < M::size; ++k) state.gap[p].v[k].store(gap[p].v[k]);
    }
}

inline void assumedEnergy
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    LaneValues& result
)
{
    AssumedState state;
    makeState(rule, batch, q, state);
    Pack sum(0);
    std::size_t k = 0;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (const LinePoint& z : rule.thickness)
        {
            Pack e[6];
            covariantStrain
            (
                baseVectors(state.f[p], batch.halfThickness, z.xi),
                batch.points[k].metric, e
            );
            addToStrain(state.gap[p], e);
            sum += pointEnergy(batch, k++, e);
        }
    }
    sum.store(result);
}

//- Force on the fields of an area point without that of the samples, and the
//  stress on the gap
SHELL_INLINE MidStrain fieldForceAndStress
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const AssumedState& state,
    std::size_t p,
    Pack* force
)
{
    Pack resultant[6] = {};
    for (int k = 0; k < F::size; ++k) force[k] = Pack(0);
    for (std::size_t z = 0; z < rule.thickness.size(); ++z)
    {
        const std::size_t k = p*rule.thickness.size() + z;
        const BaseVectors b =
            baseVectors(state.f[p], batch.halfThickness, rule.thickness[z].xi);
        Pack e[6];
        Pack S[6];
        Pack t[3][3];
        covariantStrain(b, batch.points[k].metric, e);
        addToStrain(state.gap[p], e);
        stress(batch, k, e, S, nullptr);
        tractions(b, S, t);
        addFieldForce(b, state.f[p], t, force);
        for (int u = 0; u < 6; ++u) resultant[u] += S[u];
    }
    return midStress(resultant);
}

//- Force of the stresses on edge and node samples, on the unknowns; the first nodes
//  may be left out
SHELL_INLINE void addSampleForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    const EdgeVectors* edges,
    const MidSamples& stress,
    Pack* sum,
    int firstNode = 0
)
{
    const double h = batch.halfThickness;
    for (int s = 0; s < nEdgePoints; ++s)
    {
        const EdgePoint& point = rule.assumed.edge[s];
        for (int c = 0; c < 3; ++c)
        {
            const Pack onPosition = stress.membrane[s]*edges[s].m[c]
                + h*(stress.shear[s]*edges[s].g[c]);
            const Pack onDirector = h*(stress.shear[s]*edges[s].m[c]);
            for (int k = 0; k < EdgePoint::nNodes; ++k)
            {
                if (point.nodes[k] < firstNode) continue;
                Pack* node = &sum[dofsPerNode*point.nodes[k]];
                node[c] += point.dN[k]*onPosition;
                node[3 + c] += point.N[k]*onDirector;
            }
        }
    }
    for (int j = firstNode; j < nodesPerElement; ++j)
    {
        for (int c = 3; c < 6; ++c)
        {
            sum[dofsPerNode*j + c] +=
                (h*h)*(stress.thickness[j]*Pack(q.x[dofsPerNode*j + c]));
        }
    }
}

//- Force on the unknowns of what works on fields and on gap, (A9); changes what is
//  given for the fields
inline void assembleForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    const AssumedState& state,
    const MidStrain* onGap,
    Pack (*fieldForce)[F::size],
    ElementVector& result
)
{
    MidSamples samples;
    stressOnSamples(rule, onGap, samples);

    NodalSums sum;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        addAreaForce
        (
            state.f[p], samples.area[p], batch.halfThickness, fieldForce[p]
        );
        sum.add(rule.area[p], fieldForce[p]);
    }
    addSampleForce(rule, batch, q, state.edges, samples, sum.x);
    sum.store(result);
}

inline void assumedForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    ElementVector& result
)
{
    AssumedState state;
    makeState(rule, batch, q, state);
    Pack fieldForce[maxAreaPoints][F::size];
    MidStrain onGap[maxAreaPoints];
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        onGap[p] = fieldForceAndStress(rule, batch, state, p, fieldForce[p]);
    }
    assembleForce(rule, batch, q, state, onGap, fieldForce, result);
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
