// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generalised force as a function of state and time. Adds into a full force
// vector the work-conjugate of dq; a load that depends on q gives the tangent
// -dF/dq as well, so that Newton stays quadratic.

#ifndef positionalShell_Load_hpp
#define positionalShell_Load_hpp

#include "ShellModel.hpp"
#include "TimeFunction.hpp"

#include <memory>
#include <vector>

namespace positionalShell
{

class Load
{
public:

    virtual ~Load() = default;

    //- force += F(q, t)
    virtual void addForce
    (
        const ShellModel& model,
        const Vector& q,
        double time,
        Vector& force
    ) const = 0;

    //- Whether F depends on q
    virtual bool dependsOnPosition() const { return false; }

    //- K -= factor*dF/dq on equations
    virtual void addTangent
    (
        const ShellModel& /*model*/,
        const Vector& /*q*/,
        double /*time*/,
        double /*factor*/,
        SystemMatrix& /*K*/
    ) const
    {}

    //- What of F is spread over rigid ties to stand for forces at them: its tangent
    //  is that of those forces, (C7)
    virtual void addTieForces
    (
        const ShellModel& /*model*/,
        const Vector& /*q*/,
        double /*time*/,
        std::vector<TieForce>& /*forces*/
    ) const
    {}
};

using LoadPtr = std::shared_ptr<const Load>;
using Loads = std::vector<LoadPtr>;

//- Sum of the loads as a full vector
Vector totalForce
(
    const Loads& loads,
    const ShellModel& model,
    const Vector& q,
    double time
);

//- Forces at rigid ties of all loads, times a factor
std::vector<TieForce> totalTieForces
(
    const Loads& loads,
    const ShellModel& model,
    const Vector& q,
    double time,
    double factor = 1
);

} // namespace positionalShell

#endif
