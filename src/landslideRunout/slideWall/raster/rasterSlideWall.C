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

\*---------------------------------------------------------------------------*/

#include "rasterSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "asciiGrid.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(rasterSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, rasterSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slideWalls::rasterSlideWall::requireCover
(
    const asciiGrid& grid,
    const vector2D& place,
    const point& p
) const
{
    scalar z;

    if (!grid.interpolate(place.x(), place.y(), z))
    {
        FatalIOErrorInFunction(dict())
            << "file: the raster " << grid.file() << " does not cover the"
            << " slide: there are no heights at " << place
            << ", where the point " << p << " lies. The middles of its cells"
            << " reach from "
            << vector2D
               (
                   grid.west() + 0.5*grid.cellSize(),
                   grid.south() + 0.5*grid.cellSize()
               )
            << " to "
            << vector2D
               (
                   grid.east() - 0.5*grid.cellSize(),
                   grid.north() - 0.5*grid.cellSize()
               )
            << " m, but for those without data"
            << exit(FatalIOError);
    }
}


void Foam::slideWalls::rasterSlideWall::fillLine
(
    mpm::WallSettings& wall,
    const asciiGrid& grid,
    const slidePoints& points
) const
{
    // The plan's axes as seen along the section
    const slideFrame& frame = points.frame();
    const vector up(frame.directionToSpace(vector(0, 1, 0)));
    const vector near(mag(up.x()) < 0.9 ? vector(1, 0, 0) : vector(0, 1, 0));
    const vector axis1(normalised(near - (near & up)*up));
    const vector axis2(up ^ axis1);

    const scalar base = frame.toSpace(point(Zero)) & up;
    const auto plan = [&](const scalar x)
    {
        const point p(frame.toSpace(point(x, 0, 0)));
        return vector2D(p & axis1, p & axis2);
    };

    scalar low = GREAT, high = -GREAT;
    for (const point& p : points.position())
    {
        requireCover(grid, plan(p.x()), p);
        low = min(low, p.x());
        high = max(high, p.x());
    }

    // From the middle of the slide to both ends of the raster
    const scalar middle = 0.5*(low + high);
    const label nMost = 2*(grid.nColumns() + grid.nRows());
    DynamicList<point> line;
    for (label i = -nMost; i <= nMost; ++i)
    {
        const scalar x = middle + i*grid.cellSize();
        const vector2D place(plan(x));
        scalar z;
        if (grid.interpolate(place.x(), place.y(), z))
        {
            line.append(point(x, z - base, 0));
        }
        else if (x < low)
        {
            line.clear();
        }
        else if (x > high)
        {
            break;
        }
    }

    for (const point& p : line)
    {
        wall.vertices.push_back(toMpm(p));
    }
}


void Foam::slideWalls::rasterSlideWall::fillSurface
(
    mpm::WallSettings& wall,
    const asciiGrid& grid,
    const slidePoints& points
) const
{
    for (const point& p : points.position())
    {
        requireCover(grid, vector2D(p.x(), p.y()), p);
    }

    labelList vertexOf(grid.nColumns()*grid.nRows(), -1);
    for (label row = 0; row < grid.nRows(); ++row)
    {
        for (label column = 0; column < grid.nColumns(); ++column)
        {
            const label celli = grid.cell(row, column);
            if (grid.hasData(celli))
            {
                vertexOf[celli] = wall.vertices.size();
                wall.vertices.push_back
                ({{
                    grid.west() + (column + 0.5)*grid.cellSize(),
                    grid.south() + (row + 0.5)*grid.cellSize(),
                    grid.value(celli)
                }});
            }
        }
    }

    const auto addTriangle = [&](const label a, const label b, const label c)
    {
        const FixedList<label, 3> t({vertexOf[a], vertexOf[b], vertexOf[c]});
        if (!t.found(-1))
        {
            wall.triangles.push_back({{int(t[0]), int(t[1]), int(t[2])}});
        }
    };

    for (label row = 0; row + 1 < grid.nRows(); ++row)
    {
        for (label column = 0; column + 1 < grid.nColumns(); ++column)
        {
            const label a = grid.cell(row, column);
            const label b = grid.cell(row + 1, column);

            addTriangle(a, a + 1, b);
            addTriangle(a + 1, b + 1, b);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::rasterSlideWall::rasterSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::rasterSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh*
) const
{
    checkWallKeys({"file"});

    const asciiGrid grid(caseFile("file"), dict());

    walls.push_back(settings("terrain"));
    mpm::WallSettings& wall = walls.back();

    if (points.frame().dimension() == 2)
    {
        fillLine(wall, grid, points);
    }
    else
    {
        fillSurface(wall, grid, points);
    }
}

// ************************************************************************* //
