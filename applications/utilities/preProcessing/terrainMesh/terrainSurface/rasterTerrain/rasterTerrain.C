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

#include "rasterTerrain.H"
#include "addToRunTimeSelectionTable.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace terrainSurfaces
{
    defineTypeNameAndDebug(rasterTerrain, 0);
    addToRunTimeSelectionTable(terrainSurface, rasterTerrain, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::terrainSurfaces::rasterTerrain::toCentres
(
    const scalar place,
    const scalar low,
    const scalar high
) const
{
    const scalar half = 0.5*grid_.cellSize();

    // Round-off of the mesh's coordinates
    const scalar margin = 1e-6*grid_.cellSize();

    return
        place < low - margin || place > high + margin
      ? VGREAT
      : min(max(place, low + half), high - half);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::terrainSurfaces::rasterTerrain::rawElevation
(
    const scalar x,
    const scalar y
) const
{
    const scalar xCentre = toCentres(x, grid_.west(), grid_.east());
    const scalar yCentre = toCentres(y, grid_.south(), grid_.north());

    if (xCentre == VGREAT || yCentre == VGREAT)
    {
        FatalErrorInFunction
            << "Terrain surface " << name() << ": the place (" << x << ' '
            << y << ") lies outside the elevation grid " << grid_.file()
            << ", x " << grid_.west() << " .. " << grid_.east()
            << ", y " << grid_.south() << " .. " << grid_.north()
            << exit(FatalError);
    }

    scalar z = 0;

    if (!grid_.interpolate(xCentre, yCentre, z))
    {
        FatalErrorInFunction
            << "Terrain surface " << name() << ": the elevation grid "
            << grid_.file() << " has no data at (" << x << ' ' << y
            << ") or in a cell beside it, where the mesh needs it"
            << exit(FatalError);
    }

    return z;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::terrainSurfaces::rasterTerrain::rasterTerrain
(
    const word& name,
    const dictionary& dict,
    const fileName& casePath
)
:
    terrainSurface(name, dict),
    grid_
    (
        [&]
        {
            fileName file(dict.get<fileName>("file").expand());
            return file.isAbsolute() ? file : casePath/file;
        }(),
        dict
    )
{
    checkKeys(dict, {"type", "offset", "file"});
}


// ************************************************************************* //
