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
    A soft column settles under its own weight between rollers. Whatever the
    strain, the vertical Cauchy stress of a piece of soil is the weight that
    was above it from the start: rho0 g (l0 - Y) (T.J. Charlton, W.M. Coombs,
    C.E. Augarde 2017).

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct StressError
{
    //- Mean error of the vertical stress over the stress at the base: of all
    //  points, of those more than four cells from the base
    double all, inside;

    //- Largest error, at the base
    double largest;
};


StressError stressError(const int cells)
{
    const double height = 50, rho = 80, E = 10e3;

    // Half of E at the base: a logarithmic strain of -0.5
    const double g = 0.5*E/(rho*height);

    mpm::Settings settings;
    settings.cellSize = height/cells;
    settings.gravity = {{0, -g, 0}};

    const double width = 2*settings.cellSize;
    const mpm::PointData points = verification::seed
    (
        2,
        settings.cellSize,
        2,
        {{0, 0, 0}},
        {{width, height, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );

    mpm::Material soft;
    soft.constitutiveModel = "linearElastic";
    soft.E = E;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {soft},
        {
            verification::plane("base", "rough", {{0, 0, 0}}, {{0, 1, 0}}),
            verification::plane("left", "roller", {{0, 0, 0}}, {{1, 0, 0}}),
            verification::plane
            (
                "right", "roller", {{width, 0, 0}}, {{-1, 0, 0}}
            )
        }
    );

    // Natural period 4 l/c = 18 s; kinetic relaxation needs some of them
    mpm::StartSettings start;
    start.type = "elasticGravity";
    start.elasticTime = 150;
    start.relaxationTime = 0;
    run->establishStart(start);

    const std::vector<double> sigma = run->field("sigma");
    StressError sum{0, 0, 0};
    long n = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double Y = points.position[i][1];
        const double error =
            std::fabs(sigma[6*i + 1]/(rho*g*height) + 1 - Y/height);
        sum.all += error;
        sum.largest = std::fmax(sum.largest, error);
        if (Y > 4*settings.cellSize)
        {
            sum.inside += error;
            ++n;
        }
    }
    return {sum.all/points.size(), sum.inside/n, sum.largest};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::selfWeightColumn(Checks& checks, const bool longVersion)
{
    StressError last{0, 0, 0};
    for (const int cells : {16, 32, 64, 128})
    {
        if (cells == 128 && !longVersion)
        {
            break;
        }
        const StressError error = stressError(cells);
        const std::string name = std::to_string(cells) + " cells: ";
        checks.report(name + "mean error of the stress", error.all);
        checks.report(name + "mean error off the base", error.inside);
        checks.report(name + "largest error, next to the base", error.largest);
        // Finer, the points' uneven places in the cells rule: about 1.3e-3 of
        // the base's stress whatever the cell size
        if (cells == 32 || cells == 64)
        {
            checks.within
            (
                name + "order of the mean error",
                order(last.all, error.all),
                cells == 32 ? 0.9 : 0.4,
                3,
                "first order and falling: the points' uneven places in cells "
                "that are compressed by up to 40 % end it at 1.3e-3"
            );
        }
        last = error;
    }
    checks.less
    (
        "mean error of the stress at the finest",
        last.all,
        2e-3,
        "the wall mirrors the soil in front of it, so the base is no worse "
        "than the rest"
    );
    checks.less
    (
        "mean error off the base at the finest",
        last.inside,
        2e-3,
        "points lie unevenly in cells that are compressed by a third"
    );
}

// ************************************************************************* //
