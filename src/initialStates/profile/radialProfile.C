/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "radialProfile.H"
#include "ListOps.H"

namespace
{

void checkRow
(
    const Foam::profileRow& row,
    const Foam::scalar rBefore,
    const bool round,
    const Foam::dictionary& dict
)
{
    using namespace Foam;

    if (!(row.rho > 0) || !(row.p > 0) || !std::isfinite(row.u))
    {
        FatalIOErrorInFunction(dict)
            << "The profile has rho = " << row.rho << ", u = " << row.u
            << ", p = " << row.p << " at r = " << row.r << " ("
            << row.where.c_str() << "): rho and p must be positive"
            << exit(FatalIOError);
    }
    if (!(row.r > rBefore) || (round && row.r < 0))
    {
        FatalIOErrorInFunction(dict)
            << "r is " << row.r << " at " << row.where.c_str()
            << ": it must grow from row to row"
            << (round ? " and not be negative" : "")
            << exit(FatalIOError);
    }
    if (round && row.r <= 0 && mag(row.u) > 1e-6*std::sqrt(row.p/row.rho))
    {
        FatalIOErrorInFunction(dict)
            << "u is " << row.u << " at r = 0 (" << row.where.c_str()
            << "), where a radial velocity must be 0" << exit(FatalIOError);
    }
}

} // End namespace


Foam::radialProfile::radialProfile
(
    const gasDynamics::PerfectGas& gas,
    const UList<profileRow>& rows,
    const bool round,
    const dictionary& dict
)
{
    if (rows.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "The profile has " << rows.size() << " rows, but needs 2"
            << exit(FatalIOError);
    }

    DynamicList<scalar> r(rows.size() + 1);
    DynamicList<State> states(rows.size() + 1);
    auto add = [&](const scalar ri, const scalar u, const profileRow& row)
    {
        r.append(ri);
        states.append
        (
            gasDynamics::conserved<1>
            (
                gas, row.rho, gasDynamics::Vec<1>(u), row.p
            )
        );
    };

    if (round && rows.first().r > 0)
    {
        add(0, 0, rows.first());
    }
    forAll(rows, i)
    {
        const profileRow& row = rows[i];
        checkRow(row, i ? rows[i - 1].r : -GREAT, round, dict);
        add(row.r, (round && row.r <= 0 ? 0 : row.u), row);
    }
    r_.transfer(r);
    states_.transfer(states);
}


Foam::radialProfile::State Foam::radialProfile::at(const scalar r) const
{
    if (r <= r_.first())
    {
        return states_.first();
    }
    if (r >= r_.last())
    {
        return states_.last();
    }
    const label i = findLower(r_, r, 0, lessEqOp<scalar>());
    const scalar t = (r - r_[i])/(r_[i + 1] - r_[i]);
    return (1 - t)*states_[i] + t*states_[i + 1];
}


Foam::radialProfile::State Foam::radialProfile::integral
(
    const scalar from,
    const scalar to,
    const label power
) const
{
    State sum = State::Zero();
    for (label i = 0; i + 1 < r_.size(); ++i)
    {
        const scalar a = max(from, r_[i]);
        const scalar b = min(to, r_[i + 1]);
        if (a >= b)
        {
            continue;
        }
        // Two Gauss points: exact for the linear state times r^2
        for (const scalar xi : {-1/std::sqrt(3.0), 1/std::sqrt(3.0)})
        {
            const scalar r = 0.5*((a + b) + xi*(b - a));
            sum += 0.5*(b - a)*std::pow(r, power)*at(r);
        }
    }
    return sum;
}
