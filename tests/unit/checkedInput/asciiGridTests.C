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
    Grids of ESRI: where their values lie.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "asciiGrid.H"

#include <fstream>
#include <string>

using Foam::dictionary;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("An ESRI ASCII grid")
{
    const auto grid = [](const std::string& text)
    {
        std::ofstream("grid.asc") << text;
        return Foam::asciiGrid("grid.asc", dictionary());
    };

    const Foam::asciiGrid g
    (
        grid
        (
            "ncols 3\nnrows 2\nXLLCORNER 100\nYLLCORNER 50\ncellsize 10\n"
            "NODATA_value -1\n1 2 3\n4 -1 6\n"
        )
    );

    CHECK(g.east() == 130);
    CHECK(g.north() == 70);

    // The last line is the south
    CHECK(g.value(g.cell(0, 0)) == 4);
    CHECK(g.value(g.cell(1, 2)) == 3);
    CHECK_FALSE(g.hasData(g.cell(0, 1)));
    CHECK
    (
        g.matches
        (
            grid
            (
                "ncols 3\nnrows 2\nxllcenter 105\nyllcenter 55\ncellsize 10\n"
                "1 2 3\n4 5 6\n"
            )
        )
    );

    // The mark that Windows puts before UTF-8
    CHECK
    (
        g.matches
        (
            grid
            (
                "\xEF\xBB\xBFncols 3\r\nnrows 2\r\nxllcorner 100\r\n"
                "yllcorner 50\r\ncellsize 10\r\n1 2 3\r\n4 5 6\r\n"
            )
        )
    );

    for
    (
        const std::string bad :
        {
            "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\n1 2 3\n4 5 6\n",
            "ncols 3\nnrows 2\nxllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n",
            "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
            "1 2 3\n4 5\n"
        }
    )
    {
        CHECK_THROWS_AS(grid(bad), Foam::IOerror);
    }
}

// ************************************************************************* //
