/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasDynamics/ExactRiemann.hpp"

#include <algorithm>

namespace gasDynamics
{

namespace
{

//! Velocity change across the wave that joins side K with the pressure p,
//  and its derivative, eq. (G21)
struct WaveCurve { double f; double df; };

WaveCurve waveCurve(const PerfectGas& gas, const Primitive1D& K, double p)
{
    const double g = gas.gamma();
    if (p > K.p)
    {
        const double A = 2/((g + 1)*K.rho);
        const double B = (g - 1)/(g + 1)*K.p;
        const double root = std::sqrt(A/(p + B));
        return {(p - K.p)*root, root*(1 - 0.5*(p - K.p)/(p + B))};
    }
    const double c = gas.soundSpeed(K.p, K.rho);
    const double ratio = p/K.p;
    return
    {
        2*c/(g - 1)*(std::pow(ratio, (g - 1)/(2*g)) - 1),
        std::pow(ratio, -(g + 1)/(2*g))/(K.rho*c)
    };
}

void checkPhysical(const Primitive1D& K, const char* side)
{
    if (!(K.rho > 0) || !(K.p > 0) || !std::isfinite(K.u))
    {
        throw std::invalid_argument
        (
            std::string("Riemann problem: the ") + side
          + " state needs rho > 0 and p > 0, but rho = "
          + std::to_string(K.rho) + ", p = " + std::to_string(K.p)
        );
    }
}

//! State inside the wave on one side; sign = -1 left, +1 right
Primitive1D sampleSide
(
    const PerfectGas& gas, const Primitive1D& K,
    double pStar, double uStar, double speed, int sign
)
{
    const double g = gas.gamma();
    const double c = gas.soundSpeed(K.p, K.rho);
    const double ratio = pStar/K.p;

    if (pStar > K.p)
    {
        const double shock =
            K.u + sign*c*std::sqrt((g + 1)/(2*g)*ratio + (g - 1)/(2*g));
        if (sign*(speed - shock) > 0)
        {
            return K;
        }
        const double mu = (g - 1)/(g + 1);
        return {K.rho*(ratio + mu)/(mu*ratio + 1), uStar, pStar};
    }

    const double cStar = c*std::pow(ratio, (g - 1)/(2*g));
    if (sign*(speed - (K.u + sign*c)) > 0)
    {
        return K;
    }
    if (sign*(speed - (uStar + sign*cStar)) < 0)
    {
        return {K.rho*std::pow(ratio, 1/g), uStar, pStar};
    }

    // inside the fan
    const double cFan =
        2/(g + 1)*(c - sign*(g - 1)/2*(K.u - speed));
    const double r = cFan/c;
    return
    {
        K.rho*std::pow(r, 2/(g - 1)),
        speed - sign*cFan,
        K.p*std::pow(r, 2*g/(g - 1))
    };
}

} // namespace

ExactRiemann::ExactRiemann
(
    const PerfectGas& gas, const Primitive1D& left, const Primitive1D& right
)
:
    gas_(gas), left_(left), right_(right), pStar_(0), uStar_(0)
{
    checkPhysical(left, "left");
    checkPhysical(right, "right");

    const double g = gas.gamma();
    const double cL = gas.soundSpeed(left.p, left.rho);
    const double cR = gas.soundSpeed(right.p, right.rho);
    const double du = right.u - left.u;

    if (2*(cL + cR)/(g - 1) <= du)
    {
        throw std::invalid_argument("Riemann problem: the states part so "
            "fast that vacuum appears between them");
    }

    // Two-rarefaction value: positive, and a lower start for the monotone
    // and concave function, so that Newton cannot leave p > 0
    const double z = (g - 1)/(2*g);
    double p = std::pow
    (
        (cL + cR - 0.5*(g - 1)*du)
       /(cL/std::pow(left.p, z) + cR/std::pow(right.p, z)),
        1/z
    );

    for (int i = 0; i < 100; ++i)
    {
        const WaveCurve L = waveCurve(gas, left, p);
        const WaveCurve R = waveCurve(gas, right, p);
        const double change = (L.f + R.f + du)/(L.df + R.df);
        const double next = std::max(p - change, 1e-3*p);
        const bool done = std::abs(next - p) <= 1e-15*(next + p);
        p = next;
        if (done) break;
    }

    pStar_ = p;
    uStar_ = 0.5*(left.u + right.u)
      + 0.5*(waveCurve(gas, right, p).f - waveCurve(gas, left, p).f);
}

Primitive1D ExactRiemann::sample(double speed) const
{
    return speed <= uStar_
      ? sampleSide(gas_, left_, pStar_, uStar_, speed, -1)
      : sampleSide(gas_, right_, pStar_, uStar_, speed, +1);
}

} // namespace gasDynamics
