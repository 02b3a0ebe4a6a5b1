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
    Rain: exact integrals, the times at which it changes, and what is refused.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "IStringStream.H"
#include "rainfall.H"

#include <string>

using doctest::Approx;
using Foam::dictionary;
using Foam::rainfall;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    dictionary rainOf(const std::string& text)
    {
        return dictionary(Foam::IStringStream("rainfall " + text)());
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("A hyetograph integrates exactly and knows where it changes")
{
    const rainfall rates
    (
        rainOf("{ type hyetograph; values ((10 1e-6) (20 1e-6) (30 4e-6)); }")
    );

    CHECK(rates.depth(0, 30) == Approx(6e-5));
    CHECK(rates.depth(5, 25) == Approx(5e-6 + 1e-5 + 2e-5));
    CHECK(rates.depth(30, 100) == 0);

    // At 10 s an interval ends but not the rate
    CHECK(rates.nextBreakPoint(-1) == 0);
    CHECK(rates.nextBreakPoint(0) == 20);
    CHECK(rates.nextBreakPoint(20) == 30);
    CHECK(rates.nextBreakPoint(30) == Foam::VGREAT);

    const rainfall depths
    (
        rainOf("{ type hyetograph; start 100; interval 60; depths (3 0 1); }")
    );

    CHECK(depths.depth(0, 1000) == Approx(4e-3));
    CHECK(depths.depth(100, 130) == Approx(1.5e-3));
    CHECK(depths.depth(160, 220) == Approx(0));
    CHECK(depths.nextBreakPoint(100) == 160);
}


TEST_CASE("Functions of OpenFOAM serve as rain")
{
    CHECK(rainfall(rainOf("constant 2e-6;")).depth(3, 8) == Approx(1e-5));

    const rainfall table(rainOf("table ((0 0) (10 4e-6) (20 4e-6));"));
    CHECK(table.depth(0, 10) == Approx(2e-5));
    CHECK(table.nextBreakPoint(0) == 10);
}


TEST_CASE("Negative rain and incomplete hyetographs are refused")
{
    for
    (
        const std::string text :
        {
            "constant -1e-6;",
            "table ((0 0) (10 -1e-6));",
            "{ type hyetograph; values ((10 1e-6) (20 -1e-6)); }",
            "{ type hyetograph; depths (1 -1); }",
            "{ type hyetograph; values ((10 1e-6) (10 2e-6)); }",
            "{ type hyetograph; interval 0; depths (1); }",
            "{ type hyetograph; }",
            "monsoon;"
        }
    )
    {
        CAPTURE(text);
        CHECK_THROWS_AS(rainfall(rainOf(text)), Foam::IOerror);
    }
}

// ************************************************************************* //
