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

#include "terrainSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "labelVector.H"
#include "readChecked.H"
#include "slidePoints.H"
#include "wallSurface.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(terrainSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, terrainSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::terrainSlideWall::terrainSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::terrainSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh*
) const
{
    checkWallKeys({"vertices", "triangles", "file", "scale"});

    mpm::WallSettings wall(settings("terrain"));

    const slideFrame& frame = points.frame();

    if (dict().found("file"))
    {
        const scalar scale = readCheckedOrDefault
        (
            dict(),
            "scale",
            1,
            [](const scalar x){ return x > 0 && x <= 1e6; },
            "> 0 m, up to 1e6"
        );

        wallSurface(dict(), caseFile("file"), scale).fillTerrain(wall, frame);
        walls.push_back(wall);
        return;
    }

    const pointField vertices(frame.readPoints(dict(), "vertices"));

    for (const point& p : vertices)
    {
        wall.vertices.push_back(toMpm(p));
    }

    if (frame.dimension() == 3)
    {
        const List<labelVector> triangles
        (
            dict().get<List<labelVector>>("triangles")
        );

        for (const labelVector& t : triangles)
        {
            wall.triangles.push_back({{int(t[0]), int(t[1]), int(t[2])}});
        }
    }

    walls.push_back(wall);
}

// ************************************************************************* //
