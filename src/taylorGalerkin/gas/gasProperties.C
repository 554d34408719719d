/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasProperties.H"
#include "dictionaryCheck.H"
#include "thermodynamicConstants.H"

gasDynamics::PerfectGas Foam::readPerfectGas(const dictionary& dict)
{
    const dictionary& type = dict.subDict("thermoType");
    selectEntry(type, "mixture", {"pureMixture"});
    selectEntry(type, "transport", {"const"});
    selectEntry(type, "thermo", {"hConst"});
    selectEntry(type, "equationOfState", {"perfectGas"});

    const dictionary& mixture = dict.subDict("mixture");
    const dictionary& thermodynamics = mixture.subDict("thermodynamics");
    const scalar molWeight =
        mixture.subDict("specie").get<scalar>("molWeight");
    const scalar Cp = thermodynamics.get<scalar>("Cp");
    const dictionary& transport = mixture.subDict("transport");
    const scalar mu = transport.get<scalar>("mu");

    if (mu != 0)
    {
        FatalIOErrorInFunction(transport)
            << "mu is " << mu << ", but this version solves inviscid flow "
            << "only" << nl << "    Set mu to 0" << exit(FatalIOError);
    }
    if (molWeight <= 0)
    {
        FatalIOErrorInFunction(mixture)
            << "molWeight must be positive, not " << molWeight
            << exit(FatalIOError);
    }

    const scalar R = constant::thermodynamic::RR/molWeight;
    if (Cp <= R)
    {
        FatalIOErrorInFunction(thermodynamics)
            << "Cp = " << Cp << " J/(kg K) must be greater than the gas "
            << "constant R = RR/molWeight = " << R << exit(FatalIOError);
    }
    return gasDynamics::PerfectGas(R, Cp);
}
