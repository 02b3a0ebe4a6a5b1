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

#include "levelWaterTable.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterTables
{
    defineTypeNameAndDebug(levelWaterTable, 0);
    addToRunTimeSelectionTable(waterTable, levelWaterTable, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterTables::levelWaterTable::levelWaterTable
(
    const dictionary& dict,
    const polyMesh& mesh,
    const vector& up
)
:
    waterTable(),
    level_
    (
        readChecked
        (
            dict,
            "level",
            [](const scalar) { return true; },
            "any finite elevation [m]"
        )
    )
{
    checkKeys(dict, {"type", "level"}, {"FoamFile"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::waterTables::levelWaterTable::elevation
(
    const UList<point>& points
) const
{
    return scalarField(points.size(), level_);
}

// ************************************************************************* //
