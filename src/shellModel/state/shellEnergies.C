/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellEnergies.H"
#include "shellVector.H"

Foam::shellEnergies Foam::shellEnergies::sum
(
    const shellEnergies& earlier,
    const positionalShell::EnergyBalance& sinceThen
)
{
    shellEnergies e(earlier);
    e.kinetic = sinceThen.kinetic();
    e.strain = sinceThen.strain();
    e.externalWork += sinceThen.externalWork();
    e.supportWork += sinceThen.supportWork();
    e.dissipated += sinceThen.dissipated();
    e.impulse += toFoam(sinceThen.impulse());
    return e;
}


Foam::shellEnergies Foam::shellEnergies::read(const dictionary& dict)
{
    shellEnergies e;
    dict.readEntry("initialEnergy", e.initial);
    dict.readEntry("externalWork", e.externalWork);
    dict.readEntry("supportWork", e.supportWork);
    dict.readEntry("dissipated", e.dissipated);
    dict.readEntry("impulse", e.impulse);
    return e;
}


void Foam::shellEnergies::writeEntries(Ostream& os) const
{
    os.writeEntry("initialEnergy", initial);
    os.writeEntry("externalWork", externalWork);
    os.writeEntry("supportWork", supportWork);
    os.writeEntry("dissipated", dissipated);
    os.writeEntry("impulse", impulse);
}
