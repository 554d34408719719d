// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four elements of one section that are computed together, with their reference
// state at the integration points, and the kernels that sum over the points.
//
// Plain data without Eigen: the kernels are compiled for more than one instruction
// set, and code of shared headers must not be.

#ifndef positionalShell_ElementBatch_hpp
#define positionalShell_ElementBatch_hpp

#include "ElementForm.hpp"
#include "Quadrature.hpp"
#include "ShellSizes.hpp"

#include <cstddef>
#include <vector>

namespace positionalShell
{

class Material;
class SystemMatrix;

//- Elements that are computed together
constexpr int lanes = 4;

//- A number for each of the elements
struct LaneValues
{
    alignas(lanes*sizeof(double)) double lane[lanes];
};

//- Basis functions at an area point, the same for all elements
struct AreaPoint
{
    double weight;
    double phi[nodesPerElement][3];     // N, dN/dxi1, dN/dxi2
};

//- Reference state at an integration point, (S5)-(S9)
struct ReferencePoint
{
    LaneValues weight;          // quadrature weight times det A0
    LaneValues metric[6];       // G_ij: 11 22 33 12 23 13

    //- Contravariant elastic matrix times weight, lower triangle row by row,
    //  where the material is linear
    LaneValues C[21];
};

//- Point of an edge where assumed strains are tied to the motion, (A2)
struct EdgePoint
{
    static constexpr int nNodes = 4;
    int nodes[nNodes];
    double N[nNodes];
    double dN[nNodes];      // along the edge, over its parametric length
};

//- Assumed strains from edge values and moments, (A3)-(A6)
struct AssumedInterpolation
{
    static constexpr int pointsPerEdge = 3;
    static constexpr int nEdgePoints = 3*pointsPerEdge;
    static constexpr int nMoments = 3;

    //- Values at an area point by what they are made of
    struct AtPoint
    {
        double membraneEdge[3][pointsPerEdge];  // [direction][point of its edge]
        double membraneMoment[3][nMoments];     // [direction][moment of the same]
        double shearEdge[2][nEdgePoints];
        double shearMoment[2][nMoments];
        double moment[nMoments];                // weight times 1, xi1', xi2'
    };

    EdgePoint edge[nEdgePoints];
    std::vector<AtPoint> points;
};

//- Assumed minus compatible strains of the initial state at an area point, (A8)
struct ReferenceGap
{
    LaneValues v[6];
};

//- Local Cartesian from covariant strain, (S9)
struct StrainTransform
{
    LaneValues T[6][6];
};

struct ElementBatch
{
    const Material* material;
    double halfThickness;

    //- Number of elements in use; the lanes after it repeat the last one
    int nElements;
    int elements[lanes];

    //- By area point, then thickness point
    std::vector<ReferencePoint> points;

    //- Filled only where the material is not linear
    std::vector<StrainTransform> transforms;

    //- By area point; filled only for assumed strains
    std::vector<ReferenceGap> gaps;
};

//- Rules shared by all batches
struct ElementRule
{
    std::vector<AreaPoint> area;
    std::vector<LinePoint> thickness;

    //- Without points for the displacement form
    AssumedInterpolation assumed;
};

//- Greatest number of points of an area rule
constexpr int maxAreaPoints = 25;

//- Unknowns or forces of four elements
struct ElementVector
{
    LaneValues x[dofsPerElement];   // [7*place + component]
};

//- Sums over the integration points of a batch. One set per instruction set and
//  element form.
struct BatchKernel
{
    //- U of each element
    void (*energy)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& q,
        LaneValues& energy
    );

    //- dU/dq of each element
    void (*force)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& q,
        ElementVector& force
    );

    //- K += d2U/dq2 of each element
    void (*addTangent)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& q,
        SystemMatrix& K
    );

    //- The same with the stress at one state, extrapolated to another, (N3)
    void (*addExtrapolatedTangent)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& before,
        const ElementVector& after, const ElementVector& q, SystemMatrix& K
    );

    //- Force that does the work U(end) - U(start) on the way, (T8)-(T10)
    void (*conservingForce)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& start,
        const ElementVector& end, ElementVector& force
    );

    //- Its symmetric tangent with respect to the end, (T11)
    void (*addConservingTangent)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& start,
        const ElementVector& before, const ElementVector& after,
        const ElementVector& end, SystemMatrix& K
    );

    //- Gap between assumed and compatible strains of a state, by area point;
    //  null for the displacement form
    void (*gap)
    (
        const ElementRule&, const ElementBatch&, const ElementVector& q,
        ReferenceGap* gap
    );
};

//- The fastest that the processor can run
const BatchKernel& batchKernel(ElementForm form);

//- For any processor of the architecture
const BatchKernel& baselineKernel(ElementForm form);

//- With AVX2 and fused multiply-add; null where the compiler cannot make it
const BatchKernel* avx2Kernel(ElementForm form);

// What the kernels ask of the rest, one function call away

    //- Weighted stress and, unless C is null, weighted tangent (lower triangle
    //  row by row) of a material that is not linear, (S9)
    void generalResponse
    (
        const ElementBatch&, std::size_t point, const LaneValues* e,
        LaneValues* S, LaneValues* C
    );

    //- Weighted energy of a material that is not linear
    void generalEnergy
    (
        const ElementBatch&, std::size_t point, const LaneValues* e,
        LaneValues& energy
    );

    //- Add the 7 x 7 block of the nodes i >= j to the matrix, for each element
    void scatterBlock
    (
        const ElementBatch&, int i, int j, const LaneValues* block,
        SystemMatrix& K
    );

} // namespace positionalShell

#endif
