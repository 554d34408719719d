/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasKernels.H"

namespace gasKernel
{

namespace baseline { template<int dim> gasKernels<dim> kernelSet(const char*); }

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
namespace avx2 { template<int dim> gasKernels<dim> kernelSet(const char*); }
namespace avx512 { template<int dim> gasKernels<dim> kernelSet(const char*); }
#endif


template<int dim>
const gasKernels<dim>& gasKernels<dim>::best()
{
    static const gasKernels<dim> set = []
    {
        #if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
        if
        (
            __builtin_cpu_supports("avx512f")
         && __builtin_cpu_supports("avx512dq")
         && __builtin_cpu_supports("avx512vl")
        )
        {
            return avx512::kernelSet<dim>("AVX-512");
        }
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        {
            return avx2::kernelSet<dim>("AVX2");
        }
        #endif
        return baseline::kernelSet<dim>("baseline");
    }();
    return set;
}


template struct gasKernels<1>;
template struct gasKernels<2>;
template struct gasKernels<3>;

} // End namespace gasKernel
