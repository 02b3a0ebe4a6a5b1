/*---------------------------------------------------------------------------*\
    slideFoam | from rain to runout
    Copyright (C) 2026 the slideFoam authors
-------------------------------------------------------------------------------
License
    This file is part of slideFoam.

    slideFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by the
    Free Software Foundation, either version 3 of the License, or (at your
    option) any later version.

    slideFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE. See the GNU General Public License for
    more details.

    You should have received a copy of the GNU General Public License along
    with slideFoam. If not, see <http://www.gnu.org/licenses/>.

Description
    The local shear strength, Zhu2022 Eqs. 2 to 6, above and below the water
    table.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "localShearStrength.H"
#include "soilDictionary.H"

#include <cmath>

using doctest::Approx;
using namespace localShearStrength;

// Each comparison is of a handful of operations: a few units of round-off
static const double roundOff = 1e-14;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("the effective stress parameter is the effective saturation")
{
    // S = theta/thetaS, Sr = thetaR/thetaS, chi = (S - Sr)/(1 - Sr) by hand:
    // (0.25/0.4 - 0.25)/(1 - 0.25) = 0.5
    CHECK(effectiveStressParameter(0.25, 0.4, 0.1) == Approx(0.5));
    CHECK(effectiveStressParameter(0.4, 0.4, 0.1) == 1);
    CHECK(effectiveStressParameter(0.1, 0.4, 0.1) == 0);

    const Foam::soilHydraulics soil("embankment", embankment());

    for (const double h : {-0.01, -0.5, -3.0, -40.0, 1.0})
    {
        const double chi = effectiveStressParameter(soil.theta(h), 0.36, 0.035);

        CHECK
        (
            chi
         == Approx(soil.retention().Se(h)).epsilon(roundOff)
        );
    }
}


TEST_CASE("suction adds to the cohesion intercept")
{
    // Half saturated at 20 kPa of suction, tan(phi') = 0.75, c' = 5 kPa:
    // 5000 + 0.5 x 20000 x 0.75
    const double pw = porePressure(0.5, -20000);

    CHECK(pw == -10000);
    CHECK(cohesionIntercept(5000, pw, 0.75) == Approx(12500));
}


TEST_CASE("below the water table the intercept keeps its sign")
{
    // 6 m of water over cohesionless soil of 37 degrees: minus uw tan(phi')
    const double tanPhi = std::tan(37*std::acos(-1.0)/180);
    const double uw = 6*1000*9.81;
    const double c = cohesionIntercept(0, porePressure(1, uw), tanPhi);

    CHECK(c < 0);
    CHECK(c == Approx(-uw*tanPhi).epsilon(roundOff));

    // The strength is that of the effective stress (Zhu2022 Eq. 1)
    const double sigma = 100e3;
    CHECK
    (
        shearStrength(c, sigma, tanPhi)
     == Approx((sigma - uw)*tanPhi).epsilon(roundOff)
    );
}


TEST_CASE("Fredlund's form gives the same strength")
{
    // Zhu2022 Eq. 3 with Eq. 4 against Eq. 6
    const double chi = 0.3, suction = 45e3, tanPhi = 0.6, c = 2e3, sigma = 7e4;
    const double fredlund = c + sigma*tanPhi + suction*tanPhiB(chi, tanPhi);
    const double lss =
        shearStrength
        (
            cohesionIntercept(c, porePressure(chi, -suction), tanPhi),
            sigma,
            tanPhi
        );

    CHECK(lss == Approx(fredlund).epsilon(roundOff));
}


TEST_CASE("water adds to the density")
{
    CHECK(bulkDensity(1695, 0.36, 1000) == Approx(2055));
}

// ************************************************************************* //
