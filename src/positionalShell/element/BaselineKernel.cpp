// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementBatch.hpp"

#define SHELL_KERNEL_NAMESPACE baseline
#define SHELL_REGISTER_DOUBLES 2
#include "AssumedTwoStates.hpp"

namespace positionalShell
{

const BatchKernel& baselineKernel(ElementForm form)
{
    static const BatchKernel displacement
    {
        baseline::energy, baseline::force, baseline::addTangent,
        baseline::addExtrapolatedTangent, baseline::conservingForce,
        baseline::addConservingTangent, nullptr
    };
    static const BatchKernel assumedStrain
    {
        baseline::assumedEnergy, baseline::assumedForce, baseline::addAssumedTangent,
        baseline::addExtrapolatedAssumedTangent, baseline::assumedConservingForce,
        baseline::addConservingAssumedTangent, baseline::strainGap
    };
    return form == ElementForm::displacement ? displacement : assumedStrain;
}

} // namespace positionalShell
