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
    mpmAccuracy [largest number of cells]

    Error against processor time of each shape function and transfer on the
    flying bar, the column under its own weight, the manufactured square and
    vortex, the axisymmetric cylinder, and the collapse of a column of sand,
    whose error is the difference from the default on cells of half the
    smallest size. Table on the standard output.

\*---------------------------------------------------------------------------*/

#include "methodCases.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace methodCases;

    const int most = argc > 1 ? std::atoi(argv[1]) : 128;

    constexpr int collapseCells = 64;

    struct Case
    {
        const char* name;

        //- Points along the other direction make these dearer
        int mostCells;
        Outcome (*solve)(const Method&, int);
    };
    const Case cases[] =
    {
        {"bar", 128, [](const Method& m, int n) { return bar(m, n); }},
        {"column", 128, [](const Method& m, int n) { return column(m, n); }},
        {"square", 64, [](const Method& m, int n) { return axisAligned(m, n); }},
        {"vortex", 32, [](const Method& m, int n) { return vortex(m, n); }},
        {"cylinder", 128, [](const Method& m, int n) { return cylinder(m, n); }},
        {
            "collapse",
            collapseCells,
            [](const Method& m, int n)
            {
                // Against the default on cells of half the smallest size
                double unused;
                static const double finest = collapseRunout
                (
                    {"quadraticBSpline", "APIC"}, 2*collapseCells, unused
                );
                Outcome o;
                const double runout = collapseRunout(m, n, o.cpu);
                o.failed = !(runout > 0 && runout < 2*finest);
                o.error = o.failed ? 1 : std::fabs(runout/finest - 1);
                return o;
            }
        }
    };

    std::cout << "case,shape,transfer,update,cells,error,cpu_s,failed\n";
    for (const Case& one : cases)
    {
        for (const std::string& shape : mpm::Settings::shapeFunctions())
        {
            for (const std::string& transfer : mpm::Settings::transferSchemes())
            {
                for (const char* update : {"USL", "USF"})
                {
                    const Method m{shape, transfer, update};
                    // USF where it is at home: FLIP, as in the paper's family
                    if (m.update == "USF" && transfer != "FLIP")
                    {
                        continue;
                    }
                    for
                    (
                        int cells = 8;
                        cells <= std::min(most, one.mostCells);
                        cells *= 2
                    )
                    {
                        const Outcome o = one.solve(m, cells);
                        std::cout
                            << one.name << ',' << shape << ',' << transfer
                            << ',' << update << ',' << cells << ',' << o.error
                            << ',' << o.cpu << ',' << o.failed << std::endl;
                    }
                }
            }
        }
    }
    return 0;
}

// ************************************************************************* //
