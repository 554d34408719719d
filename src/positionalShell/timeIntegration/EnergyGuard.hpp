// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells steps that have converged to a state which the forces cannot have brought the
// shell to: Newton's iterations may find another root of the step's equations, far away
// and with any strain energy. The scheme balances the change of the kinetic energy and
// the work of the mean internal force against the work of all other forces; what the
// strain energy gains beyond that work comes from nothing, (T15). A step is spurious
// when this is more than all energy at its start and the energy that was put in, (T16).
//
// Costs the strain energy at the end of each step, and internal forces only where the
// energy has more than doubled. Steps that conserve energy by construction
// (DynamicStep::meanForce given) pass.

#ifndef positionalShell_EnergyGuard_hpp
#define positionalShell_EnergyGuard_hpp

#include "TimeIntegrator.hpp"

namespace positionalShell
{

class EnergyGuard
{
public:

    //- The model must live as long as this object
    explicit EnergyGuard(const ShellModel& model) : model_(model) {}

    //- Energy from nothing in a spurious step [J]; 0: the step is none
    double excess(const ShellState& start, const DynamicStep& step);

private:

    const ShellModel& model_;

    //- The last state whose strain energy was asked for: a step starts where the one
    //  before ended
    Vector kept_;
    double keptEnergy_ = 0;

    double strainEnergy(const Vector& position);
};

} // namespace positionalShell

#endif
