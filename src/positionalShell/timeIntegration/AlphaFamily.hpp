// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrators with Newmark's expansions and the equation of motion weighted over
// the step, (T1)-(T2): Newmark, generalised-alpha.

#ifndef positionalShell_AlphaFamily_hpp
#define positionalShell_AlphaFamily_hpp

#include "TimeIntegrator.hpp"

namespace positionalShell
{

struct AlphaParameters
{
    double alphaM = 0;      // weight of the start in the inertia
    double alphaF = 0;      // weight of the start in all other forces
    double beta = 0.25;
    double gamma = 0.5;
};

class AlphaFamily : public TimeIntegrator
{
public:

    AlphaFamily
    (
        const std::string& name,
        const ShellModel& model,
        const MotionOptions& options,
        const AlphaParameters& parameters
    );

    const AlphaParameters& parameters() const { return parameters_; }

protected:

    DynamicStep doStep
    (
        const ShellState& start, double dt, const Loads&, const GivenForce&
    ) override;

    double errorConstant() const override;

private:

    AlphaParameters parameters_;
};

} // namespace positionalShell

#endif
