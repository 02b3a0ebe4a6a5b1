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
    Slides whose blocks sleep at rest against the same slides awake: the largest
    displacement and the front must agree, and the gain is shown. A column that
    collapses and one of weak soil that runs far; long version: the validation
    slope too.

\*---------------------------------------------------------------------------*/

#include "../validationSlope/slopeStates.H"

#include <cmath>
#include <ctime>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace verification
{
namespace
{

//- A column on a rough base beside a roller; sizes in m
std::unique_ptr<mpm::Run> column
(
    const double width,
    const double height,
    const double cellSize,
    const double phi,
    const double E,
    const double sleepVelocity
)
{
    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity = {{0, -gravity, 0}};
    settings.sleepVelocity = sleepVelocity;

    mpm::PointData points = seed
    (
        2, cellSize, 2, {{0, 0, 0}}, {{width, height, 0}},
        [](const mpm::Point3&) { return true; },
        2000
    );
    points.frictionAngle.assign(points.size(), phi);

    mpm::Material soil;
    soil.E = E;
    soil.nu = 0.3;
    return mpm::Run::New
    (
        2,
        settings,
        points,
        {soil},
        {
            plane("base", "rough", {{0, 0, 0}}, {{0, 1, 0}}),
            plane("back", "roller", {{0, 0, 0}}, {{1, 0, 0}})
        }
    );
}


struct Slide
{
    mpm::Diagnostics end;
    double asleep, seconds;
};


Slide slide(mpm::Run& run, const double endTime)
{
    Slide result{};
    const std::clock_t start = std::clock();
    const int parts = 20;
    for (int i = 1; i <= parts; ++i)
    {
        run.advance(endTime*i/parts);
        result.asleep +=
            double(run.diagnostics().sleepingPoints)
           /double(run.nPoints())/parts;
    }
    result.seconds = double(std::clock() - start)/CLOCKS_PER_SEC;
    result.end = run.diagnostics();
    return result;
}


//- make(sleepVelocity) makes the run
void compare
(
    Checks& checks,
    const std::string& name,
    const double sleepVelocity,
    const double endTime,
    const std::function<std::unique_ptr<mpm::Run>(double)>& make
)
{
    const Slide awake = slide(*make(0), endTime);
    const Slide asleep = slide(*make(sleepVelocity), endTime);

    const double tolerance = 1e-3;
    const std::string reason("0.1 % of the runout");
    checks.less
    (
        name + ": largest displacement, difference relative",
        std::fabs(asleep.end.maxDisplacement/awake.end.maxDisplacement - 1),
        tolerance,
        reason
    );
    checks.less
    (
        name + ": front, difference over the largest displacement",
        std::fabs(asleep.end.front - awake.end.front)
       /awake.end.maxDisplacement,
        tolerance,
        reason
    );
    checks.within
    (
        name + ": mean share of the points asleep",
        asleep.asleep,
        0.1,
        1,
        "or nothing is tested"
    );
    checks.report
    (
        name + ": processor time awake over that with sleep",
        awake.seconds/asleep.seconds
    );
}

} // End anonymous namespace
} // End namespace verification


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void verification::sleep(Checks& checks, const bool longVersion)
{
    compare
    (
        checks, "column", 0.003, 10,
        [](const double v) { return column(4, 4, 0.2, 30, 5e6, v); }
    );
    compare
    (
        checks, "long runout", 0.003, 15,
        [](const double v) { return column(6, 12, 0.4, 20, 2e7, v); }
    );
    if (longVersion)
    {
        compare
        (
            checks, "validation slope, state c", 0.008, 15,
            [](const double v)
            {
                mpm::Settings numerics;
                numerics.sleepVelocity = v;
                mpm::StartReport report;
                return slopeStates::slope
                (
                    slopeStates::stateC, 1, 0, report, numerics
                );
            }
        );
    }
}

// ************************************************************************* //
