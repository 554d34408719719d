/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasDynamics/ShockRelations.hpp"

namespace gasDynamics
{

Primitive1D behindShock
(
    const PerfectGas& gas, const Primitive1D& ahead, double Ms
)
{
    if (!(Ms >= 1))
    {
        throw std::invalid_argument
        (
            "a shock needs a Mach number >= 1, not " + std::to_string(Ms)
        );
    }
    const double g = gas.gamma();
    const double M2 = Ms*Ms;
    const double c = gas.soundSpeed(ahead.p, ahead.rho);
    return
    {
        ahead.rho*(g + 1)*M2/((g - 1)*M2 + 2),
        ahead.u + 2*c/(g + 1)*(Ms - 1/Ms),
        ahead.p*(1 + 2*g/(g + 1)*(M2 - 1))
    };
}

double reflectedPressure(const PerfectGas& gas, double p1, double p2)
{
    const double g = gas.gamma();
    const double x = p2/p1;
    return p2*((3*g - 1)*x - (g - 1))/((g - 1)*x + (g + 1));
}

} // namespace gasDynamics
