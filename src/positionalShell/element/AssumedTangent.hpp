// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent of a batch of elements with assumed strains, column by column, (A10)-(A12).
// Included by the batch kernels only.

#include "AssumedSums.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

//- Second derivatives of the energy at an area point by fields and gap; the force of
//  the samples' stress is in the fields
struct AssumedPoint
{
    FieldTangent fields;
    Pack mixed[F::size][M::size];
    Pack gap[M::size][M::size];
};

//- Rows (S7) to rows of the mid-surface, see midStress
SHELL_INLINE void toMid(const Pack* S, Pack* mid)
{
    const MidStrain own = midStress(S);
    for (int k = 0; k < M::size; ++k) mid[k] = own.v[k];
}

//- mixed += dS/dfields at one point through the thickness, rows (S7)
SHELL_INLINE void addStressDerivatives
(
    const BaseVectors& b,
    const Pack* f,
    const Pack Q[6][3][3],
    Pack (*mixed)[6]
)
{
    for (int u = 0; u < 6; ++u)
    {
        for (int c = 0; c < 3; ++c)
        {
            for (int d = 0; d < 2; ++d)
            {
                mixed[F::m(d) + c][u] += Q[u][d][c];
                mixed[F::dg(d) + c][u] += b.p*Q[u][d][c];
            }
            mixed[F::g + c][u] += b.r[0]*Q[u][0][c] + b.r[1]*Q[u][1][c]
                + b.s*Q[u][2][c];
        }
        for (int d = 0; d < 2; ++d)
        {
            mixed[F::a][u] += b.square*dot(f + F::dg(d), Q[u][d]);
            mixed[F::da(d)][u] += b.square*dot(f + F::g, Q[u][d]);
        }
        mixed[F::a][u] += b.linear*dot(f + F::g, Q[u][2]);
    }
}

//- Sums through the thickness; returns the stress on the gap. strain(p, k, zeta, b, e):
//  what the gap of the state is added to
template<class StrainAt>
inline MidStrain assumedPoint
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const AssumedState& state,
    std::size_t p,
    const StrainAt& strain,
    AssumedPoint& point
)
{
    Pack resultant[6] = {};
    Pack mixed[F::size][6] = {};
    Pack gap[6][6] = {};
    for (auto& row : point.fields.K) for (Pack& x : row) x = Pack(0);
    for (std::size_t z = 0; z < rule.thickness.size(); ++z)
    {
        const std::size_t k = p*rule.thickness.size() + z;
        const double zeta = rule.thickness[z].xi;
        const Pack* f = state.f[p];
        const BaseVectors b = baseVectors(f, batch.halfThickness, zeta);
        Pack e[6];
        Pack S[6];
        Pack t[3][3];
        Pack Q[6][3][3];
        LaneValues general[21];
        strain(p, k, zeta, b, e);
        addToStrain(state.gap[p], e);
        stress(batch, k, e, S, general);
        const LaneValues* C =
            batch.transforms.empty() ? batch.points[k].C : general;
        tractions(b, S, t);
        stressDerivatives(b, C, Q);
        addFieldTangent(b, f, S, Q, t, point.fields.K);
        addStressDerivatives(b, f, Q, mixed);
        for (int u = 0; u < 6; ++u)
        {
            resultant[u] += S[u];
            for (int v = 0; v < 6; ++v) gap[u][v] += Pack(C[packedIndex(u, v)]);
        }
    }
    for (int u = 0; u < F::size; ++u) toMid(mixed[u], point.mixed[u]);
    Pack half[6][6];
    for (int u = 0; u < 6; ++u) toMid(gap[u], half[u]);
    for (int k = 0; k < M::size; ++k)
    {
        Pack column[6];
        for (int u = 0; u < 6; ++u) column[u] = half[u][k];
        toMid(column, point.gap[k]);
    }
    return midStress(resultant);
}

//- Stress of the samples times second derivatives of the samples by the fields, and
//  the lower triangle
SHELL_INLINE void completeFieldTangent
(
    const MidStrain& stress,
    double h,
    FieldTangent& tangent
)
{
    auto& K = tangent.K;
    const Pack* s = stress.v;
    for (int c = 0; c < 3; ++c)
    {
        K[F::m1 + c][F::m1 + c] += s[M::membrane] + s[M::membrane + 1];
        K[F::m2 + c][F::m2 + c] += s[M::membrane + 2] + s[M::membrane + 1];
        K[F::m1 + c][F::m2 + c] += Pack(0) - s[M::membrane + 1];
        K[F::m1 + c][F::g + c] += h*s[M::shear];
        K[F::m2 + c][F::g + c] += h*s[M::shear + 1];
        K[F::g + c][F::g + c] += (h*h)*s[M::thickness];
    }
    for (int u = 0; u < F::size; ++u)
    {
        for (int v = 0; v < u; ++v) K[u][v] = K[v][u];
    }
}

//- Gap components that an unknown of each kind changes
struct GapRange
{
    int first;
    int last;
};

SHELL_INLINE GapRange gapRange(int component)
{
    if (component < 3) return {M::membrane, M::thickness};
    if (component < 6) return {M::shear, M::size};
    return {0, 0};
}

//- Combination of the rows of the fields that unknown c of a node changes
template<int size>
SHELL_INLINE void fieldColumn
(
    const double* phi,
    int c,
    const Pack (*rows)[size],
    Pack* column
)
{
    for (int u = 0; u < size; ++u)
    {
        if (c < 3)
        {
            column[u] = phi[1]*rows[F::m1 + c][u] + phi[2]*rows[F::m2 + c][u];
        }
        else if (c < 6)
        {
            column[u] = phi[0]*rows[F::g + c - 3][u]
                + phi[1]*rows[F::g1 + c - 3][u] + phi[2]*rows[F::g2 + c - 3][u];
        }
        else
        {
            column[u] = phi[0]*rows[F::a][u] + phi[1]*rows[F::a1][u]
                + phi[2]*rows[F::a2][u];
        }
    }
}

//- Derivatives of all samples by position (c < 3) or director of node j
SHELL_INLINE void sampleColumn
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    const AssumedState& state,
    int j,
    int c,
    MidSamples& d
)
{
    const double h = batch.halfThickness;
    const bool position = c < 3;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        const double* phi = rule.area[p].phi[j];
        const Pack* f = state.f[p];
        Pack* v = d.area[p].v;
        if (position)
        {
            const Pack m1 = f[F::m1 + c];
            const Pack m2 = f[F::m2 + c];
            const Pack g = h*f[F::g + c];
            v[M::membrane] = phi[1]*m1;
            v[M::membrane + 1] = (phi[2] - phi[1])*(m2 - m1);
            v[M::membrane + 2] = phi[2]*m2;
            v[M::shear] = phi[1]*g;
            v[M::shear + 1] = phi[2]*g;
            continue;
        }
        v[M::shear] = (h*phi[0])*f[F::m1 + c - 3];
        v[M::shear + 1] = (h*phi[0])*f[F::m2 + c - 3];
        v[M::thickness] = (h*h*phi[0])*f[F::g + c - 3];
    }
    for (int s = 0; s < nEdgePoints; ++s)
    {
        d.membrane[s] = Pack(0);
        d.shear[s] = Pack(0);
        const EdgePoint& point = rule.assumed.edge[s];
        for (int k = 0; k < EdgePoint::nNodes; ++k)
        {
            if (point.nodes[k] != j) continue;
            const EdgeVectors& v = state.edges[s];
            if (position)
            {
                d.membrane[s] = point.dN[k]*v.m[c];
                d.shear[s] = (h*point.dN[k])*v.g[c];
            }
            else d.shear[s] = (h*point.N[k])*v.m[c - 3];
        }
    }
    for (Pack& x : d.thickness) x = Pack(0);
    if (!position) d.thickness[j] = (h*h)*Pack(q.x[dofsPerNode*j + c]);
}

//- Stress of the samples times their second derivatives: rows of the nodes that
//  share an edge point or are the same as node j
SHELL_INLINE void addSampleStiffness
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const MidSamples& stress,
    int j,
    int c,
    Pack* rows
)
{
    const double h = batch.halfThickness;
    if (c >= 3) rows[dofsPerNode*j + c] += (h*h)*stress.thickness[j];
    for (int s = 0; s < nEdgePoints; ++s)
    {
        const EdgePoint& point = rule.assumed.edge[s];
        for (int k = 0; k < EdgePoint::nNodes; ++k)
        {
            if (point.nodes[k] != j) continue;
            for (int i = 0; i < EdgePoint::nNodes; ++i)
            {
                if (point.nodes[i] < j) continue;
                Pack* row = &rows[dofsPerNode*point.nodes[i]];
                if (c < 3)
                {
                    row[c] += (point.dN[i]*point.dN[k])*stress.membrane[s];
                    row[c + 3] += (h*point.N[i]*point.dN[k])*stress.shear[s];
                }
                else
                {
                    row[c - 3] += (h*point.dN[i]*point.N[k])*stress.shear[s];
                }
            }
        }
    }
}

//- Column c of node j of the element matrix, rows of the nodes from j on, (A12)
SHELL_INLINE void assumedColumn
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    const AssumedState& state,
    const AssumedPoint* points,
    const MidSamples& stress,
    int j,
    int c,
    Pack* rows
)
{
    const GapRange range = gapRange(c);
    MidSamples d;
    MidStrain gap[maxAreaPoints];
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        for (Pack& x : gap[p].v) x = Pack(0);
    }
    if (c < 6) sampleColumn(rule, batch, q, state, j, c, d);
    if (c < 3) addMembraneGap(rule, d, gap);
    if (c < 6) addShearGap(rule, d, gap);
    if (c >= 3 && c < 6) addThicknessGap(rule, d, gap);

    Pack Z[maxAreaPoints][F::size];
    MidStrain onGap[maxAreaPoints];
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        const double* phi = rule.area[p].phi[j];
        fieldColumn<F::size>(phi, c, points[p].fields.K, Z[p]);
        fieldColumn<M::size>(phi, c, points[p].mixed, onGap[p].v);
        for (int k = range.first; k < range.last; ++k)
        {
            const Pack& x = gap[p].v[k];
            for (int u = 0; u < F::size; ++u) Z[p][u] += points[p].mixed[u][k]*x;
            for (int u = 0; u < M::size; ++u)
            {
                onGap[p].v[u] += points[p].gap[k][u]*x;
            }
        }
    }
    stressOnSamples(rule, onGap, d);

    for (int k = dofsPerNode*j; k < dofsPerElement; ++k) rows[k] = Pack(0);
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        addAreaForce(state.f[p], d.area[p], batch.halfThickness, Z[p]);
        addNodeForces(rule.area[p], Z[p], rows, j);
    }
    addSampleForce(rule, batch, q, state.edges, d, rows, j);
    if (c < 6) addSampleStiffness(rule, batch, stress, j, c, rows);
}

//- K += factor times the tangent at q with the stress of strain and gap
template<class StrainAt>
inline void addAssumedTangentWith
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    const AssumedState& state,
    const StrainAt& strain,
    double factor,
    SystemMatrix& K
)
{
    const std::size_t nArea = rule.area.size();
    std::vector<AssumedPoint> points(nArea);
    MidStrain onGap[maxAreaPoints];
    for (std::size_t p = 0; p < nArea; ++p)
    {
        onGap[p] = assumedPoint(rule, batch, state, p, strain, points[p]);
    }
    MidSamples stress;
    stressOnSamples(rule, onGap, stress);
    for (std::size_t p = 0; p < nArea; ++p)
    {
        completeFieldTangent
        (
            stress.area[p], batch.halfThickness, points[p].fields
        );
    }

    constexpr int n = dofsPerNode;
    LaneValues blocks[nodesPerElement][n*n];
    for (int j = 0; j < nodesPerElement; ++j)
    {
        for (int c = 0; c < n; ++c)
        {
            Pack rows[dofsPerElement];
            assumedColumn
            (
                rule, batch, q, state, points.data(), stress, j, c, rows
            );
            for (int i = j; i < nodesPerElement; ++i)
            {
                for (int r = 0; r < n; ++r)
                {
                    (factor*rows[n*i + r]).store(blocks[i][n*c + r]);
                }
            }
        }
        for (int i = j; i < nodesPerElement; ++i)
        {
            scatterBlock(batch, i, j, blocks[i], K);
        }
    }
}

inline void addAssumedTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    SystemMatrix& K
)
{
    AssumedState state;
    makeState(rule, batch, q, state);
    const auto own = ownStrain(batch);
    addAssumedTangentWith
    (
        rule, batch, q, state,
        [&own](std::size_t, std::size_t k, double zeta, const BaseVectors& b, Pack* e)
        {
            own(k, zeta, b, e);
        },
        1, K
    );
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
