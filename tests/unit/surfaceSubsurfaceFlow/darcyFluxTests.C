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

#include <doctest/doctest.h>

#include "IStringStream.H"
#include "richardsFlux.H"

#include <cmath>
#include <string>

using doctest::Approx;
using Foam::dictionary;
using Foam::label;
using Foam::List;
using Foam::PtrList;
using Foam::richardsFlux;
using Foam::scalar;
using Foam::soilHydraulics;
using Foam::soilTable;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    dictionary dictionaryOf(const std::string& text)
    {
        return dictionary(Foam::IStringStream(text)());
    }

    //- The stiff soil of Zhu2022 Table 2, its embankment, an exponential one
    const char* const stiff =
        "retention { type vanGenuchten; thetaS 0.63; thetaR 0.19;"
        " alpha 0.81; m 0.012; }"
        "relativePermeability { type mualem; } Ks 1.4e-6; Ss 1e-5;";

    const char* const embankment =
        "retention { type vanGenuchten; thetaS 0.36; thetaR 0.035;"
        " alpha 0.538; m 0.468; }"
        "relativePermeability { type mualem; } Ks 1.12e-5; Ss 1e-5;";

    const char* const exponential =
        "retention { type gardner; thetaS 0.4; thetaR 0.06; alpha 2; }"
        "relativePermeability { type gardner; alpha 2; } Ks 1e-5;";

    //- Two soils, a scheme, and connections between points of them
    struct soils
    {
        PtrList<soilTable> tables;
        Foam::autoPtr<richardsFlux> flux;
        List<richardsFlux::connection> connections;

        soils
        (
            const std::string& scheme,
            const char* first,
            const char* second,
            const scalar drop
        )
        :
            connections(1)
        {
            for (const char* text : {first, second})
            {
                tables.append
                (
                    new soilTable
                    (
                        soilHydraulics("soil", dictionaryOf(text))
                    )
                );
            }

            richardsFlux::connection& c = connections[0];
            c.transmissibility = 2;
            c.drop = drop;
            c.soil2 = (first == second ? 0 : 1);
            c.Ks = 2/(1/tables[0].Ks() + 1/tables[1].Ks());

            flux = richardsFlux::New
            (
                dictionaryOf("faceFlux " + scheme + ";"),
                tables
            );
            flux->prepare(connections);
        }

        richardsFlux::flux ofUnknowns(const scalar tau1, const scalar tau2)
        {
            return (*flux)
            (
                connections[0],
                tables[0].at(tau1),
                tables[connections[0].soil2].at(tau2)
            );
        }

        richardsFlux::flux ofHeads(const scalar h1, const scalar h2)
        {
            return ofUnknowns
            (
                tables[0].tauOfHead(h1),
                tables[connections[0].soil2].tauOfHead(h2)
            );
        }
    };

    const scalar heads[] = {-30, -5.5, -1.2, -0.3, -0.04, -0.0005, 0.2, 3};
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Water at rest stays at rest, in one soil and across two")
{
    for (const scalar drop : {-0.7, 0.4, 2.0})
    {
        soils one("monotone", stiff, stiff, drop);
        soils two("monotone", embankment, stiff, drop);

        for (const scalar h : heads)
        {
            // Round-off of heads of metres times Ks
            CHECK(std::abs(one.ofHeads(h, h + drop).value) < 1e-18);
            CHECK(std::abs(two.ofHeads(h, h + drop).value) < 1e-18);
        }
    }
}


TEST_CASE("Steady flow down through an exponential soil is exact")
{
    // With K = Ks exp(a h) the steady flux between two points, the upper one
    // D above the lower one, is (K1 - K2 exp(-a D))/(1 - exp(-a D))
    const scalar Ks = 1e-5;
    const scalar alpha = 2;
    const scalar drop = 0.35;
    const scalar upper = -0.2;
    const scalar lower = -0.6;

    soils s("monotone", exponential, exponential, drop);

    const scalar decay = std::exp(-alpha*drop);
    const scalar K1 = Ks*std::exp(alpha*upper);
    const scalar K2 = Ks*std::exp(alpha*lower);
    const scalar q = (K1 - K2*decay)/(1 - decay);

    // The table is exact to 1e-5
    CHECK
    (
        s.ofHeads(upper, lower).value
     == Approx(2*drop*q).epsilon(1e-4)
    );
}


TEST_CASE("Fluxes are monotone and have their own derivatives")
{
    const scalar step = 1e-7;

    for (const std::string scheme : {"monotone", "integralUpwind"})
    {
        for (const char* second : {stiff, embankment})
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
                        const scalar tau2 =
                            s.tables[s.connections[0].soil2].tauOfHead(h2);
                        const richardsFlux::flux f(s.ofUnknowns(tau1, tau2));

                        CHECK(f.dFirst >= 0);
                        CHECK(f.dSecond <= 0);

                        const scalar quotient1 =
                            (
                                s.ofUnknowns(tau1 + step, tau2).value
                              - s.ofUnknowns(tau1 - step, tau2).value
                            )/(2*step);
                        const scalar quotient2 =
                            (
                                s.ofUnknowns(tau1, tau2 + step).value
                              - s.ofUnknowns(tau1, tau2 - step).value
                            )/(2*step);

                        // Round-off of the quotient, and bends of the table
                        // within the step
                        const scalar tolerance =
                            1e-2*std::max(f.dFirst, -f.dSecond)
                          + 1e-9*std::abs(f.value)/step;

                        CHECK(std::abs(f.dFirst - quotient1) <= tolerance);
                        CHECK(std::abs(f.dSecond - quotient2) <= tolerance);
                    }
                }
            }
        }
    }
}


TEST_CASE("A flux turns its sign when the points change places")
{
    soils down("monotone", embankment, embankment, 0.4);
    soils up("monotone", embankment, embankment, -0.4);

    for (const scalar h1 : heads)
    {
        for (const scalar h2 : heads)
        {
            const richardsFlux::flux a(down.ofHeads(h1, h2));
            const richardsFlux::flux b(up.ofHeads(h2, h1));

            CHECK(a.value == Approx(-b.value).epsilon(1e-12));
            CHECK(a.dFirst == Approx(-b.dSecond).epsilon(1e-12));
        }
    }
}


TEST_CASE("Saturated soil follows Darcy's law")
{
    soils s("monotone", embankment, embankment, 0.4);

    // T Ks dH
    CHECK(s.ofHeads(1, 0.6).value == Approx(2*1.12e-5*0.8).epsilon(1e-10));
    CHECK(s.ofHeads(1, 2.4).value == Approx(-2*1.12e-5).epsilon(1e-10));

    // Across two soils with the harmonic mean of equal halves
    soils two("monotone", embankment, stiff, 0.4);
    const scalar Ks = 2/(1/1.12e-5 + 1/1.4e-6);
    CHECK(two.ofHeads(1, 0.6).value == Approx(2*Ks*0.8).epsilon(1e-10));
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
