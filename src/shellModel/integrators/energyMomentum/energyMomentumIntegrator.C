/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "energyMomentumIntegrator.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace shellIntegrators
{
    defineTypeNameAndDebug(energyMomentum, 0);
    addToRunTimeSelectionTable(shellIntegrator, energyMomentum, dictionary);
}
}


Foam::shellIntegrators::energyMomentum::energyMomentum
(
    const positionalShell::ShellModel& model,
    const dictionary& shellProperties
)
:
    dynamicIntegrator(shellProperties),
    model_(model)
{
    readOptions(shellProperties, options_);
    start(shellProperties);
}


std::unique_ptr<positionalShell::TimeIntegrator>
Foam::shellIntegrators::energyMomentum::make() const
{
    return std::unique_ptr<positionalShell::TimeIntegrator>
    (
        new positionalShell::EnergyMomentum(model_, options_)
    );
}
