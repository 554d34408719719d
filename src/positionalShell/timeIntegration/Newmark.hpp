// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newmark's method, (S29)-(S33); paper eq. (18)-(19).

#ifndef positionalShell_Newmark_hpp
#define positionalShell_Newmark_hpp

#include "AlphaFamily.hpp"

namespace positionalShell
{

struct NewmarkOptions : MotionOptions
{
    double beta = 0.25;
    double gamma = 0.5;
};

class Newmark : public AlphaFamily
{
public:

    //- The model must live as long as the integrator. Throws
    //  std::invalid_argument unless gamma >= 1/2, beta >= (gamma + 1/2)^2/4
    //  (unconditional stability) and massDamping >= 0.
    explicit Newmark
    (
        const ShellModel& model,
        const NewmarkOptions& options = {}
    );
};

} // namespace positionalShell

#endif
