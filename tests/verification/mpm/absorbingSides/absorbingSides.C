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
    Waves that meet the side of the soil: what of their energy comes back from
    dashpots, from a fixed side, and soil at rest between such sides.

    A pressure wave at right angles to the side leaves no reflection (J. Lysmer,
    R.L. Kuhlemeyer 1969).

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double rho = 2000, E = 1e6, nu = 0.25;

//- Lame's constants and the speed of pressure waves
const double mu = 0.5*E/(1 + nu);
const double lambda = E*nu/(1 + nu)/(1 - 2*nu);
const double speed = std::sqrt((lambda + 2*mu)/rho);


mpm::Material elastic()
{
    mpm::Material material;
    material.name = "elastic";
    material.constitutiveModel = "linearElastic";
    material.E = E;
    material.nu = nu;
    return material;
}


//- Share of the energy of a pulse that is left when it would be back: in a bar
//  whose sides are rollers, which ends in a wall on the nodes (gap 0) or
//  between them
double left
(
    const int dimension,
    const std::string& condition,
    const std::string& transfer,
    const double gap
)
{
    const double h = 0.1, length = 6, width = 0.4;
    const bool space = dimension == 3;
    mpm::Settings s;
    s.cellSize = h;
    s.transferScheme = transfer;

    mpm::PointData points = verification::seed
    (
        dimension,
        h,
        2,
        {{0, 0, 0}},
        {{length + h, width, space ? width : 0}},
        [&](const mpm::Point3& x) { return x[0] < length + gap; },
        rho
    );
    for (const mpm::Point3& x : points.position)
    {
        const double v = 0.01*std::exp(-std::pow((x[0] - 3)/0.5, 2));
        const double along = -rho*speed*v;
        const double across = lambda/(lambda + 2*mu)*along;
        points.velocity.push_back({{v, 0, 0}});
        points.sigma.push_back({{along, across, across, 0, 0, 0}});
    }

    std::vector<mpm::WallSettings> walls
    {
        verification::plane("low", "roller", {{0, 0, 0}}, {{0, 1, 0}}),
        verification::plane("high", "roller", {{0, width, 0}}, {{0, -1, 0}}),
        verification::plane
        (
            "end", condition, {{length + gap, 0, 0}}, {{-1, 0, 0}}
        )
    };
    if (space)
    {
        walls.push_back
        (
            verification::plane("front", "roller", {{0, 0, 0}}, {{0, 0, 1}})
        );
        walls.push_back
        (
            verification::plane
            (
                "back", "roller", {{0, 0, width}}, {{0, 0, -1}}
            )
        );
    }
    auto run = mpm::Run::New(dimension, s, points, {elastic()}, walls);
    const auto energy = [&]()
    {
        const mpm::Diagnostics d = run->diagnostics();
        return d.kineticEnergy + d.elasticEnergy;
    };
    const double before = energy();
    run->advance(length/speed);
    return energy()/before;
}


//- Largest movement of soil at rest between absorbing sides, and its settlement
//  on the way to rest
void atRest(verification::Checks& checks, const int dimension)
{
    const double h = 0.25, length = 3, height = 2;
    const bool space = dimension == 3;
    mpm::Settings s;
    s.cellSize = h;
    s.gravity[dimension - 1] = -verification::gravity;
    mpm::PointData points = verification::seed
    (
        dimension,
        h,
        2,
        {{0, 0, 0}},
        {{length, space ? 1 : height, space ? height : 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    mpm::Point3 up{{0, 0, 0}};
    up[dimension - 1] = 1;
    std::vector<mpm::WallSettings> walls
    {
        verification::plane("base", "rough", {{0, 0, 0}}, up),
        verification::plane("left", "absorbing", {{0, 0, 0}}, {{1, 0, 0}}),
        verification::plane
        (
            "right", "absorbing", {{length, 0, 0}}, {{-1, 0, 0}}
        )
    };
    if (space)
    {
        walls.push_back
        (
            verification::plane("front", "roller", {{0, 0, 0}}, {{0, 1, 0}})
        );
        walls.push_back
        (
            verification::plane("back", "roller", {{0, 1, 0}}, {{0, -1, 0}})
        );
    }
    auto run = mpm::Run::New(dimension, s, points, {elastic()}, walls);
    mpm::StartSettings start;
    start.type = "elasticGravity";
    start.elasticTime = 4;
    start.relaxationTime = 0;
    const double settlement = run->establishStart(start).settlement;

    // To a restart and on, which has to know what held the soil
    run->advance(0.2);
    const std::string half = verification::saved(*run);
    std::istringstream is(half);
    auto onward = mpm::Run::New(dimension, s, points, {elastic()}, walls);
    onward->restore(is);
    onward->advance(1);
    run->advance(1);
    const double moved = run->diagnostics().maxDisplacement;
    const std::string name = space ? "in space: " : "in a section: ";
    checks.less
    (
        name + "movement in 1 s at rest between absorbing sides, over the "
        "settlement before",
        moved/settlement,
        1e-3,
        "what the kinetic relaxation leaves of a swing"
    );
    checks.less
    (
        name + "the same after a restart, relative difference",
        onward->diagnostics().maxDisplacement/moved - 1,
        0,
        "a restart is exact"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::absorbingSides(Checks& checks, const bool longVersion)
{
    for (const int dimension : {2, 3})
    {
        for (const double gap : {0.0, 0.05})
        {
            if (dimension == 3 && gap > 0 && !longVersion)
            {
                continue;
            }
            const std::string name =
                std::string(dimension == 3 ? "in space" : "in a section")
              + (gap > 0 ? ", side between nodes: " : ", side on nodes: ");
            checks.less
            (
                name + "energy that dashpots send back, share",
                left(dimension, "absorbing", "APIC", gap),
                gap > 0 ? 3e-2 : 5e-3,
                "theory: none; a pulse of 5 cells' width sees that the side's "
                "area belongs to nodes up to a cell and a half behind it"
            );
            checks.within
            (
                name + "energy that a fixed side sends back, share",
                left(dimension, "roller", "APIC", gap),
                0.9,
                1.001,
                "all but what the transfer takes in 60 cells"
            );
        }
        atRest(checks, dimension);
    }
    checks.less
    (
        "FLIP: energy that dashpots send back, share",
        left(2, "absorbing", "FLIP", 0),
        5e-3,
        "as above"
    );
}

// ************************************************************************* //
