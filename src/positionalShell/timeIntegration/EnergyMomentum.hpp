// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energy-momentum conserving integrator, (T4)-(T12): balance of momentum over the
// step with an algorithmic internal force whose work is exactly the change of the
// strain energy and which has no resultant and no moment. Without loads, damping and
// supports, linear and angular momentum and the energy are constant to the accuracy
// of the iteration, whatever the step. For materials with a constant tangent.
//
// The acceleration in its states is that of the middle of the step.

#ifndef positionalShell_EnergyMomentum_hpp
#define positionalShell_EnergyMomentum_hpp

#include "TimeIntegrator.hpp"

namespace positionalShell
{

class EnergyMomentum : public TimeIntegrator
{
public:

    //- The model must live as long as the integrator. Throws
    //  std::invalid_argument for a material whose tangent depends on the strain,
    //  and unless massDamping >= 0.
    explicit EnergyMomentum
    (
        const ShellModel& model,
        const MotionOptions& options = {}
    );

protected:

    DynamicStep doStep
    (
        const ShellState& start, double dt, const Loads&, const GivenForce&
    ) override;

    double errorConstant() const override { return 1.0/12; }
};

} // namespace positionalShell

#endif
