// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Newton solves: r(u) = 0 for the equations of a model.

#ifndef positionalShell_EquilibriumProblem_hpp
#define positionalShell_EquilibriumProblem_hpp

#include "KindNorms.hpp"
#include "ShellModel.hpp"

namespace positionalShell
{

class EquilibriumProblem
{
public:

    virtual ~EquilibriumProblem() = default;

    virtual const ShellModel& model() const = 0;

    //- Full position vector of the current guess
    virtual const Vector& position() const = 0;

    //- Full residual (driving force minus resistance) of the current guess; scale:
    //  by kind, the largest norm of its contributions
    virtual void residual(Vector& full, KindNorms& scale) = 0;

    //- Positions of a solution nearby, from which the first guess departs
    virtual const Vector& origin() const = 0;

    //- K += minus d(residual)/dq without what inertia contributes, with
    //  the predicted stress, (N3)
    virtual void addStiffness(const StressPrediction&, SystemMatrix& K) = 0;

    //- K += the contribution of inertia and damping
    virtual void addInertia(SystemMatrix&) {}

    //- Positions that rigid ties are taken at in the balance
    virtual const Vector& tieArms() const { return position(); }

    //- Forces at rigid ties that the residual holds, spread over their nodes
    virtual std::vector<TieForce> tieForces() const { return {}; }

    //- Full vector that increments are added to: positions, or their change
    virtual Vector& unknowns() = 0;

    //- The unknowns were changed
    virtual void update() {}
};

} // namespace positionalShell

#endif
