// SPDX-License-Identifier: GPL-3.0-or-later

#include "Newmark.hpp"

namespace positionalShell
{

Newmark::Newmark(const ShellModel& model, const NewmarkOptions& options)
:
    AlphaFamily
    (
        "Newmark", model, options, {0, 0, options.beta, options.gamma}
    )
{
    const double least = 0.25*(options.gamma + 0.5)*(options.gamma + 0.5);
    require
    (
        options.gamma >= 0.5,
        "gamma " + std::to_string(options.gamma) + " is less than 1/2"
    );
    require
    (
        options.beta >= least*(1 - 1e-12),
        "beta " + std::to_string(options.beta)
      + " is less than (gamma + 1/2)^2/4 = " + std::to_string(least)
    );
}

} // namespace positionalShell
