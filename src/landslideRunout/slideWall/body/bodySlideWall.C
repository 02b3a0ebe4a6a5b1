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

#include "bodySlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "bodyDistance.H"
#include "readChecked.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(bodySlideWall, 0);
    addToRunTimeSelectionTable(slideWall, bodySlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::bodySlideWall::bodySlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::bodySlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh*
) const
{
    checkWallKeys({"file", "scale"});

    const scalar scale = readCheckedOrDefault
    (
        dict(),
        "scale",
        1,
        [](const scalar x){ return x > 0 && x <= 1e6; },
        "> 0 m, up to 1e6"
    );
    const bodyDistance distance
    (
        std::make_shared<wallSurface>(dict(), caseFile("file"), scale),
        points.frame()
    );

    mpm::WallSettings wall(settings("levelSet", true));
    wall.lower = toMpm(distance.bounds().min());
    wall.upper = toMpm(distance.bounds().max());
    wall.spacing = 0.5*points.cellSize();
    wall.signedDistance = distance;

    // What tells this body from others
    distance.fill(wall);

    refusePointsInside(points, wall.signedDistance);
    checkThickness(points, distance.bounds().span());

    walls.push_back(wall);
}

// ************************************************************************* //
