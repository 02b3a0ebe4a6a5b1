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
    The Darcy fluxes between two points: exact at rest, exact for steady flow
    in an exponential soil, monotone, and with derivatives that are theirs.

\*---------------------------------------------------------------------------*/

#include "darcyFluxSoils.H"

using namespace darcyFlux;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Water at rest stays at rest, in one soil and across two")
{
    for
    (
        const std::string scheme
      : {"monotone", "upwind", "integralMean", "arithmetic", "geometric"}
    )
    {
        for (const scalar drop : {-0.7, 0.4, 2.0})
        {
            soils one(scheme, stiff, stiff, drop);
            soils two(scheme, embankment, stiff, drop, 0.3);

            for (const scalar h : heads)
            {
                // Round-off of heads of metres times Ks
                CHECK(std::abs(one.ofHeads(h, h + drop).value) < 1e-18);
                CHECK(std::abs(two.ofHeads(h, h + drop).value) < 1e-18);
            }
        }
    }

    // Not with K upwind on gravity and the integral on the head
    soils drifting("integralUpwind", stiff, stiff, 0.4);
    CHECK(std::abs(drifting.ofHeads(-1, -0.6).value) > 1e-12);
}


TEST_CASE("Steady flow down through an exponential soil is exact")
{
    // With K = Ks exp(a h) the steady flux between two points, the upper one
    // D above the lower one, is (K1 - K2 exp(-a D))/(1 - exp(-a D)) times the
    // cosine of the angle to the vertical: here area 1, distance 0.5
    const scalar Ks = 1e-5;
    const scalar alpha = 2;
    const scalar drop = 0.35;

    soils s("monotone", gardner, gardner, drop);

    const scalar decay = std::exp(-alpha*drop);

    // A drier point below, as dry a one, and wetter ones
    for (const scalar lower : {-0.6, -0.2, -0.1, 0.05, 0.1, 0.149})
    {
        const scalar upper = -0.2;
        const scalar K1 = Ks*std::exp(alpha*upper);
        const scalar K2 = Ks*std::exp(alpha*lower);
        const scalar q = (K1 - K2*decay)/(1 - decay);

        // The curves' table is exact to 1e-5; above the table the flux
        // extends the exponential of the upper point
        CHECK
        (
            s.ofHeads(upper, lower).value
         == Approx(2*drop*q).epsilon(1e-4).scale(2*drop*K1)
        );
    }
}


TEST_CASE("Steady flow down through two exponential soils is exact")
{
    // In either soil K = q + (K - q) exp(a z) along the height z
    const scalar a1 = 2, K1 = 1e-5, a2 = 5, K2 = 2e-7;
    const scalar drop = 0.4;
    const scalar share = 0.3;

    soils s
    (
        "monotone",
        exponential("2", "1e-5"),
        exponential("5", "2e-7"),
        drop,
        share
    );

    label nChecked = 0;

    for (const scalar q : {1e-9, 2.5e-9, 1e-8, 4e-8, 5.5e-8})
    {
        for (const scalar hFace : {-0.9, -0.3})
        {
            const scalar upper = q
              + (K1*std::exp(a1*hFace) - q)*std::exp(-a1*share*drop);
            const scalar lower = q
              + (K2*std::exp(a2*hFace) - q)*std::exp(a2*(1 - share)*drop);

            if (lower > 0 && lower < K2)
            {
                // 1e-5 of K in the tables
                CHECK
                (
                    s.ofHeads
                    (
                        std::log(upper/K1)/a1,
                        std::log(lower/K2)/a2
                    ).value
                 == Approx(2*drop*q).epsilon(1e-3)
                );
                ++nChecked;
            }
        }
    }

    // Fronts and wetter points below
    CHECK(nChecked >= 5);
}


TEST_CASE("An interface between equal soils is none")
{
    // The same exponential soil under two names: a flux that is exact does not
    // mind a face on its way
    soils one("monotone", gardner, gardner, 0.4);
    soils two("monotone", gardner, gardner + " ", 0.4, 0.2);

    for (const scalar h1 : {-1.7, -0.8, -0.3})
    {
        for (const scalar h2 : {-2.2, -0.9, -0.5, -0.2})
        {
            if (h2 - h1 < 0.4)
            {
                CHECK
                (
                    two.ofHeads(h1, h2).value
                 == Approx(one.ofHeads(h1, h2).value).epsilon(1e-4)
                );
            }
        }
    }
}


TEST_CASE("Fluxes have their own derivatives, and which are monotone")
{
    const auto sweep = [](const std::string& scheme, const bool isMonotone)
    {
        for (const std::string& second : {stiff, embankment})
        {
            for (const scalar drop : {-0.7, 0.0, 0.4})
            {
                soils s(scheme, stiff, second, drop);

                for (const scalar h1 : heads)
                {
                    for (const scalar h : heads)
                    {
                        // Off the bends at equal heads and at rest, where
                        // the derivatives jump
                        const scalar h2 = 1.1*h - 0.0031;
                        const scalar tau1 = s.tables[0].tauOfHead(h1);
                        const scalar tau2 = s.table2().tauOfHead(h2);

                        if (isMonotone)
                        {
                            const richardsFlux::flux f
                            (
                                s.ofUnknowns(tau1, tau2)
                            );
                            CHECK(f.dFirst >= 0);
                            CHECK(f.dSecond <= 0);
                        }

                        s.checkDerivatives(tau1, tau2);
                    }
                }
            }
        }
    };

    for (const std::string& scheme : monotoneSchemes)
    {
        sweep(scheme, true);
    }

    for (const std::string& scheme : schemesOfMeans)
    {
        sweep(scheme, false);
    }
}


TEST_CASE("The means are not monotone in a soil with n close to 1")
{
    // Saturated above, drier and drier below: the lower point has to draw no
    // less
    const auto draws = [](const std::string& scheme, const scalar h)
    {
        soils s(scheme, stiff, stiff, 0.1);
        return s.ofHeads(0, h);
    };

    for (const std::string& scheme : schemesOfMeans)
    {
        CHECK(draws(scheme, -1e-4).dSecond > 0);
        CHECK
        (
            draws(scheme, -0.05).value < 0.8*draws(scheme, -1e-5).value
        );
    }

    for (const std::string& scheme : monotoneSchemes)
    {
        CHECK(draws(scheme, -1e-4).dSecond <= 0);
        CHECK(draws(scheme, -0.05).value >= draws(scheme, -1e-5).value);
    }
}


TEST_CASE("Where the lower point is wetter the flux is monotone as well")
{
    // Steps of cells from thin to coarse, over the whole range in which water
    // goes down against the heads; with 40 other steps in the mesh the tables
    // of the scheme hold others than this one
    for (const std::string& soil : {stiff, embankment, sand, gardner})
    {
        for (const label nOthers : {0, 40})
        {
            for (const scalar drop : {0.01, 0.1, 1.0})
            {
                soils s("monotone", soil, soil, drop, 0.5, nOthers);

                for (scalar h1 = -8; h1 < -1e-4; h1 *= 0.8)
                {
                    for (scalar share = 0.02; share < 1; share += 0.07)
                    {
                        const scalar tau1 = s.tables[0].tauOfHead(h1);
                        const scalar tau2 =
                            s.tables[0].tauOfHead(h1 + share*drop);
                        const richardsFlux::flux f(s.ofUnknowns(tau1, tau2));

                        CHECK(f.dFirst >= 0);
                        CHECK(f.dSecond <= 0);
                        CHECK(f.value > 0);

                        // At least K upwind, and no more than by gravity
                        const scalar K = s.tables[0].at(tau1).K;
                        const scalar gravity = 2*drop*K*(1 + 1e-12);
                        CHECK(f.value <= gravity);
                        CHECK(f.value >= (1 - share)*gravity*(1 - 1e-9));
                    }
                }
            }
        }
    }
}


TEST_CASE("The pieces of the monotone flux join")
{
    for (const std::string& soil : {stiff, embankment, sand})
    {
        for (const scalar drop : {0.03, 0.4, 2.0})
        {
            soils s("monotone", soil, soil, drop);

            for (const scalar h : {-3.0, -0.5, -0.02, -0.001})
            {
                const scalar tau = s.tables[0].tauOfHead(h);
                const soilTable::state upper(s.tables[0].at(tau));
                const scalar gravity = 2*drop*upper.K;
                const scalar tiny = 1e-10;

                // At equal heads unit gradient, at rest nothing
                for (const scalar side : {-tiny, tiny})
                {
                    CHECK
                    (
                        s.ofHeads(h, h + side).value
                     == Approx(gravity).epsilon(1e-4)
                    );
                    CHECK
                    (
                        std::abs(s.ofHeads(h, h + drop + side).value)
                      < 2*s.tables[0].Ks()*10*tiny
                    );
                }
            }
        }
    }
}


TEST_CASE("The profile of draining has its own derivatives")
{
    const scalar step = 1e-6;

    for (const scalar P : {2e-6, 9e-5, 1.1e-4, 0.3, 4.0, 60.0, 800.0})
    {
        for (const scalar a : {0.01, 0.4, 0.98})
        {
            scalar f, dfdP, dfda, low, high, unused;
            Foam::drainingFluxTable::profile(P, a, f, dfdP, dfda);

            Foam::drainingFluxTable::profile(P, a + step, high, unused, unused);
            Foam::drainingFluxTable::profile(P, a - step, low, unused, unused);
            CHECK(dfda == Approx((high - low)/(2*step)).epsilon(1e-6).scale(1));

            const scalar part = 1e-3*P;
            Foam::drainingFluxTable::profile(P + part, a, high, unused, unused);
            Foam::drainingFluxTable::profile(P - part, a, low, unused, unused);
            CHECK
            (
                dfdP == Approx((high - low)/(2*part)).epsilon(1e-5).scale(1e-2)
            );

            // The bound under which the flux grows with the upper wetness
            CHECK
            (
                P/(1 - std::exp(-P)) >= (6.8 + 3.4*P + 1.7*P*P)*dfdP
            );
        }
    }
}


TEST_CASE("A flux turns its sign when the points change places")
{
    const scalar share = 0.3;

    for (const std::string& second : {embankment, stiff, sand})
    {
        soils down("monotone", embankment, second, 0.4, share);
        soils up("monotone", second, embankment, -0.4, 1 - share);

        for (const scalar h1 : heads)
        {
            for (const scalar h2 : heads)
            {
                const richardsFlux::flux a(down.ofHeads(h1, h2));
                const richardsFlux::flux b(up.ofHeads(h2, h1));

                CHECK(a.value == Approx(-b.value).epsilon(1e-12).scale(1e-9));
                CHECK(a.dFirst == Approx(-b.dSecond).epsilon(1e-9));
            }
        }
    }
}


TEST_CASE("Across two soils the poorer one rules, whatever the contrast")
{
    // Ks of 1e-5 over 1e-5 to 1e-11: saturated, the harmonic mean of the parts
    // of the way; unsaturated, no more than that but for the exponential that
    // is extended beyond saturation
    const scalar share = 0.3;
    const scalar drop = 0.4;
    const char* const Ks[] = {"1e-5", "1e-7", "1e-9", "1e-11"};

    for (const char* second : Ks)
    {
        soils s
        (
            "monotone",
            vanGenuchten("0.5", "0.4", "1e-5") + " ",
            vanGenuchten("3", "0.3", second),
            drop,
            share
        );

        const scalar mean =
            1/(share/1e-5 + (1 - share)/std::stod(second));

        CHECK(s.ofHeads(1, 0.6).value == Approx(2*mean*0.8).epsilon(1e-10));
        CHECK(s.ofHeads(1, 2.4).value == Approx(-2*mean).epsilon(1e-10));

        for (const scalar h1 : heads)
        {
            for (const scalar h2 : heads)
            {
                const scalar dH = drop + h1 - h2;
                const scalar q = s.ofHeads(h1, h2).value;

                CHECK(q*dH >= 0);
                CHECK(std::abs(q) <= 2*mean*std::abs(dH)*(1 + 1e-4));
            }
        }
    }
}


TEST_CASE("Saturated soil follows Darcy's law")
{
    soils s("monotone", embankment, embankment, 0.4);

    // T Ks dH
    CHECK(s.ofHeads(1, 0.6).value == Approx(2*1.12e-5*0.8).epsilon(1e-10));
    CHECK(s.ofHeads(1, 2.4).value == Approx(-2*1.12e-5).epsilon(1e-10));

    // Across two soils with the harmonic mean of equal halves, in each scheme
    for (const std::string& scheme : schemesOfMeans)
    {
        soils two(scheme, embankment, stiff, 0.4);
        const scalar Ks = 2/(1/1.12e-5 + 1/1.4e-6);
        CHECK(two.ofHeads(1, 0.6).value == Approx(2*Ks*0.8).epsilon(1e-10));
    }
}


TEST_CASE("An unknown scheme is answered by the list of schemes")
{
    CHECK_THROWS_AS
    (
        soils("harmonic", stiff, stiff, 1),
        Foam::IOerror
    );
}

// ************************************************************************* //
