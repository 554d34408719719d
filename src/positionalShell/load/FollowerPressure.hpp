// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pressure p that stays normal to the current surface xi3 = face of an element
// set, (S26), with exact tangent (S27), unsymmetric in general. Positive
// pressure pushes against the normal, as on the upper face; a negative value is
// pressure on the lower face. face 0 (default) is the mid-surface, +1 the upper
// and -1 the lower face: there the force reaches the directors through its
// lever arm as well.
//
// Keeps the pressures of the last instant: not for several threads at once.

#ifndef positionalShell_FollowerPressure_hpp
#define positionalShell_FollowerPressure_hpp

#include "Load.hpp"
#include "PressureField.hpp"

#include <array>
#include <string>
#include <vector>

namespace positionalShell
{

class FollowerPressure : public Load
{
public:

    FollowerPressure
    (
        const ShellModel& model,
        const std::string& elementSet,
        double pressure,
        TimeFunctionPtr factor = constant(1),
        double face = 0
    );

    //- Pressure that depends on the initial place on the mid-surface
    FollowerPressure
    (
        const ShellModel& model,
        const std::string& elementSet,
        const PressureFieldPtr& pressure,
        TimeFunctionPtr factor = constant(1),
        double face = 0
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

    using NodeBlocks = std::array
    <
        std::array<Eigen::Matrix3d, nodesPerElement>, nodesPerElement
    >;

    std::vector<int> elements_;
    TimeFunctionPtr factor_;
    double face_;

    //- At the initial places of the integration points, by loaded element
    std::vector<PressureHistory> places_;

    //- Pressures there at the last instant asked for: the same in all iterations of
    //  a step
    mutable double lastTime_;
    mutable std::vector<double> last_;

    const std::vector<double>& pressures(double time) const;

    //- K += blocks of face nodes, on positions and through the arm on directors
    static void addBlocks
    (
        int element, double arm, const NodeBlocks&, SystemMatrix& K
    );
};

} // namespace positionalShell

#endif
