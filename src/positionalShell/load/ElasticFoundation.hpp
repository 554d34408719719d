// SPDX-License-Identifier: GPL-3.0-or-later
//
// Springs that hold an element set to its initial place: traction
// -k (u.d) d per initial mid-surface area, or -k u without a direction, (S26a).
// Linear, so the work over a step is minus the change of the springs' energy.

#ifndef positionalShell_ElasticFoundation_hpp
#define positionalShell_ElasticFoundation_hpp

#include "Load.hpp"

#include <array>
#include <string>
#include <vector>

namespace positionalShell
{

class ElasticFoundation : public Load
{
public:

    //- stiffness k [N/m3]; direction d of any length, zero: all directions.
    //  Throws std::invalid_argument unless k > 0.
    ElasticFoundation
    (
        const ShellModel& model,
        const std::string& elementSet,
        double stiffness,
        const Vec3& direction = Vec3::Zero(),
        TimeFunctionPtr factor = constant(1)
    );

    void addForce
    (
        const ShellModel&, const Vector& q, double time, Vector& force
    ) const override;

    bool dependsOnPosition() const override { return true; }

    void addTangent
    (
        const ShellModel&, const Vector& q, double time, double factor,
        SystemMatrix& K
    ) const override;

private:

    //- int N_i N_j dA of an element
    using ElementMass = Eigen::Matrix<double, nodesPerElement, nodesPerElement>;

    std::vector<int> elements_;
    std::vector<ElementMass> integrals_;

    //- k d d^T, or k I
    Eigen::Matrix3d stiffness_;
    TimeFunctionPtr factor_;
};

} // namespace positionalShell

#endif
