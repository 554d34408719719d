// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static equilibrium dU/dq = F by load steps: time is the load parameter, loads
// and prescribed motions are taken at start.time + k (endTime - start.time)/n.
//
// A load step that does not converge is cut and repeated: on the way the loads are
// those of the times between, less a part of what the start lacks in equilibrium
// that goes to zero, (N4). So also loads that do not grow with time are applied in
// parts.

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
    NewtonReport report;        // of the last part tried
    int parts = 0;              // that the step was taken in
};

struct StaticOptions
{
    NewtonOptions newton;

    //- The shortest part is the load step over 2^maxCuts
    int maxCuts = 10;

    StaticOptions(const NewtonOptions& n = {}, int cuts = 10)
    :
        newton(n), maxCuts(cuts)
    {}
};

class StaticSolver
{
public:

    //- The model must live as long as the solver
    explicit StaticSolver(const ShellModel& model, StaticOptions options = {});

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
    StaticOptions options_;
    Newton newton_;
};

} // namespace positionalShell

#endif
