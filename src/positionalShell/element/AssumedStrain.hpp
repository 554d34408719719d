// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assumed strains of the mid-surface: what is sampled, and the gap between the
// assumed strain and that of the motion, (A1)-(A8). The gap is added to the
// covariant strains of all points through the thickness.
//
// Mid-surface strains, in this order (M below):
//     membrane    e_tt along the directions of the three edges, (A2)
//     shear       2 e_13, 2 e_23 of the mid-surface
//     thickness   e_33 of the mid-surface
//
// Included by the batch kernels only.

#include "BatchSums.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

namespace M
{
    constexpr int membrane = 0, shear = 3, thickness = 5;
    constexpr int size = 6;
}

constexpr int nEdgePoints = AssumedInterpolation::nEdgePoints;
constexpr int pointsPerEdge = AssumedInterpolation::pointsPerEdge;

//- Strains, or the stresses that work on them, at an area point
struct MidStrain
{
    Pack v[M::size];
};

//- What the assumed strains are made of; or the stresses that work on it
struct MidSamples
{
    MidStrain area[maxAreaPoints];
    Pack membrane[nEdgePoints];             // e_tt
    Pack shear[nEdgePoints];                // 2 e_t3
    Pack thickness[nodesPerElement];        // e_33
};

//- Along an edge: derivative of the position, and director
struct EdgeVectors
{
    Pack m[3];
    Pack g[3];
};

//- Strains (S7) from those of the mid-surface
SHELL_INLINE void addToStrain(const MidStrain& mid, Pack* e)
{
    const Pack* v = mid.v;
    e[0] += v[M::membrane];
    e[1] += v[M::membrane + 2];
    e[2] += v[M::thickness];
    e[3] += v[M::membrane] + v[M::membrane + 2] - v[M::membrane + 1];
    e[4] += v[M::shear + 1];
    e[5] += v[M::shear];
}

//- The transposed of addToStrain
SHELL_INLINE MidStrain midStress(const Pack* S)
{
    MidStrain mid;
    mid.v[M::membrane] = S[0] + S[3];
    mid.v[M::membrane + 1] = Pack(0) - S[3];
    mid.v[M::membrane + 2] = S[1] + S[3];
    mid.v[M::shear] = S[5];
    mid.v[M::shear + 1] = S[4];
    mid.v[M::thickness] = S[2];
    return mid;
}

// Gap from samples, part by part, (A8)

    SHELL_INLINE void addMembraneGap
    (
        const ElementRule& rule,
        const MidSamples& samples,
        MidStrain* gap
    )
    {
        const auto& points = rule.assumed.points;
        for (int c = 0; c < 3; ++c)
        {
            Pack moment[3] = {Pack(0), Pack(0), Pack(0)};
            for (std::size_t p = 0; p < points.size(); ++p)
            {
                const Pack e = samples.area[p].v[M::membrane + c];
                for (int l = 0; l < 3; ++l) moment[l] += points[p].moment[l]*e;
            }
            const Pack* edge = &samples.membrane[pointsPerEdge*c];
            for (std::size_t p = 0; p < points.size(); ++p)
            {
                Pack& v = gap[p].v[M::membrane + c];
                v = v - samples.area[p].v[M::membrane + c];
                for (int l = 0; l < 3; ++l)
                {
                    v += points[p].membraneEdge[c][l]*edge[l]
                        + points[p].membraneMoment[c][l]*moment[l];
                }
            }
        }
    }

    SHELL_INLINE void addShearGap
    (
        const ElementRule& rule,
        const MidSamples& samples,
        MidStrain* gap
    )
    {
        const auto& points = rule.assumed.points;
        Pack moment[3] = {Pack(0), Pack(0), Pack(0)};
        for (std::size_t p = 0; p < points.size(); ++p)
        {
            const Pack* e = &samples.area[p].v[M::shear];
            const double* l = points[p].moment;
            moment[0] += l[0]*e[0];
            moment[1] += l[0]*e[1];
            moment[2] += l[1]*e[0] + l[2]*e[1];
        }
        for (std::size_t p = 0; p < points.size(); ++p)
        {
            for (int d = 0; d < 2; ++d)
            {
                Pack sum = Pack(0) - samples.area[p].v[M::shear + d];
                for (int l = 0; l < 3; ++l)
                {
                    sum += points[p].shearMoment[d][l]*moment[l];
                }
                for (int s = 0; s < nEdgePoints; ++s)
                {
                    sum += points[p].shearEdge[d][s]*samples.shear[s];
                }
                gap[p].v[M::shear + d] += sum;
            }
        }
    }

    SHELL_INLINE void addThicknessGap
    (
        const ElementRule& rule,
        const MidSamples& samples,
        MidStrain* gap
    )
    {
        for (std::size_t p = 0; p < rule.area.size(); ++p)
        {
            Pack sum = Pack(0) - samples.area[p].v[M::thickness];
            for (int j = 0; j < nodesPerElement; ++j)
            {
                sum += rule.area[p].phi[j][0]*samples.thickness[j];
            }
            gap[p].v[M::thickness] += sum;
        }
    }

//- Stress on the samples that does the work of the stress n on the gap
SHELL_INLINE void stressOnSamples
(
    const ElementRule& rule,
    const MidStrain* n,
    MidSamples& samples
)
{
    const auto& points = rule.assumed.points;
    Pack membrane[3][3] = {};
    Pack shear[3] = {};
    for (Pack& x : samples.membrane) x = Pack(0);
    for (Pack& x : samples.shear) x = Pack(0);
    for (Pack& x : samples.thickness) x = Pack(0);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        for (int c = 0; c < 3; ++c)
        {
            const Pack& x = n[p].v[M::membrane + c];
            for (int l = 0; l < 3; ++l)
            {
                samples.membrane[pointsPerEdge*c + l] +=
                    points[p].membraneEdge[c][l]*x;
                membrane[c][l] += points[p].membraneMoment[c][l]*x;
            }
        }
        for (int d = 0; d < 2; ++d)
        {
            const Pack& x = n[p].v[M::shear + d];
            for (int l = 0; l < 3; ++l) shear[l] += points[p].shearMoment[d][l]*x;
            for (int s = 0; s < nEdgePoints; ++s)
            {
                samples.shear[s] += points[p].shearEdge[d][s]*x;
            }
        }
        for (int j = 0; j < nodesPerElement; ++j)
        {
            samples.thickness[j] += rule.area[p].phi[j][0]*n[p].v[M::thickness];
        }
    }
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        const double* l = points[p].moment;
        Pack* s = samples.area[p].v;
        for (int c = 0; c < 3; ++c)
        {
            s[M::membrane + c] = l[0]*membrane[c][0] + l[1]*membrane[c][1]
                + l[2]*membrane[c][2] - n[p].v[M::membrane + c];
        }
        for (int d = 0; d < 2; ++d)
        {
            s[M::shear + d] =
                l[0]*shear[d] + l[1 + d]*shear[2] - n[p].v[M::shear + d];
        }
        s[M::thickness] = Pack(0) - n[p].v[M::thickness];
    }
}

// Samples of a state, (A1), (A2)

    //- Half the squares and products of the mid-surface's base vectors: the
    //  initial ones are in the reference gap
    SHELL_INLINE MidStrain midStrain(const Pack* f, double halfThickness)
    {
        const Pack* m1 = f + F::m1;
        const Pack* m2 = f + F::m2;
        const Pack* g = f + F::g;
        Pack d[3];
        for (int c = 0; c < 3; ++c) d[c] = m2[c] - m1[c];
        MidStrain mid;
        mid.v[M::membrane] = 0.5*dot(m1, m1);
        mid.v[M::membrane + 1] = 0.5*dot(d, d);
        mid.v[M::membrane + 2] = 0.5*dot(m2, m2);
        mid.v[M::shear] = halfThickness*dot(m1, g);
        mid.v[M::shear + 1] = halfThickness*dot(m2, g);
        mid.v[M::thickness] = (0.5*halfThickness*halfThickness)*dot(g, g);
        return mid;
    }

    SHELL_INLINE EdgeVectors edgeVectors
    (
        const EdgePoint& point,
        const ElementVector& q
    )
    {
        EdgeVectors v;
        for (int c = 0; c < 3; ++c)
        {
            v.m[c] = Pack(0);
            v.g[c] = Pack(0);
            for (int k = 0; k < EdgePoint::nNodes; ++k)
            {
                const LaneValues* node = &q.x[dofsPerNode*point.nodes[k]];
                v.m[c] += point.dN[k]*node[c];
                v.g[c] += point.N[k]*node[3 + c];
            }
        }
        return v;
    }

    //- Gap of a state, fields f at the area points
    SHELL_INLINE void stateGap
    (
        const ElementRule& rule,
        const ElementBatch& batch,
        const ElementVector& q,
        const Pack (*f)[F::size],
        const EdgeVectors* edges,
        MidStrain* gap
    )
    {
        const double c = batch.halfThickness;
        MidSamples samples;
        for (std::size_t p = 0; p < rule.area.size(); ++p)
        {
            samples.area[p] = midStrain(f[p], c);
            for (Pack& x : gap[p].v) x = Pack(0);
        }
        for (int s = 0; s < nEdgePoints; ++s)
        {
            samples.membrane[s] = 0.5*dot(edges[s].m, edges[s].m);
            samples.shear[s] = c*dot(edges[s].m, edges[s].g);
        }
        for (int j = 0; j < nodesPerElement; ++j)
        {
            Pack g[3];
            for (int k = 0; k < 3; ++k) g[k] = Pack(q.x[dofsPerNode*j + 3 + k]);
            samples.thickness[j] = (0.5*c*c)*dot(g, g);
        }
        addMembraneGap(rule, samples, gap);
        addShearGap(rule, samples, gap);
        addThicknessGap(rule, samples, gap);
    }

// Force of stresses on the samples, (A9)

    SHELL_INLINE void addAreaForce
    (
        const Pack* f,
        const MidStrain& stress,
        double halfThickness,
        Pack* force
    )
    {
        const Pack* s = stress.v;
        for (int c = 0; c < 3; ++c)
        {
            const Pack m1 = f[F::m1 + c];
            const Pack m2 = f[F::m2 + c];
            const Pack g = halfThickness*f[F::g + c];
            const Pack across = s[M::membrane + 1]*(m2 - m1);
            force[F::m1 + c] += s[M::membrane]*m1 - across + s[M::shear]*g;
            force[F::m2 + c] +=
                s[M::membrane + 2]*m2 + across + s[M::shear + 1]*g;
            force[F::g + c] += halfThickness
                *(s[M::shear]*m1 + s[M::shear + 1]*m2 + s[M::thickness]*g);
        }
    }

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
