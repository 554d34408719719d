/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "staticIntegrator.H"

void Foam::shellIntegrators::staticIntegrator::addExternalForce
(
    const positionalShell::Loads& loads,
    const positionalShell::GivenForce& given,
    positionalShell::DynamicStep& step
) const
{
    step.externalForce =
        totalForce(loads, model_, step.state.position, step.state.time);
    if (given.end)
    {
        step.externalForce += *given.end;
    }
}
