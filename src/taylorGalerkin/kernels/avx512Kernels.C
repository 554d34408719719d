/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasKernels.H"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#pragma GCC optimize("no-math-errno")
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma")

#define GAS_KERNEL_NAMESPACE avx512
#define GAS_LANES 8
#include "kernelSet.H"

#pragma GCC pop_options

#endif
