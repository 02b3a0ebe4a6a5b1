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

#include "normalDepth.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace surfaceOutlets
{
    defineTypeNameAndDebug(normalDepth, 0);
    addToRunTimeSelectionTable(surfaceOutlet, normalDepth, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceOutlets::normalDepth::normalDepth
(
    const word& patchName,
    const scalar length,
    const dictionary& dict
)
:
    surfaceOutlet(patchName, length, dict),
    dict_(dict),
    slope_
    (
        readCheckedOrDefault
        (
            dict,
            "slope",
            -1,
            [](const scalar s) { return s > 0; },
            "slope > 0"
        )
    )
{
    checkKeys(dict, {"type", "slope"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::surfaceOutlets::normalDepth::checkEdge
(
    const scalar bedSlope,
    const vector& where
) const
{
    if (slope_ < 0 && bedSlope <= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Outlet " << patchName() << ": the ground falls by "
            << bedSlope << " towards the edge at " << where
            << ". normalDepth needs a bed slope > 0 there, or an entry slope"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::surfaceOutlets::normalDepth::outflow
(
    const edgeWater& water,
    scalar& dDepth
) const
{
    const scalar root = sqrt(slope_ > 0 ? slope_ : water.bedSlope);

    dDepth = root*water.dDischarge;

    return root*water.discharge;
}

// ************************************************************************* //
