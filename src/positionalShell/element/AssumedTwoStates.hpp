// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of a batch of elements with assumed strains that need two states: what
// TwoStateSums.hpp has for the strains of the motion, (A13)-(A15). Included by the
// batch kernels only.

#include "AssumedTangent.hpp"
#include "TwoStateSums.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

//- factor*(a + sign*b)
SHELL_INLINE ElementVector combined
(
    double factor,
    const ElementVector& a,
    double sign,
    const ElementVector& b
)
{
    ElementVector c;
    for (int k = 0; k < dofsPerElement; ++k)
    {
        (factor*(Pack(a.x[k]) + sign*Pack(b.x[k]))).store(c.x[k]);
    }
    return c;
}

//- State with the gap that the state before predicts in first order, (A13)
inline void makeExtrapolatedState
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& before,
    const ElementVector& after,
    AssumedState& state
)
{
    const ElementVector d = combined(1, after, -1, before);
    AssumedState change;
    makeFields(rule, d, change);
    stateGap(rule, batch, d, change.f, change.edges, change.gap);
    makeState(rule, batch, after, state);
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (int k = 0; k < M::size; ++k)
        {
            state.gap[p].v[k] = state.gap[p].v[k] - change.gap[p].v[k];
        }
    }
}

//- Give a state the mean of the gaps of two others
inline void setMeanGap
(
    const ElementRule& rule,
    const AssumedState& a,
    const AssumedState& b,
    AssumedState& state
)
{
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (int k = 0; k < M::size; ++k)
        {
            state.gap[p].v[k] = 0.5*(a.gap[p].v[k] + b.gap[p].v[k]);
        }
    }
}

//- (N3) with (A13)
inline void addExtrapolatedAssumedTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& before,
    const ElementVector& after,
    const ElementVector& q,
    SystemMatrix& K
)
{
    AssumedState first;
    AssumedState predicted;
    AssumedState state;
    makeFields(rule, before, first);
    makeExtrapolatedState(rule, batch, before, after, predicted);
    makeFields(rule, q, state);
    setMeanGap(rule, predicted, predicted, state);
    addAssumedTangentWith
    (
        rule, batch, q, state,
        [&](std::size_t p, std::size_t k, double zeta, const BaseVectors&, Pack* e)
        {
            extrapolatedStrain
            (
                first.f[p], predicted.f[p], batch.halfThickness, zeta,
                batch.points[k].metric, e
            );
        },
        1, K
    );
}

//- (T11) with (A13); states as for addConservingTangent
inline void addConservingAssumedTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& start,
    const ElementVector& before,
    const ElementVector& after,
    const ElementVector& end,
    SystemMatrix& K
)
{
    const ElementVector middle = combined(0.5, start, 1, end);
    AssumedState first;
    AssumedState known;
    AssumedState predicted;
    AssumedState state;
    makeState(rule, batch, start, first);
    makeFields(rule, before, known);
    makeExtrapolatedState(rule, batch, before, after, predicted);
    makeFields(rule, middle, state);
    setMeanGap(rule, first, predicted, state);
    addAssumedTangentWith
    (
        rule, batch, middle, state,
        [&](std::size_t p, std::size_t k, double zeta, const BaseVectors&, Pack* e)
        {
            meanPredictedStrain
            (
                first.f[p], known.f[p], predicted.f[p], batch.halfThickness,
                zeta, batch.points[k].metric, e
            );
        },
        0.5, K
    );
}

//- (T8)-(T10) with (A14), (A15)
inline void assumedConservingForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& start,
    const ElementVector& end,
    ElementVector& result
)
{
    const ElementVector middle = combined(0.5, start, 1, end);
    AssumedState first;
    AssumedState last;
    AssumedState state;
    makeState(rule, batch, start, first);
    makeState(rule, batch, end, last);
    makeFields(rule, middle, state);
    setMeanGap(rule, first, last, state);

    Pack fieldForce[maxAreaPoints][F::size];
    MidStrain onGap[maxAreaPoints];
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        const Pack* f0 = first.f[p];
        const Pack* f1 = last.f[p];
        Pack d[F::size];
        Pack resultant[6];
        for (int k = 0; k < F::size; ++k) d[k] = f1[k] - f0[k];
        conservingFieldForce
        (
            rule, batch, p*rule.thickness.size(), state.f[p], d,
            [&](std::size_t k, double zeta, Pack* e)
            {
                meanStrain
                (
                    f0, f1, batch.halfThickness, zeta,
                    batch.points[k].metric, e
                );
                addToStrain(state.gap[p], e);
            },
            fieldForce[p], resultant
        );
        onGap[p] = midStress(resultant);
    }
    assembleForce(rule, batch, middle, state, onGap, fieldForce, result);
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
