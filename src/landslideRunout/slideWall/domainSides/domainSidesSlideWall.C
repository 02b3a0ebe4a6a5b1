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

#include "domainSidesSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(domainSidesSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, domainSidesSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::domainSidesSlideWall::domainSidesSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::domainSidesSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh*
) const
{
    checkWallKeys({});

    const label dimension = points.frame().dimension();
    const scalar margin = 0.5*points.spacing();
    const FixedList<word, 6> names
    ({
        "Left", "Right", "Front", "Back", "Bottom", "Top"
    });

    vector low(vector::uniform(GREAT));
    vector high(vector::uniform(-GREAT));

    for (const point& p : points.position())
    {
        low = min(low, p);
        high = max(high, p);
    }

    // All horizontal directions
    for (direction cmpt = 0; cmpt < dimension - 1; ++cmpt)
    {
        for (label end = 0; end < 2; ++end)
        {
            mpm::WallSettings wall(settings("plane"));

            wall.name += names[2*cmpt + end];
            wall.point[cmpt] =
                (end == 0 ? low[cmpt] - margin : high[cmpt] + margin);
            wall.normal = {{0, 0, 0}};
            wall.normal[cmpt] = (end == 0 ? 1 : -1);

            walls.push_back(wall);
        }
    }
}

// ************************************************************************* //
