/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasKernels.H"

#define GAS_KERNEL_NAMESPACE baseline
#define GAS_LANES 2
#include "kernelSet.H"
