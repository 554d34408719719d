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
    selectEntry(type, "transport", {"const", "sutherland"});
    selectEntry(type, "thermo", {"hConst"});
    selectEntry(type, "equationOfState", {"perfectGas"});

    const dictionary& mixture = dict.subDict("mixture");
    const dictionary& thermodynamics = mixture.subDict("thermodynamics");
    const scalar molWeight =
        mixture.subDict("specie").get<scalar>("molWeight");
    const scalar Cp = thermodynamics.get<scalar>("Cp");

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


gasDynamics::Transport Foam::readTransport
(
    const dictionary& dict,
    const gasDynamics::PerfectGas& gas
)
{
    const dictionary& transport =
        dict.subDict("mixture").subDict("transport");
    auto positive = [&](const word& keyword, const bool orZero)
    {
        const scalar value = transport.get<scalar>(keyword);
        if (!(value > 0 || (orZero && value == 0)))
        {
            FatalIOErrorInFunction(transport)
                << keyword << " is " << value << ", but must be positive"
                << (orZero ? " or zero" : "") << exit(FatalIOError);
        }
        return value;
    };

    const bool isConstant =
        dict.subDict("thermoType").get<word>("transport") == "const";
    if (isConstant)
    {
        const scalar mu = positive("mu", true);
        return
            mu > 0
          ? gasDynamics::Transport::constant(gas, mu, positive("Pr", false))
          : gasDynamics::Transport();
    }
    return gasDynamics::Transport::sutherland
    (
        gas, positive("As", false), positive("Ts", true),
        transport.found("Pr") ? positive("Pr", false) : 0
    );
}
