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

#include "meshPatchSlideWall.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "slidePoints.H"
#include "wallSurface.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace slideWalls
{
    defineTypeNameAndDebug(meshPatchSlideWall, 0);
    addToRunTimeSelectionTable(slideWall, meshPatchSlideWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWalls::meshPatchSlideWall::meshPatchSlideWall
(
    const word& name,
    const dictionary& dict
)
:
    slideWall(name, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slideWalls::meshPatchSlideWall::append
(
    std::vector<mpm::WallSettings>& walls,
    const slidePoints& points,
    const fvMesh* meshPtr
) const
{
    checkWallKeys({"patch"});
    requireMesh(meshPtr);

    const polyBoundaryMesh& patches = meshPtr->boundaryMesh();
    const word patch(dict().get<word>("patch"));
    const label patchi = patches.findPatchID(patch);

    if (patchi == -1)
    {
        FatalIOErrorInFunction(dict())
            << "patch: the mesh has no patch " << patch << ". Valid names: "
            << flatOutput(patches.names())
            << exit(FatalIOError);
    }

    walls.push_back(settings("terrain"));
    wallSurface(dict(), patches[patchi])
        .fillTerrain(walls.back(), points.frame());
}

// ************************************************************************* //
