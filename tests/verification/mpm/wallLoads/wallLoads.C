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
    The load on obstacles against what mechanics says of it, in a section and
    in space: dead weight, a stream that is stopped, friction of a block, and
    the account of momentum.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double rho = 2000;

//- A wall whose load is recorded
mpm::WallSettings recorded(mpm::WallSettings wall)
{
    wall.recordsLoad = true;
    return wall;
}


mpm::WallSettings box
(
    const std::string& name,
    const mpm::Point3& lower,
    const mpm::Point3& upper,
    const double friction = 0
)
{
    mpm::WallSettings wall;
    wall.name = name;
    wall.type = "box";
    wall.condition = "coulomb";
    wall.friction = friction;
    wall.lower = lower;
    wall.upper = upper;
    return recorded(wall);
}


mpm::Settings settings(const int dimension, const double cellSize)
{
    mpm::Settings s;
    s.cellSize = cellSize;
    s.gravity[dimension - 1] = -verification::gravity;
    return s;
}


mpm::PointData filled
(
    const int dimension,
    const double cellSize,
    const mpm::Point3& lower,
    const mpm::Point3& upper
)
{
    return verification::seed
    (
        dimension, cellSize, 2, lower, upper,
        [](const mpm::Point3&) { return true; }, rho
    );
}


mpm::Material elastic(const double E)
{
    mpm::Material material;
    material.name = "elastic";
    material.constitutiveModel = "linearElastic";
    material.E = E;
    material.nu = 0.2;
    return material;
}


//- Mean force since an earlier load
double meanForce
(
    const mpm::WallLoad& now,
    const mpm::WallLoad& before,
    const int component,
    const double time
)
{
    return (now.impulse[component] - before.impulse[component])/time;
}


//- A block that rests on a box whose top cuts through the cells
void deadWeight(verification::Checks& checks, const int dimension)
{
    const double h = 0.125, top = 0.3;
    const bool space = dimension == 3;
    mpm::PointData points = filled
    (
        dimension,
        h,
        {{0, 0, 0}},
        space ? mpm::Point3{{1, 0.5, 0.5}} : mpm::Point3{{1, 0.5, 0}}
    );
    for (mpm::Point3& x : points.position)
    {
        x[dimension - 1] += top;
    }
    auto run = mpm::Run::New
    (
        dimension,
        settings(dimension, h),
        points,
        {elastic(1e6)},
        {
            space
          ? box("plinth", {{-1, -1, -1}}, {{2, 2, top}}, 0.5)
          : box("plinth", {{-1, -1, 0}}, {{2, top, 0}}, 0.5)
        }
    );
    mpm::StartSettings start;
    start.type = "elasticGravity";
    start.elasticTime = 1;
    start.relaxationTime = 0;
    run->establishStart(start);

    const double time = 0.5;
    run->advance(time);
    const double weight = run->diagnostics().mass*verification::gravity;
    const mpm::WallLoad& load = run->wallLoads()[0];
    const std::string name =
        space ? "in space: " : "in a section: ";
    checks.less
    (
        name + "dead weight on a box, relative error of the mean force",
        load.impulse[dimension - 1]/(-weight*time) - 1,
        1e-2,
        "what the kinetic relaxation leaves of a swing, over half a second"
    );
    checks.less
    (
        name + "force along the box, share of the weight",
        load.impulse[0]/(weight*time),
        1e-6,
        "symmetry"
    );
}


//- A stream of soil without stiffness that a box stops: the force is the flux
//  of momentum
void stream(verification::Checks& checks, const int dimension)
{
    const double h = 0.125, speed = 4, length = 4, side = 0.5;
    const bool space = dimension == 3;
    mpm::PointData points = filled
    (
        dimension, h, {{-length, 0, 0}}, {{0, side, space ? side : 0}}
    );
    points.velocity.assign(points.size(), {{speed, 0, 0}});

    mpm::Settings s = settings(dimension, h);
    s.gravity = {{0, 0, 0}};
    s.maxDeltaT = 5e-3;
    auto run = mpm::Run::New
    (
        dimension,
        s,
        points,
        {elastic(1)},
        {box("stop", {{0.3, -2, -2}}, {{1.3, 2, 2}})}
    );

    const double area = space ? side*side : side;
    const double flux = rho*area*speed*speed;
    const std::string name = space ? "in space: " : "in a section: ";
    run->advance(0.3);
    const mpm::WallLoad before = run->wallLoads()[0];
    run->advance(0.8);
    checks.less
    (
        name + "stopped stream, mean force over rho A v^2 - 1",
        meanForce(run->wallLoads()[0], before, 0, 0.5)/flux - 1,
        1e-2,
        "a row of points more or less in 2 m of the stream is 3 %, of which "
        "the nodes' reach smooths the most; no stiffness, no rebound"
    );
    run->advance(1.5);
    const mpm::Diagnostics d = run->diagnostics();
    checks.less
    (
        name + "impulse of the whole stream over its momentum - 1",
        run->wallLoads()[0].impulse[0]/(d.mass*speed) - 1,
        1e-2,
        "what still creeps towards the box: points share nodes with those "
        "that have stopped"
    );
}


//- Momentum = weight x time - loads, for soil that falls between walls of all
//  kinds
void account
(
    verification::Checks& checks,
    const int dimension,
    const std::string& shape,
    const std::string& transfer,
    const std::string& update
)
{
    const double h = 0.125;
    const bool space = dimension == 3;
    mpm::Settings s = settings(dimension, h);
    s.shapeFunction = shape;
    s.transferScheme = transfer;
    s.stressUpdate = update;

    // It scatters once more each step, which no load may notice
    s.energyAccount = !space && update == "USL";

    mpm::PointData points = filled
    (
        dimension, h, {{0, 0, 0}}, {{1, 1, space ? 1.0 : 0}}
    );
    points.cohesionIntercept.assign(points.size(), 0);
    points.frictionAngle.assign(points.size(), 30);
    for (mpm::Point3& x : points.position)
    {
        x[dimension - 1] += 0.05;
    }
    mpm::Material sand = elastic(1e6);
    sand.constitutiveModel = "MohrCoulomb";

    mpm::WallSettings base = recorded
    (
        verification::plane
        (
            "base", "rough", {{0, 0, 0}},
            space ? mpm::Point3{{0, 0, 1}} : mpm::Point3{{0, 1, 0}}
        )
    );
    mpm::WallSettings back = recorded
    (
        verification::plane("back", "roller", {{0, 0, 0}}, {{1, 0, 0}})
    );
    mpm::WallSettings front = recorded
    (
        verification::plane
        (
            "front", "coulomb", {{1.9, 0, 0}}, {{-0.9, 0.1, 0}}, 0.4
        )
    );
    front.adhesion = 500;

    auto run = mpm::Run::New
    (
        dimension,
        s,
        points,
        {sand},
        {
            base, back, front,
            space
          ? box("barrier", {{1.3, -1, -1}}, {{1.6, 2, 0.4}}, 0.3)
          : box("barrier", {{1.3, -1, 0}}, {{1.6, 0.4, 0}}, 0.3)
        }
    );
    const double time = space ? 0.5 : 1;
    run->advance(time);

    const mpm::Diagnostics d = run->diagnostics();
    const double weight = d.mass*verification::gravity*time;
    mpm::Point3 left = d.momentum;
    left[dimension - 1] += weight;
    double smallest = weight;
    for (const mpm::WallLoad& load : run->wallLoads())
    {
        double square = 0;
        for (int c = 0; c < dimension; ++c)
        {
            left[c] += load.impulse[c];
            square += load.impulse[c]*load.impulse[c];
        }
        if (load.wall != "front")
        {
            smallest = std::min(smallest, std::sqrt(square));
        }
    }
    const std::string name =
        std::string(space ? "in space" : "in a section") + ", " + shape + " "
      + transfer + " " + update + ": ";
    checks.less
    (
        name + "momentum that is not accounted for, over weight x time",
        std::sqrt(left[0]*left[0] + left[1]*left[1] + left[2]*left[2])/weight,
        1e-12,
        "round-off of some thousand steps"
    );
    checks.within
    (
        name + "least load on base, back and barrier, over weight x time",
        smallest/weight,
        1e-4,
        1,
        "all of them have been met"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::wallLoads(Checks& checks, const bool longVersion)
{
    for (const int dimension : {2, 3})
    {
        deadWeight(checks, dimension);
        stream(checks, dimension);
        account(checks, dimension, "quadraticBSpline", "APIC", "USL");
    }
    account(checks, 2, "uGIMP", "FLIP", "USF");
    account(checks, 2, "cubicBSpline", "TPIC", "MUSL");
    account(checks, 2, "quadraticBSpline", "AFLIP", "USL");
    if (longVersion)
    {
        account(checks, 3, "uGIMP", "FLIP", "USF");
        account(checks, 2, "linear", "FLIP", "MUSL");
        account(checks, 2, "cpGIMP", "PIC", "USL");
    }
}

// ************************************************************************* //
