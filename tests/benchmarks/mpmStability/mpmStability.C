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
    mpmStability [largest number of cells]

    The flying bar over CFL number and cells for each shape function, transfer
    and order of updates: the worst of three places of the grid under the bar.
    Table on the standard output.

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

    std::cout
        << "shape,transfer,update,cfl,cells,log10Error,energyDrift,failed\n";
    for (const std::string& shape : mpm::Settings::shapeFunctions())
    {
        for (const std::string& transfer : mpm::Settings::transferSchemes())
        {
            for (const std::string& update : mpm::Settings::stressUpdates())
            {
                const Method m{shape, transfer, update};
                // The largest CFL number that the settings allow is 1.2
                for
                (
                    const double cfl :
                    {0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2}
                )
                {
                    for (int cells = 8; cells <= most; cells *= 2)
                    {
                        Outcome worst;
                        worst.error = worst.energyDrift = 0;
                        worst.failed = false;
                        for (const double offset : {0.0, 0.13, 0.37})
                        {
                            const Outcome o = bar(m, cells, cfl, offset);
                            worst.error = std::max(worst.error, o.error);
                            worst.failed = worst.failed || o.failed;
                            if
                            (
                                std::fabs(o.energyDrift)
                              > std::fabs(worst.energyDrift)
                            )
                            {
                                worst.energyDrift = o.energyDrift;
                            }
                        }
                        std::cout
                            << shape << ',' << transfer << ',' << update << ','
                            << cfl << ',' << cells << ','
                            << std::log10(worst.error) << ','
                            << worst.energyDrift << ',' << worst.failed
                            << std::endl;
                    }
                }
            }
        }
    }
    return 0;
}

// ************************************************************************* //
