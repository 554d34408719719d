/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "inversePower.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

TEST(inversePower, isThePowerOfTheDistance)
{
    for (const scalar e : {0.5, 1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 8.0, 20.0})
    {
        const inversePower power(e);
        EXPECT_EQ(power.exponent(), e);
        for (const scalar r : {1e-3, 0.3, 1.0, 2.0, 70.0})
        {
            const scalar expected = std::pow(r, -e);
            EXPECT_NEAR(power(r*r)/expected, 1, 1e-13)
                << "exponent " << e << ", distance " << r;
        }
    }
}
