// SPDX-License-Identifier: GPL-3.0-or-later

#include "GeneralisedAlpha.hpp"

namespace positionalShell
{

AlphaParameters GeneralisedAlpha::parametersOf(double spectralRadius)
{
    AlphaParameters p;
    p.alphaM = (2*spectralRadius - 1)/(spectralRadius + 1);
    p.alphaF = spectralRadius/(spectralRadius + 1);
    const double shift = p.alphaF - p.alphaM;
    p.beta = 0.25*(1 + shift)*(1 + shift);
    p.gamma = 0.5 + shift;
    return p;
}

GeneralisedAlpha::GeneralisedAlpha
(
    const ShellModel& model,
    const GeneralisedAlphaOptions& options
)
:
    AlphaFamily
    (
        "generalisedAlpha", model, options,
        parametersOf(options.spectralRadius)
    )
{
    require
    (
        options.spectralRadius >= 0 && options.spectralRadius <= 1,
        "spectralRadius " + std::to_string(options.spectralRadius)
      + " is not between 0 and 1"
    );
}

} // namespace positionalShell
