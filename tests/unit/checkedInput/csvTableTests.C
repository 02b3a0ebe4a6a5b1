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
    Tables as spreadsheets of several countries write them.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "csvTable.H"
#include "dictionaryOf.H"

#include <fstream>
#include <string>

using Foam::csvTable;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- The number in the second row and column of a file
    double number(const std::string& lines, const std::string& entries = "")
    {
        std::ofstream("table.csv") << lines;
        const csvTable table(dictionaryOf("file \"table.csv\"; " + entries));

        return table.number(1, 1);
    }
}

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("The names of the columns show what separates them")
{
    CHECK(number("t,r\n0,1\n1,2.5\n") == 2.5);
    CHECK(number("t;r\n0;1\n1;2.5\n") == 2.5);
    CHECK(number("t\tr\n0\t1\n1\t2.5\n") == 2.5);
    CHECK(number("# t|r\nt|r\n0|1\n1|2.5\n", "separator \"|\";") == 2.5);

    // A comma within a name separates nothing
    CHECK(number("t, s;r, mm/h\n0;1\n1;2.5\n") == 2.5);
}


TEST_CASE("A decimal comma, where it separates nothing")
{
    CHECK(number("t;r\n0;1\n1;2,5\n") == 2.5);
    CHECK(number("t\tr\n0\t1\n1\t-2,5e-1\n") == -0.25);

    // Three fields below two names
    CHECK_THROWS_AS(number("t,r\n0,1\n1,2,5\n"), Foam::IOerror);

    // A comma for thousands
    CHECK_THROWS_AS(number("t;r\n0;1\n1;1,234.5\n"), Foam::IOerror);
}


TEST_CASE("Ends of lines, blanks, quotes and a byte-order mark")
{
    CHECK(number("\xEF\xBB\xBFt,r\r\n0,1\r\n\r\n1,\"2.5\"\r\n") == 2.5);
    CHECK(number("t,r\n0,1\n  # gauge cleaned\n1 , 2.5 \n") == 2.5);

    std::ofstream("table.csv") << "\xEF\xBB\xBFt,r\n0,1\n";
    CHECK(csvTable(dictionaryOf("file \"table.csv\";")).find("t") == 0);
}


TEST_CASE("What is no table is refused")
{
    for
    (
        const std::string bad :
        {"", "t,r\n", "t,r\n0,1\n1\n", "t,r\n0,1\n1,nan\n", "t,r\n0,1\n1,\n"}
    )
    {
        CAPTURE(bad);
        CHECK_THROWS_AS(number(bad), Foam::IOerror);
    }
    CHECK_THROWS_AS
    (
        number("t,r\n0,1\n1,2\n", "separator \", \";"),
        Foam::IOerror
    );
    CHECK_THROWS_AS
    (
        csvTable(dictionaryOf("file \"nothing.csv\";")),
        Foam::IOerror
    );
}

// ************************************************************************* //
