/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "expansionRemainder.H"

Foam::expansionRemainder::expansionRemainder(const scalar exponent)
:
    maxRatio_
    (
        min(0.9, Foam::sqrt((exponent + 4)/(exponent*(exponent + 2))))
    ),
    table_(label(maxRatio_*entriesPerUnit) + 2)
{
    forAll(table_, i)
    {
        table_[i] = series(exponent, scalar(i)/entriesPerUnit);
    }
}


Foam::scalar Foam::expansionRemainder::series
(
    const scalar exponent,
    const scalar ratio
)
{
    scalar term = exponent*(exponent + 1)*(exponent + 2)/6;
    scalar sum = 0;

    // Terms may grow at first; once the quotient of two is below 1 the rest
    // is less than a geometric series
    for (label n = 3; ; ++n)
    {
        sum += term;
        const scalar quotient = ratio*(exponent + n)/(n + 1);
        term *= quotient;
        if (quotient < 1 && term < 1e-16*sum*(1 - quotient))
        {
            return sum;
        }
    }
}
