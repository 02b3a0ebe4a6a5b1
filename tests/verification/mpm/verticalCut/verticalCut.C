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
    Collapse of a vertical cut in soil without friction, whose limit load is
    known: gamma H/c = 3.776, between a lower bound of 3.7752 and an upper one
    of 3.7776 (Z. Kammoun, F. Pastor, H. Smaoui, J. Pastor 2010,
    doi:10.1002/nag.887, abstract). The flow is associated and keeps its
    volume, so nothing but the discretisation stands between the answer and the
    exact one: a test of locking.

    A displacement of 5 gamma H^2/E means collapse. It is five times what the
    cut moves elastically, and with this E only 2e-3 of its height.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- gamma H/c at collapse over the exact one, less 1
double excessStrength(const std::string& antiLocking, const double cellSize)
{
    using namespace verification;

    const double rho = 2000, gamma = rho*gravity, E = 50e6, exact = 3.776;
    const double left = -2, right = 1, base = -0.5;

    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity = {{0, -gravity, 0}};
    settings.antiLocking = antiLocking;

    mpm::PointData points = seed
    (
        2,
        cellSize,
        2,
        {{left, base, 0}},
        {{right, 1, 0}},
        [](const mpm::Point3& x) { return x[0] < 0 || x[1] < 0; },
        rho
    );
    points.cohesionIntercept.assign(points.size(), gamma/exact);
    points.frictionAngle.assign(points.size(), 0);

    mpm::Material clay;
    clay.E = E;
    clay.nu = 0.3;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {clay},
        {
            plane("base", "rough", {{0, base, 0}}, {{0, 1, 0}}),
            plane("left", "roller", {{left, 0, 0}}, {{1, 0, 0}}),
            plane("right", "roller", {{right, 0, 0}}, {{-1, 0, 0}})
        }
    );

    mpm::StartSettings start;
    start.type = "elasticGravity";
    start.elasticTime = 0.3;
    start.relaxationTime = 0.2;
    start.addedCohesion = 4*gamma;
    run->establishStart(start);
    const std::string rest = saved(*run);

    return safetyFactor
    (
        [&](const double F)
        {
            return reducedStrength
            (
                *run, rest, F, 1.5,
                [](const mpm::Run& r)
                {
                    return r.diagnostics().maxDisplacement;
                }
            );
        },
        5*gamma/E,
        0.96,
        1.28,
        4
    ) - 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::verticalCut(Checks& checks, const bool longVersion)
{
    // The cut is 10 cells high: limit analysis by elements of this size is
    // some per cent above the exact value
    const double coarse = excessStrength("node", 0.1);
    checks.within
    (
        "10 cells, antiLocking node: strength above the exact one, relative",
        coarse,
        0,
        0.07,
        "an upper bound, of first order in the cell"
    );
    checks.within
    (
        "10 cells, antiLocking cell: strength above the exact one, relative",
        excessStrength("cell", 0.1),
        0,
        0.07,
        "an upper bound, of first order in the cell"
    );
    checks.within
    (
        "10 cells, no antiLocking: strength above that with it, relative",
        excessStrength("none", 0.1) - coarse,
        0.02,
        0.3,
        "it locks"
    );

    if (longVersion)
    {
        const double fine = excessStrength("node", 0.05);
        checks.within
        (
            "20 cells, antiLocking node: strength above the exact one, "
            "relative",
            fine,
            0,
            0.035,
            "half of what 10 cells may have"
        );
        checks.within
        (
            "antiLocking node: observed order",
            order(coarse, fine),
            0.7,
            3,
            "first order: the slip line is as thick as the cells"
        );
        checks.report
        (
            "20 cells, no antiLocking: strength above the exact one",
            excessStrength("none", 0.05)
        );
    }
}

// ************************************************************************* //
