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
    An elastic block on a plane of 30 degrees with Coulomb friction. Sliding
    (mu = 0.1): the acceleration is g (sin - mu cos). Sticking (mu = 0.6 >
    tan 30): it stays where it came to rest.

    The plane lies on the grid, with inclined gravity, or cuts through the
    cells, with vertical gravity.

    A single grain on a plane across the cells, of which the nodes know little:
    Coulomb friction brakes it by just mu, a rough wall stops it. Grains and a
    layer of them at rest a quarter of a cell above a rough plane: the nodes
    behind it brake their fall, and they stay where they touch the plane.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double slope = 30*verification::degree;

//- Of the grain: angle of its plane, cell [m], speed [m/s]
const double mild = 8*verification::degree;
const double grainCell = 0.2;
const double grainSpeed = 5;
const double width = 2, height = 1, rho = 2000;

//- Directions down the plane and out of it
struct Frame
{
    mpm::Point3 down, out;
};


std::unique_ptr<mpm::Run> block
(
    const bool inclined,
    const double mu,
    const double cellSize
)
{
    const double g = verification::gravity;
    const double s = std::sin(slope), c = std::cos(slope);
    const Frame frame =
        inclined
      ? Frame{{{c, -s, 0}}, {{s, c, 0}}}
      : Frame{{{1, 0, 0}}, {{0, 1, 0}}};

    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity =
        inclined ? mpm::Point3{{0, -g, 0}} : mpm::Point3{{g*s, -g*c, 0}};

    mpm::PointData points = verification::seed
    (
        2,
        cellSize,
        2,
        {{0, 0, 0}},
        {{width, height, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );

    // Turned onto the plane, with the normal stress of its weight
    for (mpm::Point3& x : points.position)
    {
        const double along = x[0], above = x[1];
        for (int d = 0; d < 3; ++d)
        {
            x[d] = along*frame.down[d] + above*frame.out[d];
        }
        const double normal = -rho*g*c*(height - above);
        const mpm::Point3& n = frame.out;
        points.sigma.push_back
        (
            {{
                normal*n[0]*n[0], normal*n[1]*n[1], 0,
                normal*n[0]*n[1], 0, 0
            }}
        );
    }

    mpm::Material stiff;
    stiff.constitutiveModel = "linearElastic";
    stiff.E = 10e6;

    return mpm::Run::New
    (
        2,
        settings,
        points,
        {stiff},
        {
            verification::plane
            (
                "incline", "coulomb", {{0, 0, 0}}, frame.out, mu
            )
        }
    );
}


//- Mean displacement
double moved(const mpm::Run& run)
{
    const std::vector<double> u = run.field("displacement");
    double x = 0, y = 0;
    for (std::size_t i = 0; i < run.nPoints(); ++i)
    {
        x += u[3*i];
        y += u[3*i + 1];
    }
    return std::hypot(x, y)/run.nPoints();
}


//- A grain, one point, or a row of them every half a cell, that moves down a
//  plane of 8 degrees across the cells with this speed at first; so far from
//  the plane and along it [m]
std::unique_ptr<mpm::Run> grains
(
    const std::string& transfer,
    const std::string& condition,
    const double mu,
    const double away,
    const double along,
    const double speed,
    const int n
)
{
    const double s = std::sin(mild), c = std::cos(mild);

    mpm::Settings settings;
    settings.cellSize = grainCell;
    settings.gravity = {{0, -verification::gravity, 0}};
    settings.transferScheme = transfer;

    mpm::PointData points;
    for (int i = 0; i < n; ++i)
    {
        const double x = along + 0.5*i*grainCell;
        points.position.push_back({{x*c + away*s, away*c - x*s, 0}});
        points.volume.push_back(0.25*grainCell*grainCell);
        points.rho.push_back(rho);
        points.zone.push_back(0);
        points.velocity.push_back({{speed*c, -speed*s, 0}});
    }

    // One grain is elastic, a row of them is sand
    mpm::Material material;
    material.E = 2e6;
    if (n == 1)
    {
        material.constitutiveModel = "linearElastic";
    }
    else
    {
        points.frictionAngle.assign(n, 30);
        points.cohesionIntercept.assign(n, 0);
    }

    return mpm::Run::New
    (
        2,
        settings,
        points,
        {material},
        {verification::plane("plane", condition, {{0, 0, 0}}, {{s, c, 0}}, mu)}
    );
}


//- Mean way of the points between two times
double meanWay
(
    const std::vector<double>& before,
    const std::vector<double>& after
)
{
    double sum = 0;
    for (std::size_t i = 0; i < before.size(); i += 3)
    {
        sum += std::hypot(after[i] - before[i], after[i + 1] - before[i + 1]);
    }
    return 3*sum/before.size();
}


//- Grains a quarter of a cell above a rough plane, by so many at so many places
//  along it: their mean way until they touch it, and in as much time after
void sinkOntoRoughPlane
(
    verification::Checks& checks,
    const std::string& transfer,
    const int n,
    const double most,
    const double mostLater,
    const std::string& reason
)
{
    const double time = 30;
    double way = 0, later = 0;
    for (const double along : {0.0, 0.1, 0.35, 0.6, 0.85})
    {
        auto run = grains
        (
            transfer,
            "rough",
            0,
            0.25*grainCell,
            along*grainCell,
            0,
            n
        );
        run->advance(time);
        const std::vector<double> u = run->field("displacement");
        run->advance(2*time);
        way = std::fmax(way, meanWay(std::vector<double>(u.size(), 0), u));
        later = std::fmax(later, meanWay(u, run->field("displacement")));
    }
    const std::string name =
        (n == 1 ? "one grain" : "a layer of a grain")
      + std::string(" a quarter of a cell above a rough plane, ") + transfer;
    checks.less
    (
        name + ": its way in 30 s over the cell", way/grainCell, most, reason
    );
    checks.less
    (
        name + ": its way in the next 30 s over the cell",
        later/grainCell,
        mostLater,
        "the wall takes the part of a step that would be behind it"
    );
}


//- Mean velocity
double speed(const mpm::Run& run)
{
    const mpm::Diagnostics d = run.diagnostics();
    return std::hypot(d.momentum[0], d.momentum[1])/d.mass;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::blockOnIncline(Checks& checks, const bool)
{
    for (const std::string transfer : {"APIC", "TPIC", "AFLIP", "FLIP"})
    {
        const double mu = 0.4, away = 0.25*grainCell, time = 0.5;
        auto run =
            grains(transfer, "coulomb", mu, away, away, grainSpeed, 1);
        run->advance(time);
        const double exact =
            grainSpeed
          - gravity*(mu*std::cos(mild) - std::sin(mild))*time;
        checks.less
        (
            "one grain, " + transfer + ": relative error of its speed",
            speed(*run)/exact - 1,
            2e-3,
            "friction of nodes and of the wall that puts it back; it falls a "
            "quarter of a cell at first"
        );
    }

    for (const std::string& transfer : mpm::Settings::transferSchemes())
    {
        double still = 0, way = 0;
        for (const double along : {0.0, 0.1, 0.35, 0.6, 0.85})
        {
            auto run = grains
            (
                transfer,
                "rough",
                0,
                1e-3*grainCell,
                along*grainCell,
                grainSpeed,
                1
            );
            run->advance(1);
            still = std::fmax(still, speed(*run));
            way = std::fmax(way, moved(*run));
        }
        const std::string name = "one grain, rough plane, " + transfer + ": ";
        checks.less
        (
            name + "its speed after a second [m/s]",
            still,
            1e-12,
            "whatever the nodes leave it, the wall that puts it back takes"
        );
        checks.less
        (
            name + "its way over the cell",
            way/grainCell,
            0.08,
            "a few steps at 5 m/s"
        );
        sinkOntoRoughPlane
        (
            checks,
            transfer,
            1,
            0.5,
            1e-12,
            "a quarter of a cell across the plane, and along it as much: what "
            "nodes leave of a step's fall has any direction"
        );
    }
    sinkOntoRoughPlane
    (
        checks, "APIC", 20, 0.5, 0.05, "as one; neighbours hold a few"
    );

    const double cellSize = 0.125;
    for (const bool inclined : {false, true})
    {
        const std::string name =
            inclined ? "plane across the cells: " : "plane on the grid: ";

        const double mu = 0.1;
        const double exact =
            gravity*(std::sin(slope) - mu*std::cos(slope));
        auto sliding = block(inclined, mu, cellSize);
        sliding->advance(1);
        const double speed1 = speed(*sliding);
        checks.less
        (
            name + "relative error of the way slid in 1 s",
            moved(*sliding)/(0.5*exact) - 1,
            5e-3,
            "coming to bear on the nodes gives a kick of 1 to 3 mm/s, and "
            "symplectic steps lead by half a step"
        );
        sliding->advance(2);
        checks.less
        (
            name + "relative error of the acceleration in the next second",
            (speed(*sliding) - speed1)/exact - 1,
            2e-4,
            "friction takes exactly mu times the normal impulse; the weight "
            "swings a little on the elastic block"
        );

        auto sticking = block(inclined, 0.6, cellSize);
        mpm::StartSettings start;
        start.type = "elasticGravity";
        start.elasticTime = 3;
        start.relaxationTime = 0;
        sticking->establishStart(start);
        sticking->advance(2);
        const double settled = moved(*sticking);
        sticking->advance(4);
        checks.less
        (
            name + "way of the sticking block from 2 to 4 s [m]",
            moved(*sticking) - settled,
            1e-6,
            "what the kinetic relaxation leaves of elastic waves"
        );
        checks.less
        (
            name + "way of the sticking block in the 2 s before [m]",
            settled,
            1e-4,
            "nodes that only just bear give way once; 1 % of the elastic "
            "settlement"
        );
    }
}

// ************************************************************************* //
