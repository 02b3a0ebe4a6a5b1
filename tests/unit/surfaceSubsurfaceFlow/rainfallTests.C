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
#include "hyetograph.H"
#include "uniformRain.H"
#include "planOverlap.H"

#include <fstream>
#include <string>

using doctest::Approx;
using Foam::dictionary;
using Foam::scalar;
using Foam::uniformRain;
using Foam::vector2D;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- The rain of an entry
    uniformRain rainOf(const std::string& text)
    {
        return uniformRain
        (
            "rainfall",
            dictionary(Foam::IStringStream("rainfall " + text)())
        );
    }

    //- The rain of a csv file
    uniformRain rainOfFile
    (
        const std::string& lines,
        const std::string& entries
    )
    {
        std::ofstream("rain.csv") << lines;

        return rainOf
        (
            "{ type hyetograph; file \"rain.csv\"; " + entries + " }"
        );
    }

    //- Hours 1 and 2, nothing known of 3, hour 4; by the ends of the hours
    const std::string hours =
        "# gauge\ntime,rain\n3600,2\n7200,5.4\n14400,1\n";
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("A hyetograph integrates exactly and knows where it changes")
{
    const uniformRain rates
    (
        rainOf("{ type hyetograph; values ((10 1e-6) (20 1e-6) (30 4e-6)); }")
    );

    CHECK(rates.depth(0, 30) == Approx(6e-5));
    CHECK(rates.depth(5, 25) == Approx(5e-6 + 1e-5 + 2e-5));
    CHECK(rates.depth(-5, 5) == Approx(5e-6));
    CHECK(rates.depth(30, 100) == 0);

    // At 10 s an interval ends but not the rate
    CHECK(rates.nextBreakPoint(-1) == 0);
    CHECK(rates.nextBreakPoint(0) == 20);
    CHECK(rates.nextBreakPoint(20) == 30);
    CHECK(rates.nextBreakPoint(30) == Foam::VGREAT);

    const uniformRain depths
    (
        rainOf("{ type hyetograph; start 100; interval 60; depths (3 0 1); }")
    );

    CHECK(depths.depth(0, 1000) == Approx(4e-3));
    CHECK(depths.depth(100, 130) == Approx(1.5e-3));
    CHECK(depths.depth(160, 220) == Approx(0));
    CHECK(depths.nextBreakPoint(100) == 160);

    CHECK(depths.recorded().depth == Approx(4e-3));
    CHECK(depths.recorded().begin == 100);
    CHECK(depths.recorded().end == 280);
}


TEST_CASE("Functions of OpenFOAM serve as rain")
{
    CHECK(rainOf("constant 2e-6;").depth(3, 8) == Approx(1e-5));

    const uniformRain table(rainOf("table ((0 0) (10 4e-6) (20 4e-6));"));
    CHECK(table.depth(0, 10) == Approx(2e-5));
    CHECK(table.nextBreakPoint(0) == 10);
    CHECK_FALSE(table.recorded().given);
}


TEST_CASE("A csv file: units, columns, stamps")
{
    const std::string zero = "gapPolicy zero; interval 3600;";

    CHECK
    (
        rainOfFile(hours, "unit \"mm/h\";" + zero).depth(0, 14400)
     == Approx(8.4e-3)
    );
    CHECK
    (
        rainOfFile(hours, "unit \"mm\";" + zero).depth(3600, 5400)
     == Approx(2.7e-3)
    );
    CHECK
    (
        rainOfFile(hours, "unit \"mm/d\";" + zero).depth(0, 7200)
     == Approx(7.4e-3/24)
    );
    CHECK
    (
        rainOfFile("t,r\n10,1e-6\n20,3e-6\n", "unit \"m/s\";").depth(0, 20)
     == Approx(4e-5)
    );

    // The stamp is the beginning: hours 2 and 3, and 5
    const uniformRain later
    (
        rainOfFile(hours, "unit \"mm/h\"; stamp begin;" + zero)
    );
    CHECK(later.depth(0, 3600) == 0);
    CHECK(later.depth(3600, 10800) == Approx(7.4e-3));
    CHECK(later.depth(14400, 18000) == Approx(1e-3));

    // Other columns, another separator, hours and quotes
    CHECK
    (
        rainOfFile
        (
            "\"id\";\"mm\";\"hour\"\n7;4;1\n7;2;2\n",
            "unit \"mm/h\"; separator \";\"; timeColumn hour; rainColumn mm;"
            "timeUnit h;"
        ).depth(1800, 5400)
     == Approx(3e-3)
    );

    // Dates over the end of a leap February
    const uniformRain dates
    (
        rainOfFile
        (
            "when,rain\r\n2016-02-29 23:00,1\r\n2016-03-01 00:00,2\r\n"
            "2016/03/01T01:00:00,4\r\n",
            "unit \"mm/h\"; timeUnit date; origin \"2016-02-28 22:00\";"
        )
    );
    CHECK(dates.recorded().begin == 24*3600);
    CHECK(dates.recorded().end == 27*3600);
    CHECK(dates.depth(24*3600, 27*3600) == Approx(7e-3));

    // From one time to the next
    const uniformRain tips
    (
        rainOfFile
        (
            "t,r\n0,0\n10,2\n40,3\n",
            "unit \"mm\"; interval variable;"
        )
    );
    CHECK(tips.depth(0, 40) == Approx(5e-3));
    CHECK(tips.depth(10, 25) == Approx(1.5e-3));
}


TEST_CASE("A gap in a csv file is an error unless a policy is given")
{
    const std::string unit = "unit \"mm/h\"; interval 3600;";

    const uniformRain strict(rainOfFile(hours, unit));
    CHECK(strict.depth(0, 7200) == Approx(7.4e-3));
    CHECK_THROWS_AS(strict.depth(0, 7201), Foam::IOerror);
    CHECK_THROWS_AS(strict.depth(-1, 10), Foam::IOerror);
    CHECK_THROWS_AS(strict.depth(14000, 14401), Foam::IOerror);
    CHECK(strict.recorded().depth == Approx(8.4e-3));

    const uniformRain zero(rainOfFile(hours, unit + "gapPolicy zero;"));
    CHECK(zero.depth(-100, 20000) == Approx(8.4e-3));

    const uniformRain hold(rainOfFile(hours, unit + "gapPolicy hold;"));
    CHECK(hold.depth(0, 14400) == Approx(8.4e-3 + 5.4e-3));
    CHECK(hold.depth(14400, 18000) == Approx(1e-3));
    CHECK_THROWS_AS(hold.depth(-1, 0), Foam::IOerror);

    // Fields that are empty, no number, or the mark of a missing value
    for (const std::string field : {"", "NA", "nan", "-9999"})
    {
        CAPTURE(field);
        const std::string lines = "t,r\n10,1\n20," + field + "\n30,3\n";

        const uniformRain gap(rainOfFile(lines, "unit \"m/s\";"));
        CHECK(gap.depth(0, 10) == Approx(10));
        CHECK_THROWS_AS(gap.depth(10, 20), Foam::IOerror);
        CHECK
        (
            rainOfFile(lines, "unit \"m/s\"; gapPolicy zero;").depth(0, 30)
         == Approx(40)
        );
        CHECK
        (
            rainOfFile(lines, "unit \"m/s\"; gapPolicy hold;").depth(0, 30)
         == Approx(50)
        );
    }
}


TEST_CASE("Negative rain, incomplete hyetographs and bad files are refused")
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
            "{ type hyetograph; depths (1); values ((1 1)); }",
            "{ type hyetograph; }",
            "{ type hyetograph; file \"noSuchFile\"; unit \"mm\"; }",
            "monsoon;"
        }
    )
    {
        CAPTURE(text);
        CHECK_THROWS_AS(rainOf(text), Foam::IOerror);
    }

    const std::string unit = "unit \"mm/h\";";

    // Lines with entries that don't suit them
    for
    (
        const auto& bad :
        std::initializer_list<std::pair<const char*, std::string>>
        {
            {"t,r\n10,1\n20,2\n", ""},
            {"t,r\n10,1\n20,2\n", "unit \"inch\";"},
            {"t,r\n10,1\n20,2\n", unit + "gapPolicy guess;"},
            {"t,r\n10,1\n20,2\n", unit + "stamp middle;"},
            {"t,r\n10,1\n20,2\n", unit + "timeUnit week;"},
            {"t,r\n10,1\n20,2\n", unit + "timeUnit date; origin \"2016\";"},
            {"t,r\n10,1\n20,2\n", unit + "rainColumn depth;"},
            {"t,r\n10,1\n20,2\n", unit + "interval 20;"},
            {"t,r\n10,1\n20,2\n", unit + "separator \", \";"},
            {"t,r\n10,1\n", unit},
            {"t,r\n10,1\n5,2\n", unit},
            {"t,r\n10,1\nten,2\n", unit},
            {"t,r\n10,1\n20,-2\n", unit},
            {"t,r\n10,1\n20,2,3\n", unit},
            {"t,r\n", unit},
            {"", unit}
        }
    )
    {
        CAPTURE(bad.first);
        CAPTURE(bad.second);
        CHECK_THROWS_AS(rainOfFile(bad.first, bad.second), Foam::IOerror);
    }
}


TEST_CASE("Overlap of a polygon and a rectangle")
{
    const Foam::List<vector2D> triangle
    ({
        vector2D(0, 0), vector2D(4, 0), vector2D(0, 4)
    });

    const auto area = []
    (
        const auto& polygon,
        const scalar a,
        const scalar b,
        const scalar c,
        const scalar d
    )
    {
        return Foam::planOverlap(polygon, vector2D(a, b), vector2D(c, d));
    };

    CHECK(area(triangle, -1, -1, 5, 5) == Approx(8));
    CHECK(area(triangle, 0, 0, 1, 1) == Approx(1));
    CHECK(area(triangle, 1, 1, 3, 3) == Approx(2));
    CHECK(area(triangle, 2, 2, 3, 3) == 0);
    CHECK(area(triangle, -3, 1, -1, 2) == 0);

    // The other sense of rotation, and a shape with a notch
    const Foam::List<vector2D> notched
    ({
        vector2D(0, 4), vector2D(2, 2), vector2D(4, 4), vector2D(4, 0),
        vector2D(0, 0)
    });
    CHECK(area(notched, 0, 0, 4, 4) == Approx(12));
    CHECK(area(notched, 1, 2, 3, 4) == Approx(1));
    CHECK(area(notched, 0, 3, 4, 4) == Approx(1));

    // The parts in the cells of a grid make the whole
    scalar sum = 0;
    for (int i = 0; i < 7; ++i)
    {
        for (int j = 0; j < 7; ++j)
        {
            sum += area
            (
                notched, 0.7*i - 0.3, 0.7*j - 0.3, 0.7*i + 0.4, 0.7*j + 0.4
            );
        }
    }
    CHECK(sum == Approx(12).epsilon(1e-12));
}

// ************************************************************************* //
