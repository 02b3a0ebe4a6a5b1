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

#include "boxSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(boxSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, boxSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::boxSlideWall::boxSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::boxSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh*
) const
{
    checkWallKeys({"min", "max"});

    const slideFrame& frame = points.frame();
    const point low(frame.readPoint(dict(), "min"));
    const point high(frame.readPoint(dict(), "max"));

    for (direction cmpt = 0; cmpt < frame.dimension(); ++cmpt)
    {
        if (high[cmpt] <= low[cmpt])
        {
            FatalIOErrorInFunction(dict())
                << "max " << high << " has to be greater than min " << low
                << " in each of " << frame.dimension() << " directions"
                << exit(FatalIOError);
        }
    }

    mpm::WallSettings wall(settings("box", true));
    wall.lower = toMpm(low);
    wall.upper = toMpm(high);

    refusePointsInside
    (
        points,
        [&](const mpm::Point3& x)
        {
            double beyond = -GREAT;
            for (direction cmpt = 0; cmpt < frame.dimension(); ++cmpt)
            {
                beyond = max
                (
                    beyond,
                    max(low[cmpt] - x[cmpt], x[cmpt] - high[cmpt])
                );
            }
            return beyond;
        }
    );
    checkThickness(points, high - low);

    walls.push_back(wall);
}

// ************************************************************************* //
