// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over the integration points of a batch of elements. Included once for each
// instruction set, with SHELL_KERNEL_NAMESPACE naming it.

#include "PointKernel.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

//- Fields at an area point from the unknowns of the elements, (S3)
SHELL_INLINE void interpolate
(
    const AreaPoint& point,
    const ElementVector& q,
    Pack* f
)
{
    for (int k = 0; k < F::size; ++k) f[k] = Pack(0);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const double* phi = point.phi[j];
        const LaneValues* node = &q.x[dofsPerNode*j];
        for (int c = 0; c < 3; ++c)
        {
            f[F::m1 + c] += phi[1]*node[c];
            f[F::m2 + c] += phi[2]*node[c];
            f[F::g + c] += phi[0]*node[3 + c];
            f[F::g1 + c] += phi[1]*node[3 + c];
            f[F::g2 + c] += phi[2]*node[3 + c];
        }
        for (int d = 0; d < 3; ++d) f[F::a + d] += phi[d]*node[6];
    }
}

//- Weighted contravariant stress; C: where to leave the tangent of a material
//  that is not linear (null when it is not wanted)
SHELL_INLINE void stress
(
    const ElementBatch& batch,
    std::size_t k,
    const Pack* e,
    Pack* S,
    LaneValues* C
)
{
    if (!batch.transforms.empty())
    {
        LaneValues strain[6];
        LaneValues result[6];
        for (int u = 0; u < 6; ++u) e[u].store(strain[u]);
        generalResponse(batch, k, strain, result, C);
        for (int u = 0; u < 6; ++u) S[u] = result[u];
        return;
    }
    const LaneValues* linear = batch.points[k].C;
    for (int u = 0; u < 6; ++u)
    {
        S[u] = linear[packedIndex(u, 0)]*e[0];
        for (int v = 1; v < 6; ++v) S[u] += linear[packedIndex(u, v)]*e[v];
    }
}

//- Force or tangent with respect to the fields of one area point: sums through
//  the thickness
struct FieldTangent
{
    Pack K[F::size][F::size];
};

SHELL_INLINE void fieldForce
(
    const ElementRule& rule,
    const ElementBatch& batch,
    std::size_t firstPoint,
    const Pack* f,
    Pack* force
)
{
    for (int k = 0; k < F::size; ++k) force[k] = Pack(0);
    for (std::size_t z = 0; z < rule.thickness.size(); ++z)
    {
        const std::size_t k = firstPoint + z;
        const BaseVectors b =
            baseVectors(f, batch.halfThickness, rule.thickness[z].xi);
        Pack e[6];
        Pack S[6];
        Pack t[3][3];
        covariantStrain(b, batch.points[k].metric, e);
        stress(batch, k, e, S, nullptr);
        tractions(b, S, t);
        addFieldForce(b, f, t, force);
    }
}

//- strain(k, zeta, b, e): the strain that gives the stress at an integration point,
//  where the base vectors are b
template<class StrainAt>
SHELL_INLINE void fieldTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    std::size_t firstPoint,
    const Pack* f,
    const StrainAt& strain,
    FieldTangent& tangent
)
{
    for (int u = 0; u < F::size; ++u)
    {
        for (int v = 0; v < F::size; ++v) tangent.K[u][v] = Pack(0);
    }
    for (std::size_t z = 0; z < rule.thickness.size(); ++z)
    {
        const std::size_t k = firstPoint + z;
        const double zeta = rule.thickness[z].xi;
        const BaseVectors b = baseVectors(f, batch.halfThickness, zeta);
        Pack e[6];
        Pack S[6];
        Pack t[3][3];
        LaneValues general[21];
        strain(k, zeta, b, e);
        stress(batch, k, e, S, general);
        const LaneValues* C =
            batch.transforms.empty() ? batch.points[k].C : general;
        Pack Q[6][3][3];
        tractions(b, S, t);
        stressDerivatives(b, C, Q);
        addFieldTangent(b, f, S, Q, t, tangent.K);
    }
    for (int u = 0; u < F::size; ++u)
    {
        for (int v = 0; v < u; ++v) tangent.K[u][v] = tangent.K[v][u];
    }
}

//- Z = (field tangent) (fields of node j), 18 x 7, column by column, (S14)
struct NodeColumns
{
    Pack Z[dofsPerNode][F::size];
};

SHELL_INLINE void nodeColumns
(
    const AreaPoint& point,
    int j,
    const FieldTangent& tangent,
    NodeColumns& columns
)
{
    const Pack N = point.phi[j][0];
    const Pack N1 = point.phi[j][1];
    const Pack N2 = point.phi[j][2];
    const auto& K = tangent.K;
    for (int c = 0; c < 3; ++c)
    {
        for (int u = 0; u < F::size; ++u)
        {
            columns.Z[c][u] = N1*K[F::m1 + c][u] + N2*K[F::m2 + c][u];
            columns.Z[3 + c][u] = N*K[F::g + c][u] + N1*K[F::g1 + c][u]
                + N2*K[F::g2 + c][u];
        }
    }
    for (int u = 0; u < F::size; ++u)
    {
        columns.Z[6][u] = N*K[F::a][u] + N1*K[F::a1][u] + N2*K[F::a2][u];
    }
}

//- Column c of the block of nodes i and j: sum over the area points of
//  (fields of node i)^T Z
SHELL_INLINE void pairColumn
(
    const ElementRule& rule,
    int i,
    int c,
    const NodeColumns* columns,
    Pack* column
)
{
    for (int r = 0; r < dofsPerNode; ++r) column[r] = Pack(0);
    const std::size_t nArea = rule.area.size();
    for (std::size_t p = 0; p < nArea; ++p)
    {
        const Pack N = rule.area[p].phi[i][0];
        const Pack N1 = rule.area[p].phi[i][1];
        const Pack N2 = rule.area[p].phi[i][2];
        const Pack* Z = columns[p].Z[c];
        for (int r = 0; r < 3; ++r)
        {
            column[r] += N1*Z[F::m1 + r] + N2*Z[F::m2 + r];
            column[3 + r] +=
                N*Z[F::g + r] + N1*Z[F::g1 + r] + N2*Z[F::g2 + r];
        }
        column[6] += N*Z[F::a] + N1*Z[F::a1] + N2*Z[F::a2];
    }
}

//- Weighted energy at a point
SHELL_INLINE Pack pointEnergy
(
    const ElementBatch& batch,
    std::size_t k,
    const Pack* e
)
{
    if (!batch.transforms.empty())
    {
        LaneValues strain[6];
        LaneValues own;
        for (int u = 0; u < 6; ++u) e[u].store(strain[u]);
        generalEnergy(batch, k, strain, own);
        return own;
    }
    Pack S[6];
    Pack sum(0);
    stress(batch, k, e, S, nullptr);
    for (int u = 0; u < 6; ++u) sum += 0.5*(S[u]*e[u]);
    return sum;
}

//- Force on the nodes from that on the fields of an area point; the first nodes may
//  be left out
SHELL_INLINE void addNodeForces
(
    const AreaPoint& point,
    const Pack* s,
    Pack* sum,
    int firstNode = 0
)
{
    for (int i = firstNode; i < nodesPerElement; ++i)
    {
        const double* phi = point.phi[i];
        Pack* node = &sum[dofsPerNode*i];
        for (int c = 0; c < 3; ++c)
        {
            node[c] += phi[1]*s[F::m1 + c] + phi[2]*s[F::m2 + c];
            node[3 + c] += phi[0]*s[F::g + c] + phi[1]*s[F::g1 + c]
                + phi[2]*s[F::g2 + c];
        }
        node[6] += phi[0]*s[F::a] + phi[1]*s[F::a1] + phi[2]*s[F::a2];
    }
}

inline void energy
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    LaneValues& result
)
{
    Pack sum(0);
    std::size_t k = 0;
    for (const AreaPoint& point : rule.area)
    {
        Pack f[F::size];
        interpolate(point, q, f);
        for (const LinePoint& z : rule.thickness)
        {
            Pack e[6];
            covariantStrain
            (
                baseVectors(f, batch.halfThickness, z.xi),
                batch.points[k].metric, e
            );
            sum += pointEnergy(batch, k, e);
            ++k;
        }
    }
    sum.store(result);
}

//- Forces of the nodes from those of the fields, (S11)
struct NodalSums
{
    Pack x[dofsPerElement];

    SHELL_INLINE NodalSums()
    {
        for (Pack& own : x) own = Pack(0);
    }

    SHELL_INLINE void add(const AreaPoint& point, const Pack* s)
    {
        addNodeForces(point, s, x);
    }

    SHELL_INLINE void store(ElementVector& result) const
    {
        for (int k = 0; k < dofsPerElement; ++k) x[k].store(result.x[k]);
    }
};

inline void force
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    ElementVector& result
)
{
    const std::size_t nThickness = rule.thickness.size();
    NodalSums sum;
    for (std::size_t p = 0; p < rule.area.size(); ++p)
    {
        Pack f[F::size];
        Pack s[F::size];
        interpolate(rule.area[p], q, f);
        fieldForce(rule, batch, p*nThickness, f, s);
        sum.add(rule.area[p], s);
    }
    sum.store(result);
}

//- Strain of the state itself, as fieldTangent wants it
SHELL_INLINE auto ownStrain(const ElementBatch& batch)
{
    return [&batch](std::size_t k, double, const BaseVectors& b, Pack* e)
    {
        covariantStrain(b, batch.points[k].metric, e);
    };
}

//- K += factor (fields of node i)^T (field tangents) (fields of node j), (S14)
inline void addNodePairs
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const std::vector<FieldTangent>& tangents,
    double factor,
    SystemMatrix& K
)
{
    const std::size_t nArea = rule.area.size();

    // Node by node, so that what is worked on stays in the first-level cache
    std::vector<NodeColumns> columns(nArea);
    for (int j = 0; j < nodesPerElement; ++j)
    {
        for (std::size_t p = 0; p < nArea; ++p)
        {
            nodeColumns(rule.area[p], j, tangents[p], columns[p]);
        }
        for (int i = j; i < nodesPerElement; ++i)
        {
            LaneValues block[dofsPerNode*dofsPerNode];
            for (int c = 0; c < dofsPerNode; ++c)
            {
                Pack column[dofsPerNode];
                pairColumn(rule, i, c, columns.data(), column);
                for (int r = 0; r < dofsPerNode; ++r)
                {
                    (factor*column[r]).store(block[dofsPerNode*c + r]);
                }
            }
            scatterBlock(batch, i, j, block, K);
        }
    }
}

inline void addTangent
(
    const ElementRule& rule,
    const ElementBatch& batch,
    const ElementVector& q,
    SystemMatrix& K
)
{
    const std::size_t nArea = rule.area.size();
    const std::size_t nThickness = rule.thickness.size();
    std::vector<FieldTangent> tangents(nArea);
    for (std::size_t p = 0; p < nArea; ++p)
    {
        Pack f[F::size];
        interpolate(rule.area[p], q, f);
        fieldTangent
        (
            rule, batch, p*nThickness, f, ownStrain(batch), tangents[p]
        );
    }
    addNodePairs(rule, batch, tangents, 1, K);
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
