// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementBatch.hpp"

#define SHELL_KERNEL_NAMESPACE baseline
#define SHELL_REGISTER_DOUBLES 2
#include "BatchSums.hpp"
#include "TwoStateSums.hpp"

namespace positionalShell
{

const BatchKernel& baselineKernel()
{
    static const BatchKernel kernel
    {
        baseline::energy, baseline::force, baseline::addTangent,
        baseline::addExtrapolatedTangent, baseline::conservingForce,
        baseline::addConservingTangent
    };
    return kernel;
}

} // namespace positionalShell
