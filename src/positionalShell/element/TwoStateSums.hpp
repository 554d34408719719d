// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over the integration points of a batch that need two states of the elements:
// the tangent with stresses extrapolated from the iterate before (N3), and force
// and tangent of the energy-momentum integrator, (T7)-(T11). Included after
// BatchSums.hpp, within the same namespaces.

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

//- What the base vectors change by in first order where the fields change by d, (S6)
SHELL_INLINE void firstVariation
(
    const BaseVectors& b,
    const Pack* f,
    const Pack* d,
    Pack v[3][3]
)
{
    const Pack dp = b.square*d[F::a];
    const Pack ds = b.linear*d[F::a];
    for (int c = 0; c < 3; ++c)
    {
        for (int k = 0; k < 2; ++k)
        {
            v[k][c] = d[F::m(k) + c] + b.p*d[F::dg(k) + c]
                + dp*f[F::dg(k) + c] + b.r[k]*d[F::g + c]
                + b.square*d[F::da(k)]*f[F::g + c];
        }
        v[2][c] = b.s*d[F::g + c] + ds*f[F::g + c];
    }
}

//- Strain of the fields f as the state before predicts it in first order, (N3)
SHELL_INLINE void extrapolatedStrain
(
    const Pack* before,
    const Pack* f,
    double halfThickness,
    double zeta,
    const LaneValues* metric,
    Pack* e
)
{
    const BaseVectors b = baseVectors(before, halfThickness, zeta);
    Pack d[F::size];
    Pack v[3][3];
    for (int k = 0; k < F::size; ++k) d[k] = f[k] - before[k];
    firstVariation(b, before, d, v);
    covariantStrain(b, metric, e);
    for (int i = 0; i < 3; ++i) e[i] += dot(b.a[i], v[i]);
    e[3] += dot(b.a[0], v[1]) + dot(v[0], b.a[1]);
    e[4] += dot(b.a[1], v[2]) + dot(v[1], b.a[2]);
    e[5] += dot(b.a[0], v[2]) + dot(v[0], b.a[2]);
}

//- Strains of two states, their mean
SHELL_INLINE void meanStrain
(
    const Pack* f0,
    const Pack* f1,
    double halfThickness,
    double zeta,
    const LaneValues* metric,
    Pack* e
)
{
    Pack e1[6];
    covariantStrain(baseVectors(f0, halfThickness, zeta), metric, e);
    covariantStrain(baseVectors(f1, halfThickness, zeta), metric, e1);
    for (int u = 0; u < 6; ++u) e[u] = 0.5*(e[u] + e1[u]);
}

//- Mean of the strain of a state and of one extrapolated from a second state to a
//  third, (T11)
SHELL_INLINE void meanPredictedStrain
(
    const Pack* f0,
    const Pack* before,
    const Pack* after,
    double halfThickness,
    double zeta,
    const LaneValues* metric,
    Pack* e
)
{
    Pack e0[6];
    covariantStrain(baseVectors(f0, halfThickness, zeta), metric, e0);
    extrapolatedStrain(before, after, halfThickness, zeta, metric, e);
    for (int u = 0; u < 6; ++u) e[u] = 0.5*(e0[u] + e[u]);
}

//- (N3)
inline void addExtrapolatedTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& before,
    const ElementVector& after,
    const ElementVector& q,
    SystemMatrix& K
)
{
    std::vector<FieldTangent> tangents(rule.area.size());
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        Pack f0[F::size];
        Pack f1[F::size];
        Pack f[F::size];
        interpolate(rule.area[p], before, f0);
        interpolate(rule.area[p], after, f1);
        interpolate(rule.area[p], q, f);
        fieldTangent
        (
            rule, batch, p*rule.thickness.size(), f,
            [&](std::size_t k, double zeta, const BaseVectors&, Pack* e)
            {
                extrapolatedStrain
                (
                    f0, f1, batch.halfThickness, zeta,
                    batch.points[k].metric, e
                );
            },
            tangents[p]
        );
    }
    addNodePairs(rule, batch, tangents, 1, K);
}

//- (T11): start of the step; states that the stress at its end is extrapolated
//  from and to; present iterate of the end
inline void addConservingTangent
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
    std::vector<FieldTangent> tangents(rule.area.size());
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        Pack f0[F::size];
        Pack fb[F::size];
        Pack fa[F::size];
        Pack f1[F::size];
        Pack mid[F::size];
        interpolate(rule.area[p], start, f0);
        interpolate(rule.area[p], before, fb);
        interpolate(rule.area[p], after, fa);
        interpolate(rule.area[p], end, f1);
        for (int k = 0; k < F::size; ++k) mid[k] = 0.5*(f0[k] + f1[k]);
        fieldTangent
        (
            rule, batch, p*rule.thickness.size(), mid,
            [&](std::size_t k, double zeta, const BaseVectors&, Pack* e)
            {
                meanPredictedStrain
                (
                    f0, fb, fa, batch.halfThickness, zeta,
                    batch.points[k].metric, e
                );
            },
            tangents[p]
        );
    }
    addNodePairs(rule, batch, tangents, 0.5, K);
}

//- What the variation of the thickness strain through a step adds to the force of
//  its middle, (T10). b, f: of the middle; d: end minus start
SHELL_INLINE void addConservingCorrection
(
    const BaseVectors& b,
    const Pack* f,
    const Pack* d,
    const Pack* S,
    Pack* force
)
{
    const Pack dp = b.square*d[F::a];
    const Pack ds = b.linear*d[F::a];
    BaseVectors byScalars;      // base vectors' change by a and its derivatives
    BaseVectors byVectors;      // and by positions and directors
    for (int c = 0; c < 3; ++c)
    {
        for (int k = 0; k < 2; ++k)
        {
            byScalars.a[k][c] = dp*f[F::dg(k) + c]
                + b.square*d[F::da(k)]*f[F::g + c];
            byVectors.a[k][c] = d[F::m(k) + c] + b.p*d[F::dg(k) + c]
                + b.r[k]*d[F::g + c];
        }
        byScalars.a[2][c] = ds*f[F::g + c];
        byVectors.a[2][c] = b.s*d[F::g + c];
    }
    Pack tau[3][3];
    Pack sigma[3][3];
    tractions(byScalars, S, tau);
    tractions(byVectors, S, sigma);

    const Pack* dg = d + F::g;
    for (int k = 0; k < 2; ++k)
    {
        const Pack dr = b.square*d[F::da(k)];
        for (int c = 0; c < 3; ++c)
        {
            force[F::dg(k) + c] += 0.25*(dp*tau[k][c]);
            force[F::g + c] += 0.25*(dr*tau[k][c]);
        }
        force[F::a] += 0.25*b.square*dot(d + F::dg(k), sigma[k]);
        force[F::da(k)] += 0.25*b.square*dot(dg, sigma[k]);
    }
    for (int c = 0; c < 3; ++c) force[F::g + c] += 0.25*(ds*tau[2][c]);
    force[F::a] += 0.25*b.linear*dot(dg, sigma[2]);
}

//- Force on the fields of an area point, (T10), and the stress that made it, summed
//  through the thickness. strain(k, zeta, e): mean strain of both states; mid: their
//  mean; d: end minus start
template<class StrainAt>
SHELL_INLINE void conservingFieldForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    std::size_t firstPoint,
    const Pack* mid,
    const Pack* d,
    const StrainAt& strain,
    Pack* force,
    Pack* resultant
)
{
    for (int k = 0; k < F::size; ++k) force[k] = Pack(0);
    for (int u = 0; u < 6; ++u) resultant[u] = Pack(0);
    for (std::size_t z = 0; z < rule.thickness.size(); ++z)
    {
        const std::size_t k = firstPoint + z;
        const double zeta = rule.thickness[z].xi;
        const BaseVectors b = baseVectors(mid, batch.halfThickness, zeta);
        Pack e[6];
        Pack S[6];
        Pack t[3][3];
        strain(k, zeta, e);
        stress(batch, k, e, S, nullptr);
        tractions(b, S, t);
        addFieldForce(b, mid, t, force);
        addConservingCorrection(b, mid, d, S, force);
        for (int u = 0; u < 6; ++u) resultant[u] += S[u];
    }
}

//- (T8)-(T10)
inline void conservingForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& start,
    const ElementVector& end,
    ElementVector& result
)
{
    NodalSums sum;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        Pack f0[F::size];
        Pack f1[F::size];
        Pack mid[F::size];
        Pack d[F::size];
        Pack s[F::size];
        Pack resultant[6];
        interpolate(rule.area[p], start, f0);
        interpolate(rule.area[p], end, f1);
        for (int k = 0; k < F::size; ++k)
        {
            mid[k] = 0.5*(f0[k] + f1[k]);
            d[k] = f1[k] - f0[k];
        }
        conservingFieldForce
        (
            rule, batch, p*rule.thickness.size(), mid, d,
            [&](std::size_t k, double zeta, Pack* e)
            {
                meanStrain
                (
                    f0, f1, batch.halfThickness, zeta,
                    batch.points[k].metric, e
                );
            },
            s, resultant
        );
        sum.add(rule.area[p], s);
    }
    sum.store(result);
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
