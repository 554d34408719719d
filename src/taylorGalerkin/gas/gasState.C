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
    eos(gas),
    U(geometry.nNodes(), State::Zero()),
    p(geometry.nNodes(), 0.0),
    velocity(geometry.nNodes(), Vec::Zero()),
    soundSpeed(geometry.nNodes(), 0.0),
    mu(geometry.nSimplices(), 0.0)
{}


template<int dim>
Foam::label Foam::gasState<dim>::derive()
{
    label bad = -1;
    for (std::size_t a = 0; a < U.size(); ++a)
    {
        velocity[a] = U[a].template segment<dim>(1)/U[a][0];
        p[a] =
            (eos.gamma() - 1)
           *(
                U[a][dim + 1]
              - 0.5*velocity[a].dot(U[a].template segment<dim>(1))
            );

        // Written so that NaN fails too
        if (U[a][0] > 0 && p[a] > 0 && std::isfinite(p[a]))
        {
            soundSpeed[a] = eos.soundSpeed(p[a], U[a][0]);
        }
        else if (bad < 0)
        {
            bad = a;
        }
    }
    return bad;
}


template class Foam::gasState<1>;
template class Foam::gasState<2>;
template class Foam::gasState<3>;
