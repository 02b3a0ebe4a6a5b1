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

#include "surfaceWaterTable.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterTables
{
    defineTypeNameAndDebug(surfaceWaterTable, 0);
    addToRunTimeSelectionTable(waterTable, surfaceWaterTable, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterTables::surfaceWaterTable::surfaceWaterTable
(
    const dictionary& dict,
    const polyMesh& mesh,
    const vector& up
)
:
    waterTable(),
    surface_()
{
    checkKeys(dict, {"type", "file"}, {"FoamFile"});

    const fileName file
    (
        mesh.time().globalPath()/mesh.time().constant()/"triSurface"
       /dict.get<fileName>("file")
    );

    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': there is no file " << file << nl
            << exit(FatalIOError);
    }

    surface_.reset(new planSurface(file, triSurface(file), up));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::waterTables::surfaceWaterTable::elevation
(
    const UList<point>& points
) const
{
    return surface_->elevation(points);
}

// ************************************************************************* //
