// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static equilibrium dU/dq = F by load steps: time is the load parameter, loads
// and prescribed motions are taken at start.time + k (endTime - start.time)/n.

#ifndef positionalShell_StaticSolver_hpp
#define positionalShell_StaticSolver_hpp

#include "Load.hpp"
#include "Newton.hpp"

#include <functional>

namespace positionalShell
{

struct StaticStep
{
    bool converged = false;
    ShellState state;           // of the last converged step
    NewtonReport report;        // of the last step tried
};

class StaticSolver
{
public:

    //- The model must live as long as the solver
    explicit StaticSolver(const ShellModel& model, NewtonOptions options = {});

    //- One step to time t from the start state; fixedForce: further dead
    //  generalised force (full vector), may be null
    StaticStep step
    (
        const ShellState& start,
        double t,
        const Loads& loads,
        const Vector* fixedForce = nullptr
    );

    //- n equal steps; stops at the first that does not converge. observer is
    //  called after every converged step.
    StaticStep run
    (
        const ShellState& start,
        double endTime,
        int nSteps,
        const Loads& loads,
        const std::function<void(const StaticStep&)>& observer = nullptr
    );

    const LinearSolverReport& linearReport() const
    {
        return newton_.linearReport();
    }

private:

    const ShellModel& model_;
    Newton newton_;
};

} // namespace positionalShell

#endif
