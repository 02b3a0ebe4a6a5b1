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
    The slope of Zhu2022 section 4 as reconstructed in tutorials/
    validationSlope, without any water solver: hydrostatic water with its

Description
    Columns that lose most of their strength while they run out: how far must
    not depend on the cells when the softening has a length of the soil
    (nonlocal), and is shown to depend on them when it has a length that knows
    bands of one cell alone (crackBand) or none.

    The clay is undrained (Tresca, associated flow), the sand frictional
    without dilation. Both glide on a base that has the residual strength, as
    slip along a rough base goes through a layer of cells that changes with
    them whether the soil softens or not. Long version: the sand on a rough
    base too, with the default transfer.

    There is no exact answer, so the changes under refinement are tested. The
    front of the clay is not: it comes farther by 2 to 4 % with each.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <algorithm>
#include <array>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace verification
{
namespace
{

//- A square column between a smooth back and a free front
struct Column
{
    double side, coarsestCell, endTime;

    //- Peak and residual strength [Pa], [degrees]
    double cohesion, phi, residualCohesion, residualPhi;

    //- Plastic strain that takes the strength, over a length [m]
    double residualStrain, length;

    std::string transferScheme;
    bool roughBase;
};

const Column clay{2, 0.2, 4, 5e3, 0, 1e3, 0, 2, 0.8, "APIC", false};
const Column sand{1, 0.1, 2, 1500, 25, 100, 20, 0.3, 0.35, "AFLIP", false};
const Column sandOnRoughBase
{
    1, 0.1, 2, 1500, 25, 100, 20, 0.3, 0.35, "APIC", true
};


//- Way of the points, mean and exceeded by 1 %, and where 99 % of them have
//  not come to [m]
struct Runout
{
    double mean, far, front;
};


//- Value that is exceeded by 1 %
double upperPercentile(std::vector<double> values)
{
    const auto at = values.begin() + values.size()*99/100;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}


//- Regularisation: none (no softening), noLength (a length of one cell), or one
//  of the engine's
Runout runout
(
    const Column& column,
    const double cellSize,
    const std::string& regularisation
)
{
    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity = {{0, -gravity, 0}};
    settings.transferScheme = column.transferScheme;

    mpm::PointData points = seed
    (
        2, cellSize, 2, {{0, 0, 0}}, {{column.side, column.side, 0}},
        [](const mpm::Point3&) { return true; },
        1600
    );
    points.frictionAngle.assign(points.size(), column.phi);
    points.cohesionIntercept.assign(points.size(), column.cohesion);

    mpm::Material soil;
    soil.E = 2e6;
    soil.nu = 0.3;
    if (regularisation != "none")
    {
        soil.softening.residualCohesion = column.residualCohesion;
        soil.softening.residualFrictionAngle = column.residualPhi;
        soil.softening.residualStrain = column.residualStrain;
        soil.softening.length = column.length;
        if (regularisation == "noLength")
        {
            soil.softening.length = cellSize;
            soil.softening.regularisation = "crackBand";
        }
        else
        {
            soil.softening.regularisation = regularisation;
        }
    }

    mpm::WallSettings base = plane
    (
        "base", column.roughBase ? "rough" : "coulomb",
        {{0, 0, 0}}, {{0, 1, 0}}, std::tan(degree*column.residualPhi)
    );
    base.adhesion = column.roughBase ? 0 : column.residualCohesion;
    auto run = mpm::Run::New
    (
        2, settings, points, {soil},
        {base, plane("back", "slip", {{0, 0, 0}}, {{1, 0, 0}})}
    );

    mpm::StartSettings start;
    start.relaxationTime = 2;
    start.restVelocity = 1e-4;
    start.stableCohesionIntercept.assign(points.size(), 20e3);
    start.stableFrictionAngle.assign(points.size(), 25);
    run->establishStart(start);
    run->advance(column.endTime);

    const std::vector<double> position = run->field("position");
    const std::vector<double> displacement = run->field("displacement");
    std::vector<double> x, ways;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        x.push_back(position[3*i]);
        ways.push_back(std::hypot(displacement[3*i], displacement[3*i + 1]));
        sum += ways.back();
    }
    return {sum/points.size(), upperPercentile(ways), upperPercentile(x)};
}


//- With cells of the coarsest size, half and a quarter of it
std::array<Runout, 3> refine
(
    Checks& checks,
    const std::string& name,
    const Column& column,
    const std::string& regularisation
)
{
    std::array<Runout, 3> runs;
    double cellSize = column.coarsestCell;
    for (Runout& one : runs)
    {
        one = runout(column, cellSize, regularisation);
        const std::string label =
            name + ", " + regularisation + ", cells of "
          + std::to_string(int(std::lround(1000*cellSize))) + " mm: ";
        checks.report(label + "mean way [m]", one.mean);
        checks.report(label + "way exceeded by 1 % [m]", one.far);
        checks.report(label + "front of 99 % [m]", one.front);
        cellSize /= 2;
    }
    return runs;
}


//- Change of the mean in the second refinement over that in the first
double ratioOfChanges(const std::array<Runout, 3>& runs)
{
    return
        (runs[2].mean - runs[1].mean)/(runs[1].mean - runs[0].mean);
}


void checkConverges
(
    Checks& checks,
    const std::string& name,
    const std::array<Runout, 3>& runs,
    const double change
)
{
    checks.less
    (
        name + ": change of the mean way, finer over coarser refinement",
        ratioOfChanges(runs),
        0.6,
        "0.5 is first order"
    );
    checks.less
    (
        name + ": last change of the mean way, relative",
        runs[2].mean/runs[1].mean - 1, change, "what the finest cells leave"
    );
}


void checkFrontConverges
(
    Checks& checks,
    const std::string& name,
    const std::array<Runout, 3>& runs,
    const double change
)
{
    const std::string reason("what the finest cells leave");
    checks.less
    (
        name + ": last change of the way exceeded by 1 %, relative",
        runs[2].far/runs[1].far - 1, change, reason
    );
    checks.less
    (
        name + ": last change of the front, relative",
        runs[2].front/runs[1].front - 1, change, reason
    );
}

} // End anonymous namespace
} // End namespace verification


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void verification::softeningRunout(Checks& checks, const bool longVersion)
{
    const auto firm = refine(checks, "clay", clay, "none");
    const auto nonlocal = refine(checks, "clay", clay, "nonlocal");
    const auto crackBand = refine(checks, "clay", clay, "crackBand");
    const auto noLength = refine(checks, "clay", clay, "noLength");

    // How much of the coarse cells' gain in the way the finest have
    const auto kept = [&firm](const std::array<Runout, 3>& soft)
    {
        return
            (soft[2].mean - firm[2].mean)/(soft[0].mean - firm[0].mean);
    };
    checkConverges(checks, "clay, nonlocal", nonlocal, 0.02);
    checks.within
    (
        "clay, nonlocal: gain by softening, cells of 50 over 200 mm",
        kept(nonlocal),
        0.9,
        1.1,
        "the softening stays the same"
    );
    checks.within
    (
        "clay, crackBand: gain by softening, cells of 50 over 200 mm",
        kept(crackBand),
        0,
        0.5,
        "shown failing: the soil yields all over, in no band of cells"
    );
    checks.within
    (
        "clay, no length: change of the mean way, finer over coarser",
        ratioOfChanges(noLength),
        0.9,
        10,
        "shown failing: it goes the farther the smaller the cells"
    );

    const auto sandy = refine(checks, "sand", sand, "nonlocal");
    checkConverges(checks, "sand, nonlocal", sandy, 0.03);
    checkFrontConverges(checks, "sand, nonlocal", sandy, 0.03);
    if (longVersion)
    {
        const std::string name("sand on a rough base");
        checkConverges
        (
            checks,
            name + ", nonlocal",
            refine(checks, name, sandOnRoughBase, "nonlocal"),
            0.1
        );
    }
}

// ************************************************************************* //
