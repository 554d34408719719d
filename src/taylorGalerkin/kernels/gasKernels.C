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
std::vector<gasKernels<dim>> gasKernels<dim>::available()
{
    std::vector<gasKernels<dim>> sets{baseline::kernelSet<dim>("baseline")};

    #if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    {
        sets.push_back(avx2::kernelSet<dim>("AVX2"));
    }
    if
    (
        __builtin_cpu_supports("avx512f")
     && __builtin_cpu_supports("avx512dq")
     && __builtin_cpu_supports("avx512vl")
    )
    {
        sets.push_back(avx512::kernelSet<dim>("AVX-512"));
    }
    #endif

    return sets;
}


template<int dim>
const gasKernels<dim>& gasKernels<dim>::best()
{
    static const gasKernels<dim> widest = available().back();
    return widest;
}


template struct gasKernels<1>;
template struct gasKernels<2>;
template struct gasKernels<3>;

} // End namespace gasKernel
