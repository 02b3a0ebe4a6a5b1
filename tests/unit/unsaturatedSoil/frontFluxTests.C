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
    The potential of the front flux against closed forms and quadrature of 40
    digits.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "frontFluxTable.H"
#include "soilDictionary.H"
#include "soilTable.H"

#include <cmath>

using doctest::Approx;
using Foam::frontFluxTable;
using Foam::scalar;
using Foam::scalarList;
using Foam::soilHydraulics;
using Foam::soilTable;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
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
