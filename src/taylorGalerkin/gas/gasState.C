/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasState.H"

template<int dim>
Foam::gasState<dim>::gasState
(
    const gasDynamics::PerfectGas& gas,
    const gasGeometry<dim>& geometry
)
:
    nNodes_(geometry.nNodes()),
    eos(gas),
    rows(geometry.nRows(), uniformRow(0)),
    pRef(0),
    momentumScale(0),
    hasGravity(false),
    gravity(Vec::Zero())
{
    for (gasRow& row : rows)
    {
        row[0] = 1;
        row[place::energy] = 1;
    }
}


template<int dim>
Foam::label Foam::gasState<dim>::derive(const activeParts& active)
{
    long bad = -1;
    for (const activeParts::range& r : active.nodes())
    {
        const long found = gasKernel::gasKernels<dim>::best().derive
        (
            kernelGas(), data(rows), r.from, r.to
        );
        bad = bad < 0 ? found : bad;
    }
    return bad;
}


template<int dim>
void Foam::gasState<dim>::derive(const label node)
{
    constexpr label group = gasKernel::groupSize;
    const label from = group*(node/group);
    gasKernel::gasKernels<dim>::best().derive
    (
        kernelGas(), data(rows), from, from + group
    );
}


template class Foam::gasState<1>;
template class Foam::gasState<2>;
template class Foam::gasState<3>;
