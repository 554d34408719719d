// SPDX-License-Identifier: GPL-3.0-or-later
//
// All elements of a model, in batches of four, with their reference state:
// gathers unknowns, runs the kernels, scatters results.

#ifndef positionalShell_ElementData_hpp
#define positionalShell_ElementData_hpp

#include "ElementBatch.hpp"
#include "Section.hpp"
#include "ShellMesh.hpp"
#include "StressPrediction.hpp"

#include <vector>

namespace positionalShell
{

class SystemMatrix;

class ElementData
{
public:

    //- The mesh must live as long as this object. Throws std::invalid_argument,
    //  naming the element, where the body folds over (thickness too large for
    //  the curvature) and where a section's axis is normal to the shell.
    ElementData
    (
        const ShellMesh& mesh,
        const std::vector<Section>& sections,
        const std::vector<int>& sectionOfElement,
        int areaPoints,
        int thicknessPoints,
        ElementForm form
    );

    double energy(const Vector& q) const;
    void addForce(const Vector& q, Vector& f) const;
    void addTangent(const Vector& q, SystemMatrix& K) const;
    double leastVolumeRatio(const Vector& q) const;

    //- Gap (A7) of a state as covariant strains (S7), by element, then area point;
    //  empty for the displacement form (ElementDataResults.cpp)
    std::vector<Strain> strainGaps(const Vector& q) const;

    // Two states (ElementDataTwoStates.cpp), see BatchKernel

        void addExtrapolatedTangent
        (
            const StressPrediction& stress, const Vector& q,
            SystemMatrix& K
        ) const;
        void addConservingForce
        (
            const Vector& start, const Vector& end, Vector& f
        ) const;
        void addConservingTangent
        (
            const StressPrediction& endStress, const Vector& start,
            const Vector& end, SystemMatrix& K
        ) const;

private:

    const ShellMesh& mesh_;
    const BatchKernel& kernel_;
    ElementRule rule_;
    std::vector<ElementBatch> batches_;

    void addBatch
    (
        const Vector& q0,
        const Section& section,
        const std::vector<int>& elements
    );
    void setReference
    (
        const Vector& q0,
        const Section& section,
        ElementBatch& batch,
        int lane
    );
    void gather(const ElementBatch&, const Vector& q, ElementVector&) const;
    void scatter(const ElementBatch&, const ElementVector&, Vector& f) const;
};

} // namespace positionalShell

#endif
