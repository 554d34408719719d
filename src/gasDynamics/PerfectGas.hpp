/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace gasDynamics
{

//! Calorically perfect gas: p = rho R T, e = Cv T.
//
//  Units SI throughout: p [Pa], rho [kg/m3], T [K], R, Cv [J/(kg K)].
class PerfectGas
{
public:

    //! From the gas constant R and the heat capacity at constant pressure Cp.
    //  Throws std::invalid_argument unless Cp > R > 0, both finite.
    PerfectGas(double R, double Cp)
    :
        R_(R),
        gamma_(Cp/(Cp - R))
    {
        if (!(R > 0) || !(Cp > R) || !std::isfinite(Cp))
        {
            throw std::invalid_argument
            (
                "a perfect gas needs Cp > R > 0, but R = "
              + std::to_string(R) + " and Cp = " + std::to_string(Cp)
              + " J/(kg K)"
            );
        }
    }

    static PerfectGas fromGamma(double gamma, double R = 1)
    {
        return PerfectGas(R, gamma*R/(gamma - 1));
    }

    double R() const { return R_; }
    double gamma() const { return gamma_; }
    double Cv() const { return R_/(gamma_ - 1); }
    double Cp() const { return gamma_*Cv(); }

    double density(double p, double T) const { return p/(R_*T); }
    double temperature(double p, double rho) const { return p/(R_*rho); }

    //! Internal energy per volume [J/m3]
    double internalEnergy(double p) const { return p/(gamma_ - 1); }

    double soundSpeed(double p, double rho) const
    {
        return std::sqrt(gamma_*p/rho);
    }

private:

    double R_;
    double gamma_;
};

} // namespace gasDynamics
