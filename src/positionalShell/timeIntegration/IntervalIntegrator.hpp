// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes a shell over an interval of time in as many steps as it needs: one, as long
// as it converges and no error is bounded. A step that does not converge is cut and
// repeated from its start, and so is one that makes energy from nothing (EnergyGuard);
// with an error tolerance the length of the steps follows from the estimate of the
// local error, (T13)-(T14).

#ifndef positionalShell_IntervalIntegrator_hpp
#define positionalShell_IntervalIntegrator_hpp

#include "EnergyGuard.hpp"

namespace positionalShell
{

struct IntervalOptions
{
    //- The shortest step is the interval over 2^maxCuts
    int maxCuts = 10;

    //- Bound of the local error of a step, of positions over the length of the mesh
    //  and of directors; 0: none
    double errorTolerance = 0;
};

class IntervalIntegrator
{
public:

    //- The integrator must live as long as this object. Throws
    //  std::invalid_argument for a negative number of cuts or tolerance.
    IntervalIntegrator(TimeIntegrator& integrator, IntervalOptions options);

    //- Steps from start to start.time + interval; all have converged but perhaps the
    //  last. wanted: length of the first step, 0 for the whole interval; is left at
    //  the length wanted for the next.
    std::vector<DynamicStep> advance
    (
        const ShellState& start,
        double interval,
        const Loads& loads,
        const GivenForce& given,
        double& wanted
    );

private:

    TimeIntegrator& integrator_;
    IntervalOptions options_;
    EnergyGuard guard_;

    //- Take back that a step has converged when it makes energy from nothing
    void refuseSpurious(const ShellState& start, DynamicStep& step);

    //- Length of the next step over that of one with this error, (T14)
    double factor(double error) const;
};

} // namespace positionalShell

#endif
