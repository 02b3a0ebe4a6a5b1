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
    The tables of Newton's unknown against the curves.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "soilDictionary.H"
#include "soilTable.H"

#include <cmath>

using doctest::Approx;
using Foam::label;
using Foam::scalar;
using Foam::scalarList;
using Foam::soilHydraulics;
using Foam::soilTable;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    struct tableError
    {
        scalar theta = 0;
        scalar storage = 0;
        scalar K = 0;
        scalar head = 0;
    };

    //- Largest error between the end of the bridge and 1 km of suction; that
    //  of K relative, the others absolute
    tableError errorOf(const soilHydraulics& soil, const soilTable& table)
    {
        tableError e;
        const scalar wettest = -1.001*table.heads()[1];
        const scalar driest = std::min(1e3, -table.minHead());
        const label n = 20011;

        for (label i = 0; i <= n; ++i)
        {
            const scalar h =
                -wettest*std::pow(driest/wettest, scalar(i)/n)*0.999999;
            const soilTable::state s(table.at(table.tauOfHead(h)));

            e.head = std::max(e.head, std::abs(s.head - h));
            e.theta = std::max(e.theta, std::abs(s.theta - soil.theta(h)));
            e.storage =
                std::max(e.storage, std::abs(s.storage - soil.storage(h)));
            e.K = std::max(e.K, std::abs(s.K/soil.K(h) - 1));
        }

        return e;
    }

    //- Values and derivatives agree within and across intervals
    void checkConsistency(const soilTable& table, const scalar tau)
    {
        if (!table.aboveDryEnd(tau))
        {
            return;
        }

        CAPTURE(tau);
        const soilTable::state s(table.at(tau));
        const scalar d = 1e-6*std::max(std::abs(tau), scalar(1e-6));

        // Inside an interval everything is at most quadratic: central
        // differences are exact but for round-off
        const soilTable::state up(table.at(tau + d));
        const soilTable::state down(table.at(tau - d));

        if (up.interval != s.interval || down.interval != s.interval)
        {
            return;
        }

        const scalar tolerance = 1e-6;
        CHECK
        (
            (up.head - down.head)/(2*d) == Approx(s.dHead).epsilon(tolerance)
        );
        CHECK
        (
            (up.theta - down.theta)/(2*d)
         == Approx(s.dTheta).epsilon(tolerance)
        );
        CHECK
        (
            (up.storage - down.storage)/(2*d)
         == Approx(s.dStorage).epsilon(tolerance)
        );
        CHECK
        (
            (up.K - down.K)/(2*d)/table.Ks()
         == Approx(s.dK/table.Ks()).epsilon(tolerance)
        );
        CHECK
        (
            (up.Phi - down.Phi)/(2*d)/table.Ks()
         == Approx(s.dPhi/table.Ks()).epsilon(1e-4)
        );
    }
}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("the table follows the curves")
{
    // The chord of a power law s^-p over a step of 0.01 in ln(K) is off by
    // (1 + 1/p)/8 of the square of the step: 2.5e-5 of K for p = 1. Theta is
    // less curved than K
    for
    (
        const Foam::dictionary& dict :
        {
            stiffSoil(), stiffSoil("0.02"), embankment(), gardnerSoil(),
            brooksCoreySoil(), haverkampSand(), tabulatedSoil(loamTable())
        }
    )
    {
        const soilHydraulics soil("soil", dict);
        const soilTable table(soil);
        const tableError e(errorOf(soil, table));

        CAPTURE(table.nNodes());
        MESSAGE
        (
            "nodes ", table.nNodes(), ", errors: theta ", e.theta,
            ", storage ", e.storage, ", K ", e.K, ", head ", e.head
        );
        CHECK(e.theta < 1e-6);
        CHECK(e.storage < 1e-6);
        CHECK(e.K < 2.5e-5);
        CHECK(table.nNodes() < 20000);
    }
}


TEST_CASE("finer nodes reach a millionth")
{
    const soilHydraulics soil("embankment", embankment());
    soilTable::controls c;
    c.nodesPerDecade = 1600;
    c.maxLogStep = 0.0025;

    const tableError e(errorOf(soil, soilTable(soil, c)));
    CHECK(e.theta < 1e-6);
    CHECK(e.K < 1e-6);
}


TEST_CASE("the unknown is Se + kr - 2 and grows with the head")
{
    const soilHydraulics soil("embankment", embankment());
    const soilTable table(soil);

    const scalarList& heads = table.heads();
    for (label i = 0; i < heads.size(); i += 37)
    {
        const scalar h = heads[i];
        const scalar tau =
            soil.retention().Se(h) + soil.permeability().kr(h) - 2;

        CHECK(std::abs(table.tauOfHead(h) - tau) < 1e-14);
    }

    scalar last = -1e300;
    for (scalar h = -5e3; h < 3; h += 0.173)
    {
        const scalar tau = table.tauOfHead(h);
        CHECK(tau > last);
        last = tau;
    }
}


TEST_CASE("head and unknown invert each other")
{
    // tau is rounded at 2.2e-16 and dh/dtau grows with dryness: 1e-9 m at
    // 100 m of suction for these soils, far less near saturation
    for
    (
        const Foam::dictionary& dict : {stiffSoil(), embankment()}
    )
    {
        const soilHydraulics soil("soil", dict);
        const soilTable table(soil);

        for (const scalar h : {-100.0, -5.5, -0.02, -5e-4, -1e-9, 0.0, 7.0})
        {
            const soilTable::state s(table.at(table.tauOfHead(h)));
            CHECK(std::abs(s.head - h) <= 1e-15*(1 + s.dHead));
        }
    }
}


TEST_CASE("derivatives belong to the values")
{
    for
    (
        const Foam::dictionary& dict :
        {
            stiffSoil(), stiffSoil("0.02"), embankment("0.01"), gardnerSoil(),
            brooksCoreySoil(), haverkampSand(),
            tabulatedSoil(loamTable(), "0.01")
        }
    )
    {
        const soilHydraulics soil("soil", dict);
        const soilTable table(soil);

        for
        (
            const scalar tau :
            {-1.9, -1.5, -1.0, -0.77, -0.3, -0.02, -1e-3, 0.4, 12.0}
        )
        {
            checkConsistency(table, tau);
        }
    }
}


TEST_CASE("the table is continuous at its ends")
{
    const soilHydraulics soil("embankment", embankment());
    const soilTable table(soil);

    const scalar dryTau = table.tauOfHead(table.minHead());

    for (const scalar tau : {0.0, dryTau})
    {
        const soilTable::state up(table.at(tau + 1e-13));
        const soilTable::state down(table.at(tau - 1e-13));

        CHECK(std::abs(up.head - down.head) <= 2.1e-13*(up.dHead + down.dHead));
        CHECK
        (
            std::abs(up.storage - down.storage)
         <= 1e-15 + 2.1e-13*(up.dStorage + down.dStorage)
        );
        CHECK(std::abs(up.K - down.K) < 1e-12*table.Ks());
    }

    CHECK(table.aboveDryEnd(dryTau));
    CHECK_FALSE(table.aboveDryEnd(dryTau - 1e-3));

    // Drier than the table everything stays defined and monotone
    const soilTable::state dry(table.at(table.tauOfHead(-1e8)));
    CHECK(dry.head == Approx(-1e8));
    CHECK(dry.dHead > 0);
    CHECK(dry.dTheta > 0);
    CHECK(dry.dPhi > 0);
    CHECK(dry.K > 0);
    CHECK(dry.theta > 0.035);
}


TEST_CASE("the table ends where the curves do")
{
    const soilHydraulics soil("loam", tabulatedSoil(loamTable()));
    const soilTable table(soil);

    CHECK(table.saturationHead() == -0.05);
    CHECK(table.minHead() == -150);

    // Drier, Se goes on as 1/(1 + b x) with the last slope: theta never falls
    // below thetaR
    const soilTable::state end(table.at(table.tauOfHead(-150)));
    const soilTable::state dry(table.at(table.tauOfHead(-160)));
    const scalar b = end.dTheta/end.dHead/(end.theta - 0.05);

    CHECK
    (
        dry.theta - 0.05
     == Approx((end.theta - 0.05)/(1 + 10*b)).epsilon(1e-6)
    );
    CHECK(table.at(table.tauOfHead(-1e12)).theta >= 0.05);
}


TEST_CASE("a soil that never desaturates is refused")
{
    // 1e-9 of 1e6 m: Se falls by 1e-15 over the whole table
    const soilHydraulics soil
    (
        "glass",
        dictionaryOf
        (
            "retention { type vanGenuchten; thetaS 0.4; thetaR 0.1;"
            " alpha 1e-20; n 2; }"
            "relativePermeability { type gardner; alpha 1e-20; } Ks 1;"
        )
    );

    std::string message;
    try
    {
        const soilTable table(soil);
    }
    catch (const Foam::error& error)
    {
        message = error.message();
    }

    CHECK(message.find("glass stays saturated up to 1e+06") != std::string::npos);
}


TEST_CASE("curves that fall without end keep the table small and positive")
{
    // ln(kr) falls to -1e8 at 1 km, Se to 0.93
    const soilHydraulics soil
    (
        "wall",
        dictionaryOf
        (
            "retention { type vanGenuchten; thetaS 0.4; thetaR 0.1;"
            " alpha 1; n 1.01; }"
            "relativePermeability { type gardner; alpha 1e5; } Ks 1e-5;"
        )
    );
    const soilTable table(soil);

    CHECK(table.nNodes() < 20000);
    CHECK(table.K().last() > 0);
    for (const scalar slope : table.dKdPhi())
    {
        CHECK(slope >= 0);
        CHECK(std::isfinite(slope));
    }
}


TEST_CASE("the Kirchhoff potential is the integral of K")
{
    // Quadrature of Eq. 12 over the suction with mpmath, 40 digits:
    //     -quad(K, [0, 1e-6, 1e-3, 0.1, s])
    const soilTable table(soilHydraulics("embankment", embankment()));

    const scalar reference[3][2] =
    {
        {-0.5, -3.92907595799968e-6},
        {-2, -7.12875302934998e-6},
        {-5, -7.63484912406761e-6}
    };

    for (const auto& r : reference)
    {
        const soilTable::state s(table.at(table.tauOfHead(r[0])));
        CHECK(s.Phi == Approx(r[1]).epsilon(1e-5));
    }

    // Exponential: Ks (exp(alpha h) - 1)/alpha
    const soilTable gardner(soilHydraulics("gardner", gardnerSoil()));

    for (const scalar h : {-0.01, -0.7, -3.0, -9.0})
    {
        const soilTable::state s(gardner.at(gardner.tauOfHead(h)));
        CHECK(s.Phi == Approx(1e-5*std::expm1(2*h)/2).epsilon(1e-5));
    }
}


// ************************************************************************* //
