/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include "gasDynamics/PerfectGas.hpp"

namespace gasDynamics
{

struct Primitive1D
{
    double rho;
    double u;
    double p;
};

//! Exact solution of the Riemann problem of a perfect gas, eqs. (G20)-(G22)
//  of doc/theory/gas.md; after Toro, Riemann Solvers, ch. 4.
//
//  Throws std::invalid_argument for states that are not physical and for
//  states between which vacuum would appear.
class ExactRiemann
{
public:

    ExactRiemann(const PerfectGas&, const Primitive1D& left,
                 const Primitive1D& right);

    double pStar() const { return pStar_; }
    double uStar() const { return uStar_; }

    //! State on the ray x/t = speed
    Primitive1D sample(double speed) const;

private:

    PerfectGas gas_;
    Primitive1D left_;
    Primitive1D right_;
    double pStar_;
    double uStar_;
};

} // namespace gasDynamics
