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
    The tables of Newton's unknown against the curves, and the potential of the
    front flux against closed forms and quadrature of 40 digits.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "frontFluxTable.H"
#include "soilDictionary.H"
#include "soilTable.H"

#include <cmath>

using doctest::Approx;
using Foam::frontFluxTable;
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

    //- The downward front flux between two heads at the distance d
    scalar frontFlux
    (
        const soilTable& table,
        const frontFluxTable& front,
        const scalar upper,
        const scalar lower,
        const scalar d
    )
    {
        const auto w = front.weightsOf(d);
        const soilTable::state L(table.at(table.tauOfHead(upper)));
        const soilTable::state R(table.at(table.tauOfHead(lower)));

        return L.K - (front.beta(R, w) - front.beta(L, w))/d;
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


TEST_CASE("the Bernoulli function")
{
    // P/(exp(P) - 1) with mpmath, 30 digits
    CHECK(frontFluxTable::bernoulli(0) == 1);
    CHECK(frontFluxTable::bernoulli(1e-9) == Approx(0.9999999995));
    CHECK
    (
        frontFluxTable::bernoulli(1e-7)
     == Approx(0.99999995000000083).epsilon(1e-15)
    );
    CHECK(frontFluxTable::bernoulli(1) == Approx(0.58197670686932642));
    CHECK
    (
        frontFluxTable::bernoulli(40)/1.69934170211664e-16 == Approx(1)
    );
    CHECK(frontFluxTable::bernoulli(1e4) == 0);
}


TEST_CASE("the front flux is exact for an exponential soil")
{
    // Steady flow: q = (K_L - K_R exp(-alpha d))/(1 - exp(-alpha d))
    const soilTable table(soilHydraulics("gardner", gardnerSoil()));
    const scalarList D({0.01, 0.1, 0.5});
    const frontFluxTable front(table, D);

    for (const scalar d : D)
    {
        for (const scalar lower : {-0.3, -1.0, -4.0})
        {
            const scalar upper = -0.2;
            const scalar a = std::exp(-2*d);
            const scalar q =
                1e-5*(std::exp(2*upper) - std::exp(2*lower)*a)/(1 - a);

            // The table's K is off by 1.3e-5 and the difference of beta over
            // d amplifies that by the ratio of diffusive flow to K
            const scalar amplified = 1e-5*std::max(scalar(1), 1/(2*d));

            CHECK
            (
                frontFlux(table, front, upper, lower, d)
             == Approx(q).epsilon(amplified)
            );
        }
    }
}


TEST_CASE("the front potential of van Genuchten's soil")
{
    // integral of B(D dlnK/dh) K dh with mpmath, 40 digits, from Eq. 12 and
    // central differences of ln(K) with a step of 1e-14
    const scalar reference[6][3] =
    {
        {0.05, -0.5, -3.78427226833122e-6},
        {0.05, -2, -6.86717412518518e-6},
        {0.05, -5, -7.35903105488754e-6},
        {0.2, -0.5, -3.37184406542763e-6},
        {0.2, -2, -6.1218762312006e-6},
        {0.2, -5, -6.57267483675038e-6}
    };

    const soilTable table(soilHydraulics("embankment", embankment()));

    const frontFluxTable exact(table, scalarList({0.05, 0.2}));
    const frontFluxTable grid
    (
        table,
        scalarList({0.02, 0.04, 0.08, 0.16, 0.32})
    );

    for (const auto& r : reference)
    {
        const soilTable::state s(table.at(table.tauOfHead(r[1])));
        CAPTURE(r[0]);
        CAPTURE(r[1]);

        // The bridge of 1 mm flattens a K that falls 0.3 % within it
        CHECK
        (
            exact.beta(s, exact.weightsOf(r[0]))
         == Approx(r[2]).epsilon(3e-5)
        );

        // Three to four D a decade
        CHECK
        (
            grid.beta(s, grid.weightsOf(r[0])) == Approx(r[2]).epsilon(5e-3)
        );
    }
}


TEST_CASE("the front potential lies between gravity-free and none")
{
    const soilTable table(soilHydraulics("stiff", stiffSoil()));
    const frontFluxTable front(table, scalarList({0.01, 0.1, 1}));

    for (const scalar h : {-5.0, -0.1, -1e-3, -1e-6, 0.0, 0.5})
    {
        const soilTable::state s(table.at(table.tauOfHead(h)));
        scalar last = s.Phi;

        for (const scalar D : {0.0, 1e-3, 0.01, 0.03, 0.1, 0.5, 1.0})
        {
            const auto w = front.weightsOf(D);

            CHECK(front.B(s, w) >= 0);
            CHECK(front.B(s, w) <= 1);
            CHECK(front.beta(s, w) >= last - 1e-20);
            last = front.beta(s, w);
        }

        if (h >= 0)
        {
            CHECK(last == s.Phi);
        }
    }
}


TEST_CASE("few distinct distances are tabulated, many get a grid")
{
    // Values within 1e-6 of each other are one; level faces need none
    const scalarList few
    (
        frontFluxTable::nodes
        (
            scalarList({0.1, 0.2, 0.1*(1 + 1e-9), 0, -0.3, 0.2, 1e-9})
        )
    );
    REQUIRE(few.size() == 2);
    CHECK(few[0] == 0.1);
    CHECK(few[1] == 0.2);

    scalarList many(500);
    forAll(many, i)
    {
        many[i] = 0.013 + 0.001*i;
    }

    const scalarList grid(frontFluxTable::nodes(many));
    CHECK(grid.size() == 49);
    CHECK(grid.last() >= 0.512);
    CHECK(grid.last() < 0.512*std::pow(10, 1.0/16));
    CHECK(grid.first() == Approx(grid.last()/1000));

    CHECK(frontFluxTable::nodes(scalarList()).empty());
}

// ************************************************************************* //
