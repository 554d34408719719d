// SPDX-License-Identifier: GPL-3.0-or-later
//
// The discrete shell: strain energy and its first two derivatives, constant mass,
// and integrals of a state. Seven unknowns per node; motion (S2), strain (S5),
// energy (S8), force (S11), tangent (S13), mass (S15).
//
// Owns copies of mesh, sections and degree-of-freedom map. Nothing changes after
// construction: const functions may be used from several threads.

#ifndef positionalShell_ShellModel_hpp
#define positionalShell_ShellModel_hpp

#include "DofMap.hpp"
#include "ElementForm.hpp"
#include "Section.hpp"
#include "ShellMesh.hpp"
#include "ShellState.hpp"
#include "StressPrediction.hpp"
#include "SystemMatrix.hpp"

#include <memory>
#include <vector>

namespace positionalShell
{

class ElementData;

struct IntegrationOptions
{
    int areaPoints = 7;         // triangleRule: 6, 7, 12, 16, 25
    int thicknessPoints = 3;    // gaussRule: 2 ... 10
};

class ShellModel
{
public:

    //- Throws std::invalid_argument, naming element or section, for: elements
    //  in no or in two sections, thickness not positive, missing material, a
    //  shell so thick and curved that its body folds over, a DofMap of another
    //  size.
    ShellModel
    (
        ShellMesh mesh,
        std::vector<Section> sections,
        DofMap dofs,
        IntegrationOptions integration = {},
        ElementForm form = ElementForm::displacement
    );

    ~ShellModel();
    ShellModel(const ShellModel&) = delete;
    ShellModel& operator=(const ShellModel&) = delete;

    // Parts

        const ShellMesh& mesh() const { return mesh_; }
        const DofMap& dofs() const { return dofs_; }
        const std::vector<Section>& sections() const { return sections_; }
        const Section& section(int element) const;
        double thickness(int element) const { return section(element).thickness; }
        const IntegrationOptions& integration() const { return integration_; }
        ElementForm elementForm() const { return form_; }

        //- Initial state at rest; prescribed unknowns at their values of time t
        ShellState initialState(double t = 0) const;

    // Elastic energy, full vectors

        //- U(q) [J]
        double strainEnergy(const Vector& q) const;

        //- dU/dq [N, N m]
        Vector internalForce(const Vector& q) const;
        void addInternalForce(const Vector& q, Vector& force) const;

        //- K += d2U/dq2 on equations; lower triangle (see SystemMatrix)
        void addTangent(const Vector& q, SystemMatrix& K) const;

        //- The same with a predicted stress, (N3): free of the membrane forces
        //  that an increment of bending makes; the same as above where the
        //  prediction is for q and starts there
        void addTangent
        (
            const StressPrediction& stress, const Vector& q, SystemMatrix& K
        ) const;

        //- Force between two states with force*(end - start) = U(end) - U(start)
        //  and the symmetries of the energy, (T8)-(T10); for
        //  linear materials
        void addConservingForce
        (
            const Vector& start, const Vector& end, Vector& force
        ) const;

        //- K += its symmetric tangent by the end, (T11)
        void addConservingTangent
        (
            const StressPrediction& endStress, const Vector& start,
            const Vector& end, SystemMatrix& K
        ) const;

        //- The whole symmetric tangent on equations
        SparseMatrix tangent(const Vector& q) const;

        //- Least det A over the integration points, A of (S4): positive as long
        //  as no point of the body is turned inside out
        double minimumVolumeRatio(const Vector& q) const;

        //- What assumed strains add to those of the motion, (A7): covariant, (S7),
        //  by element, then area point; empty for the displacement form
        std::vector<Strain> strainGaps(const Vector& q) const;

    // Inertia: M is constant, zero on the thickness strain a

        //- M v, full vectors
        Vector massTimes(const Vector& v) const;
        void addMassTimes(double factor, const Vector& v, Vector& f) const;

        //- K += factor*M on equations; lower triangle
        void addMass(double factor, SystemMatrix& K) const;

        //- The whole mass matrix on equations
        SparseMatrix massMatrix() const;

        //- Whether an equation has no inertia
        bool massless(int equation) const { return massless_[equation]; }

        double totalMass() const;
        double kineticEnergy(const Vector& v) const;
        Vec3 linearMomentum(const Vector& v) const;

        //- About the origin, with the rotary part of the directors, (S17)
        Vec3 angularMomentum(const Vector& q, const Vector& v) const;

        Vec3 centreOfMass(const Vector& q) const;

    // Surface

        //- Mid-surface area in state q
        double area(const Vector& q) const;

    // Matrices

        //- A matrix with the sparsity of the model, zero
        SystemMatrix makeMatrix() const;

private:

    ShellMesh mesh_;
    std::vector<Section> sections_;
    DofMap dofs_;
    IntegrationOptions integration_;
    ElementForm form_;
    std::vector<int> sectionOfElement_;
    std::unique_ptr<ElementData> elements_;
    std::shared_ptr<const SparsityMap> sparsity_;

    // Inertia, (S15): node by node for positions and for directors, and the
    // same on equations
    SparseMatrix positionMass_;
    SparseMatrix directorMass_;
    SystemMatrix mass_;
    std::vector<bool> massless_;

    void makeMass();
};

} // namespace positionalShell

#endif
