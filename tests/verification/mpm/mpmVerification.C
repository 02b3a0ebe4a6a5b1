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

Application
    Test-mpmVerification

Description
    Test-mpmVerification <case> [-long]

    Runs one verification case of the material point method against its exact
    answer and prints a PASS or FAIL line a check. Exit code 1 if one failed.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cfenv>
#include <cstring>
#include <iostream>
#include <map>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace verification;

    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);

    const std::map<std::string, void (*)(Checks&, bool)> cases
    {
        {"barVibration", barVibration},
        {"methodPairs", methodPairs},
        {"manufactured", manufactured},
        {"blockOnIncline", blockOnIncline},
        {"wallLoads", wallLoads},
        {"absorbingSides", absorbingSides},
        {"twoDisks", twoDisks},
        {"spinningBody", spinningBody},
        {"selfWeightColumn", selfWeightColumn},
        {"infiniteSlope", infiniteSlope},
        {"columnCollapse", columnCollapse},
        {"softeningRunout", softeningRunout},
        {"validationSlope", validationSlope},
        {"griffithsLane", griffithsLane},
        {"waterTableInside", waterTableInside},
        {"verticalCut", verticalCut},
        {"energyAccount", energyAccount},
        {"rodCollapse", rodCollapse},
        {"hoopStrain", hoopStrain},
        {"cavityPressure", cavityPressure},
        {"sleep", verification::sleep}
    };

    const auto chosen = cases.find(argc > 1 ? argv[1] : "");
    if (chosen == cases.end())
    {
        std::cerr << "Usage: " << argv[0] << " <case> [-long]; cases:";
        for (const auto& one : cases)
        {
            std::cerr << ' ' << one.first;
        }
        std::cerr << std::endl;
        return 2;
    }
    const bool longVersion = argc > 2 && !std::strcmp(argv[2], "-long");

    Checks checks(chosen->first);
    try
    {
        chosen->second(checks, longVersion);
    }
    catch (const std::exception& error)
    {
        std::cout
            << "FAIL " << chosen->first << ": " << error.what() << std::endl;
        return 1;
    }
    return checks.failures() > 0;
}

// ************************************************************************* //
