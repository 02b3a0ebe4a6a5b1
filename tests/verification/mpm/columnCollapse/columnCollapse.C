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
    Collapse of a cylinder of dry sand on a rough floor, in three dimensions.
    It must keep the symmetries of its lattice of points (quarter turns and
    mirrors), be the same whichever axis is the vertical one, and run out
    nearly alike along the axes and the diagonals of the grid.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <algorithm>
#include <cmath>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double radius = 1;

//- Result of one collapse in its own axes: along, across, up
struct Collapse
{
    std::vector<mpm::Point3> start, end;
};


//- Up is the given axis, in the given sense; the others follow cyclically
Collapse collapse(const int upAxis, const int sense, const double cellSize)
{
    const double height = 1.5;
    const int axis[3] = {(upAxis + 1) % 3, (upAxis + 2) % 3, upAxis};

    // Own axes to those of the grid
    const auto toGrid = [&](const mpm::Point3& own)
    {
        mpm::Point3 x;
        x[axis[0]] = own[0];
        x[axis[1]] = own[1];
        x[axis[2]] = sense*own[2];
        return x;
    };

    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.gravity = toGrid({{0, 0, -verification::gravity}});
    settings.frontDirection = toGrid({{1, 0, 0}});

    mpm::PointData points = verification::seed
    (
        3,
        cellSize,
        2,
        {{-radius, -radius, 0}},
        {{radius, radius, height}},
        [](const mpm::Point3& x) { return std::hypot(x[0], x[1]) < radius; },
        1600
    );
    Collapse result;
    result.start = points.position;
    for (mpm::Point3& x : points.position)
    {
        x = toGrid(x);
    }
    points.frictionAngle.assign(points.size(), 30);

    mpm::Material sand;
    sand.E = 1e6;
    sand.nu = 0.3;

    auto run = mpm::Run::New
    (
        3,
        settings,
        points,
        {sand},
        {
            verification::plane
            (
                "floor", "rough", {{0, 0, 0}}, toGrid({{0, 0, 1}})
            )
        }
    );
    run->advance(1.2);

    const std::vector<double> position = run->field("position");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double* x = &position[3*i];
        result.end.push_back
        (
            {{x[axis[0]], x[axis[1]], sense*x[axis[2]]}}
        );
    }
    return result;
}


//- Largest distance between a point and the image of its mirror partner
double asymmetry
(
    const Collapse& c,
    const double cellSize,
    const std::function<mpm::Point3(const mpm::Point3&)>& image
)
{
    const auto key = [cellSize](const mpm::Point3& x)
    {
        return std::array<long, 3>
        {{
            std::lround(x[0]/cellSize*4),
            std::lround(x[1]/cellSize*4),
            std::lround(x[2]/cellSize*4)
        }};
    };

    std::map<std::array<long, 3>, std::size_t> at;
    for (std::size_t i = 0; i < c.start.size(); ++i)
    {
        at[key(c.start[i])] = i;
    }

    double largest = 0;
    for (std::size_t i = 0; i < c.start.size(); ++i)
    {
        const mpm::Point3& partner = c.end[at.at(key(image(c.start[i])))];
        const mpm::Point3 expected = image(c.end[i]);
        for (int d = 0; d < 3; ++d)
        {
            largest = std::fmax(largest, std::fabs(partner[d] - expected[d]));
        }
    }
    return largest;
}


//- Radius within which 99 % of the points lie, of those whose direction is
//  within 15 degrees of an axis (quarter 0) or a diagonal (quarter 1)
double front(const Collapse& c, const int diagonal)
{
    std::vector<double> radii;
    for (const mpm::Point3& x : c.end)
    {
        const double eighths =
            std::atan2(x[1], x[0])/(45*verification::degree);
        const double off = eighths - 2*std::round(0.5*(eighths - diagonal))
          - diagonal;
        if (std::fabs(off) < 1.0/3)
        {
            radii.push_back(std::hypot(x[0], x[1]));
        }
    }
    const std::size_t rank = radii.size()*99/100;
    std::nth_element(radii.begin(), radii.begin() + rank, radii.end());
    return radii[rank];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::columnCollapse(Checks& checks, const bool longVersion)
{
    const double cellSize = longVersion ? 1.0/12 : 1.0/8;
    const std::string chaos =
        "round-off of other orders of summation, which a flow of sand "
        "multiplies";

    const Collapse up = collapse(2, 1, cellSize);

    checks.less
    (
        "quarter turn: distance of partners [m]",
        asymmetry
        (
            up,
            cellSize,
            [](const mpm::Point3& x)
            {
                return mpm::Point3{{-x[1], x[0], x[2]}};
            }
        ),
        1e-8,
        chaos
    );
    checks.less
    (
        "mirror: distance of partners [m]",
        asymmetry
        (
            up,
            cellSize,
            [](const mpm::Point3& x)
            {
                return mpm::Point3{{-x[0], x[1], x[2]}};
            }
        ),
        1e-8,
        chaos
    );

    for (const auto& other : {std::make_pair(0, 1), std::make_pair(1, -1)})
    {
        const Collapse turned = collapse(other.first, other.second, cellSize);
        double largest = 0;
        for (std::size_t i = 0; i < up.end.size(); ++i)
        {
            for (int d = 0; d < 3; ++d)
            {
                largest = std::fmax
                (
                    largest,
                    std::fabs(up.end[i][d] - turned.end[i][d])
                );
            }
        }
        checks.less
        (
            std::string("vertical along ") + (other.second > 0 ? "+" : "-")
          + "xyz"[other.first] + ": distance to that along +z [m]",
            largest,
            1e-8,
            chaos
        );
    }

    const double alongAxes = front(up, 0), alongDiagonals = front(up, 1);
    checks.report("front along the axes [m]", alongAxes);
    checks.within
    (
        "front along the axes over the initial radius",
        alongAxes/radius,
        1.3,
        3,
        "it really collapses"
    );
    checks.less
    (
        "front along the diagonals against the axes, relative",
        alongDiagonals/alongAxes - 1,
        0.05,
        "the square lattice of cells shows in the front by less than a cell"
    );
}

// ************************************************************************* //
