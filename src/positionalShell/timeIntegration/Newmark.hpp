// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newmark's method for M q'' + C q' + dU/dq = F, C = c M, (S29)-(S33);
// paper eq. (18)-(19).
//
// A step is a function of its start: it changes nothing but the result, so a
// coupling scheme repeats it with other loads from the same start.

#ifndef positionalShell_Newmark_hpp
#define positionalShell_Newmark_hpp

#include "Load.hpp"
#include "Newton.hpp"

namespace positionalShell
{

struct NewmarkOptions
{
    double beta = 0.25;
    double gamma = 0.5;
    double massDamping = 0;         // c [1/s]
    NewtonOptions newton;

    NewmarkOptions() { newton.tangentUpdate = TangentUpdate::whenSlow; }
};

struct DynamicStep
{
    bool converged = false;
    ShellState state;               // end of the step; last iterate if not converged
    Vector externalForce;           // full vector at the end of the step
    NewtonReport report;
};

class Newmark
{
public:

    //- The model must live as long as the integrator. Throws
    //  std::invalid_argument unless gamma >= 1/2, beta >= (gamma + 1/2)^2/4
    //  (unconditional stability) and massDamping >= 0.
    explicit Newmark(const ShellModel& model, NewmarkOptions options = {});

    //- Consistent start: a in equilibrium for the given positions and
    //  directors, accelerations from (S31). state holds time, position, velocity.
    //  Throws std::runtime_error when a cannot be brought into equilibrium.
    void initialise
    (
        ShellState& state,
        const Loads& loads,
        const Vector* fixedForce = nullptr
    );

    //- From start to start.time + dt with the loads of the end. fixedForce: given
    //  generalised force at the end of the step (full vector), may be null.
    DynamicStep step
    (
        const ShellState& start,
        double dt,
        const Loads& loads,
        const Vector* fixedForce = nullptr
    );

    const NewmarkOptions& options() const { return options_; }
    const LinearSolverReport& linearReport() const
    {
        return newton_.linearReport();
    }

private:

    const ShellModel& model_;
    NewmarkOptions options_;
    Newton newton_;
    double keptTimeStep_ = 0;

    void equilibrateThickness(ShellState&, const Loads&, const Vector*);
    void setAccelerations(ShellState&, const Loads&, const Vector*);
};

} // namespace positionalShell

#endif
