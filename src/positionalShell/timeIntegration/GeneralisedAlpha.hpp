// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generalised-alpha method of Chung and Hulbert (1993), J. Applied Mechanics 60,
// 371-375, with its parameters from the spectral radius at infinite frequency,
// (T1)-(T3): 1 keeps all frequencies, 0 removes the highest in one step.

#ifndef positionalShell_GeneralisedAlpha_hpp
#define positionalShell_GeneralisedAlpha_hpp

#include "AlphaFamily.hpp"

namespace positionalShell
{

struct GeneralisedAlphaOptions : MotionOptions
{
    double spectralRadius = 0.8;
};

class GeneralisedAlpha : public AlphaFamily
{
public:

    //- The model must live as long as the integrator. Throws
    //  std::invalid_argument unless 0 <= spectralRadius <= 1 and
    //  massDamping >= 0.
    explicit GeneralisedAlpha
    (
        const ShellModel& model,
        const GeneralisedAlphaOptions& options = {}
    );

    //- (T3)
    static AlphaParameters parametersOf(double spectralRadius);
};

} // namespace positionalShell

#endif
