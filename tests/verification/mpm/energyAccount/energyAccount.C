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
    The energy account: every joule of a run is kinetic, elastic or potential
    energy, or was lost in yielding, to walls, or in the transfers between
    points and grid or by integration in time. The remainder must stay below
    1e-3 of what was dissipated.

      - a block that slides down a plane: friction takes mu N per way, exactly
      - a vibrating bar: nothing yields or rubs, so that transfers account for
        all that is lost
      - a column that collapses on a rough floor

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What the remainder may be, relative to what was lost
const double closes = 1e-3;


void reportAll(verification::Checks& checks, const mpm::Diagnostics& d)
{
    checks.report("    lost in yielding [J]", d.plasticEnergy);
    checks.report("    lost to friction along walls [J]", d.frictionEnergy);
    checks.report("    lost to impact on walls [J]", d.impactEnergy);
    checks.report("    lost in the transfers [J]", d.transferEnergy);
    checks.report("    lost by integration in time [J]", d.integrationEnergy);
    checks.report("    remainder [J]", d.energyRemainder);
}


//- Block of 2 m by 1 m on a plane on the grid, with inclined gravity
void blockSlides(verification::Checks& checks)
{
    using namespace verification;

    const double slope = 30*degree, mu = 0.1, rho = 2000, cellSize = 0.125;
    const double width = 2, height = 1;
    const double normalWeight = gravity*std::cos(slope);

    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity = {{gravity*std::sin(slope), -normalWeight, 0}};
    settings.energyAccount = true;

    mpm::PointData points = seed
    (
        2,
        cellSize,
        2,
        {{0, 0, 0}},
        {{width, height, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    for (const mpm::Point3& x : points.position)
    {
        points.sigma.push_back
        (
            {{0, -rho*normalWeight*(height - x[1]), 0, 0, 0, 0}}
        );
    }
    mpm::Material stiff;
    stiff.constitutiveModel = "linearElastic";
    stiff.E = 10e6;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {stiff},
        {plane("incline", "coulomb", {{0, 0, 0}}, {{0, 1, 0}}, mu)}
    );
    run->advance(1);

    const std::vector<double> u = run->field("displacement");
    double way = 0;
    for (std::size_t i = 0; i < run->nPoints(); ++i)
    {
        way += u[3*i]/run->nPoints();
    }
    const mpm::Diagnostics d = run->diagnostics();
    reportAll(checks, d);
    checks.less
    (
        "block: friction over mu N way, less 1",
        d.frictionEnergy/(mu*d.mass*normalWeight*way) - 1,
        5e-3,
        "the block swings on its elastic weight as it starts, so that N is "
        "its mean only"
    );
    checks.less
    (
        "block: remainder over what was lost",
        d.energyRemainder/d.lostEnergy(),
        closes,
        "products of strain and elastic energy"
    );
}


void barVibrates(verification::Checks& checks)
{
    using namespace verification;

    const double length = 25, cells = 50, v0 = 0.1;
    mpm::Settings settings;
    settings.cellSize = length/cells;
    settings.energyAccount = true;

    mpm::PointData points = seed
    (
        2,
        settings.cellSize,
        2,
        {{0, 0, 0}},
        {{length, settings.cellSize, 0}},
        [](const mpm::Point3&) { return true; },
        1
    );
    for (const mpm::Point3& x : points.position)
    {
        points.velocity.push_back
        (
            {{v0*std::sin(0.5*std::acos(-1.0)*x[0]/length), 0, 0}}
        );
    }
    mpm::Material bar;
    bar.constitutiveModel = "linearElastic";
    bar.E = 100;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {bar},
        {plane("end", "roller", {{0, 0, 0}}, {{1, 0, 0}})}
    );
    const mpm::Diagnostics before = run->diagnostics();
    run->advance(20);
    const mpm::Diagnostics d = run->diagnostics();
    reportAll(checks, d);
    const double all = before.kineticEnergy + before.affineKineticEnergy;
    checks.less
    (
        "bar: lost in yielding and to friction, relative to all energy",
        (std::fabs(d.plasticEnergy) + std::fabs(d.frictionEnergy))/all,
        1e-12,
        "nothing yields, nothing rubs"
    );
    checks.less
    (
        "bar: remainder relative to all energy",
        d.energyRemainder/all,
        closes,
        "products of strain and elastic energy"
    );
}


//- Column of 1 m by 1 m; remainder over what was lost
double columnCollapses
(
    verification::Checks& checks,
    const std::string& transferScheme,
    const std::string& antiLocking,
    const std::string& symmetry
)
{
    using namespace verification;

    mpm::Settings settings;
    settings.cellSize = 0.05;
    settings.gravity = {{0, -gravity, 0}};
    settings.transferScheme = transferScheme;
    settings.antiLocking = antiLocking;
    settings.symmetry = symmetry;
    settings.energyAccount = true;

    mpm::PointData points = seed
    (
        2,
        settings.cellSize,
        2,
        {{0, 0, 0}},
        {{1, 1, 0}},
        [](const mpm::Point3&) { return true; },
        2000
    );
    points.cohesionIntercept.assign(points.size(), 0);
    points.frictionAngle.assign(points.size(), 30);
    mpm::Material sand;
    sand.E = 1e6;
    sand.nu = 0.3;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {sand},
        {
            plane("floor", "rough", {{0, 0, 0}}, {{0, 1, 0}}),
            plane("side", "roller", {{0, 0, 0}}, {{1, 0, 0}})
        }
    );
    run->advance(1.5);
    const mpm::Diagnostics d = run->diagnostics();
    checks.report
    (
        "column, " + transferScheme + ", antiLocking " + antiLocking
      + ", symmetry " + symmetry + ": all lost [J]",
        d.lostEnergy()
    );
    reportAll(checks, d);
    return d.energyRemainder/d.lostEnergy();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::energyAccount(Checks& checks, const bool)
{
    blockSlides(checks);
    barVibrates(checks);

    // All that a transfer does to the energy is in the account: FLIP's own
    // velocities, XPIC's, a rough floor that they come back to
    for (const char* transferScheme : {"APIC", "AFLIP", "FLIP", "XPIC"})
    {
        checks.less
        (
            std::string("column, ") + transferScheme
          + ": remainder over what was lost",
            columnCollapses(checks, transferScheme, "none", "none"),
            closes,
            "products of strain and elastic energy"
        );
    }
    checks.less
    (
        "column, axisymmetric: remainder over what was lost",
        columnCollapses(checks, "APIC", "none", "axisymmetric"),
        closes,
        "the hoop stress works too"
    );
    checks.less
    (
        "column, antiLocking node: remainder over what was lost",
        columnCollapses(checks, "APIC", "node", "none"),
        0.01,
        "and the power of the stress over what the average changes"
    );
}

// ************************************************************************* //
