/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasDynamics/Transport.hpp"
#include "gasProperties.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using gasDynamics::PerfectGas;
using gasDynamics::Transport;

namespace
{

Transport read(const std::string& law, const std::string& entries)
{
    IStringStream text
    (
        "thermoType { type hePsiThermo; mixture pureMixture; transport "
      + law + "; thermo hConst; equationOfState perfectGas; specie specie; "
        "energy sensibleInternalEnergy; } mixture { specie { molWeight 28.9; } "
        "thermodynamics { Cp 1007; Hf 0; } transport { " + entries + " } }"
    );
    const dictionary dict(text);
    return readTransport(dict, readPerfectGas(dict));
}

} // End namespace


// source: Sutherland's constants of air as in OpenFOAM's tutorials; White,
// Viscous Fluid Flow: mu = 1.846e-5 Pa s at 300 K
TEST(Transport, sutherlandOfAir)
{
    const Transport air = read("sutherland", "As 1.458e-6; Ts 110.4;");
    EXPECT_TRUE(air.isPresent());
    EXPECT_NEAR(air.mu(300)/1.846e-5, 1, 2e-3);

    // Modified Euken relation with R = RR/28.9 by hand
    const double R = 8314.47/28.9, Cv = 1007 - R;
    EXPECT_NEAR(air.kappaOverMu()/(Cv*(1.32 + 1.77*R/Cv)), 1, 1e-5);
}


TEST(Transport, prandtlNumber)
{
    const Transport constant = read("const", "mu 2e-5; Pr 0.5;");
    EXPECT_EQ(constant.mu(200), 2e-5);
    EXPECT_EQ(constant.mu(800), 2e-5);
    EXPECT_NEAR(constant.kappaOverMu(), 2014, 1e-9);
    EXPECT_NEAR
    (
        read("sutherland", "As 1e-6; Ts 110; Pr 0.5;").kappaOverMu(), 2014, 1e-9
    );
}


TEST(Transport, inviscidNeedsNoPrandtlNumber)
{
    EXPECT_FALSE(read("const", "mu 0;").isPresent());
    EXPECT_FALSE(Transport().isPresent());
}


TEST(Transport, refusesWhatIsNoGas)
{
    EXPECT_THROW(read("const", "mu -1e-5; Pr 1;"), Foam::IOerror);
    EXPECT_THROW(read("const", "mu 1e-5; Pr 0;"), Foam::IOerror);
    EXPECT_THROW(read("const", "mu 1e-5;"), Foam::IOerror);
    EXPECT_THROW(read("polynomial", "mu 1e-5; Pr 1;"), Foam::IOerror);
    EXPECT_THROW(read("sutherland", "As 0; Ts 110;"), Foam::IOerror);
    EXPECT_THROW
    (
        Transport::constant(PerfectGas(287, 1005), -1, 1), std::invalid_argument
    );
    EXPECT_THROW
    (
        Transport::constant(PerfectGas(287, 1005), 1, 0), std::invalid_argument
    );
}
