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

#include "zoneTopSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "meshTerrain.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(zoneTopSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, zoneTopSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::zoneTopSlideWall::zoneTopSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::zoneTopSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh* meshPtr
) const
{
    checkWallKeys({"zones"});
    requireMesh(meshPtr);

    const wordList zones(dict().get<wordList>("zones"));
    boolList inZones(meshPtr->nCells(), false);

    for (const word& zone : zones)
    {
        const label zonei = meshPtr->cellZones().findZoneID(zone);

        if (zonei == -1)
        {
            FatalIOErrorInFunction(dict())
                << "zones: the mesh has no cell zone " << zone
                << ". Valid names: "
                << flatOutput(meshPtr->cellZones().names())
                << exit(FatalIOError);
        }

        for (const label celli : meshPtr->cellZones()[zonei])
        {
            inZones[celli] = true;
        }
    }

    const meshTerrain terrain(*meshPtr, points, inZones, meshTerrain::TOP);

    if (terrain.empty())
    {
        FatalIOErrorInFunction(dict())
            << "zones: no cell of " << flatOutput(zones)
            << " lies in the section or box of the points"
            << exit(FatalIOError);
    }

    walls.push_back(settings("terrain"));
    terrain.fill(walls.back());
}

// ************************************************************************* //
