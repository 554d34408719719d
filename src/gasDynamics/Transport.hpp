/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/PerfectGas.hpp"

namespace gasDynamics
{

//! Viscosity [Pa s] and heat conductivity [W/(m K)] of a gas: constant, or Sutherland's law
//
//      mu = As sqrt(T)/(1 + Ts/T),                                     (G67)
//
//  the conductivity by a Prandtl number, kappa = Cp mu/Pr, or by the modified Euken relation
//  kappa = mu Cv (1.32 + 1.77 R/Cv) that OpenFOAM uses with Sutherland's law.
class Transport
{
public:

    //! No viscosity, no conduction
    Transport() = default;

    //! Throws std::invalid_argument unless mu >= 0 and Pr > 0, both finite
    static Transport constant(const PerfectGas& gas, double mu, double Pr)
    {
        check("mu", mu, mu >= 0);
        return Transport(mu, -1, byPrandtl(gas, Pr));
    }

    //! Pr <= 0: the modified Euken relation. Throws std::invalid_argument unless As > 0 and
    //  Ts >= 0, all finite
    static Transport sutherland(const PerfectGas& gas, double As, double Ts, double Pr)
    {
        check("As", As, As > 0);
        check("Ts", Ts, Ts >= 0);
        return Transport(As, Ts, Pr > 0 ? byPrandtl(gas, Pr) : euken(gas));
    }

    bool isPresent() const { return scale_ > 0; }

    double mu(double T) const
    {
        return Ts_ < 0 ? scale_ : scale_*std::sqrt(T)/(1 + Ts_/T);
    }

    //! kappa/mu [J/(kg K)]
    double kappaOverMu() const { return kappaOverMu_; }

private:

    double scale_ = 0;
    double Ts_ = -1;
    double kappaOverMu_ = 0;

    Transport(double scale, double Ts, double kappaOverMu)
    :
        scale_(scale), Ts_(Ts), kappaOverMu_(kappaOverMu)
    {}

    static double byPrandtl(const PerfectGas& gas, double Pr)
    {
        check("Pr", Pr, Pr > 0);
        return gas.Cp()/Pr;
    }

    static double euken(const PerfectGas& gas)
    {
        return 1.32*gas.Cv() + 1.77*gas.R();
    }

    static void check(const char* name, double value, bool valid)
    {
        if (!valid || !std::isfinite(value))
        {
            throw std::invalid_argument
            (
                std::string(name) + " = " + std::to_string(value) + " is no gas's"
            );
        }
    }
};

} // namespace gasDynamics
