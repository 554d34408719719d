/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellModelSide.H"

Foam::shellModelSide::shellModelSide(const Time& runTime)
:
    shell_(runTime)
{
    if (!shell_.dynamic())
    {
        FatalIOErrorInFunction(shell_.properties())
            << "analysis is static, but a coupled shell moves in time" << nl
            << "    Set analysis to dynamic" << exit(FatalIOError);
    }
    shell_.describe(Info);
}


void Foam::shellModelSide::advance
(
    const scalar dt,
    const positionalShell::Vector& generalisedForce
)
{
    shell_.advance(dt, generalisedForce);
}


void Foam::shellModelSide::report() const
{
    shell_.reportStep(Info);
}


void Foam::shellModelSide::reportEnd() const
{
    shell_.reportEnd(Info);
}
