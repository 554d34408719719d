// SPDX-License-Identifier: GPL-3.0-or-later

// Before the change of the instruction set: code of shared headers stays baseline
#include "ElementBatch.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#pragma GCC push_options
#pragma GCC target("avx2,fma")

#define SHELL_KERNEL_NAMESPACE avx2
#define SHELL_REGISTER_DOUBLES 4
#include "AssumedTwoStates.hpp"

#pragma GCC pop_options

namespace positionalShell
{

const BatchKernel* avx2Kernel(ElementForm form)
{
    static const BatchKernel displacement
    {
        avx2::energy, avx2::force, avx2::addTangent,
        avx2::addExtrapolatedTangent, avx2::conservingForce,
        avx2::addConservingTangent, nullptr
    };
    static const BatchKernel assumedStrain
    {
        avx2::assumedEnergy, avx2::assumedForce, avx2::addAssumedTangent,
        avx2::addExtrapolatedAssumedTangent, avx2::assumedConservingForce,
        avx2::addConservingAssumedTangent, avx2::strainGap
    };
    return form == ElementForm::displacement ? &displacement : &assumedStrain;
}

} // namespace positionalShell

#else

namespace positionalShell
{

const BatchKernel* avx2Kernel(ElementForm)
{
    return nullptr;
}

} // namespace positionalShell

#endif
