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

#include "criticalDepth.H"
#include "readChecked.H"
#include "standardGravity.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace surfaceOutlets
{
    defineTypeNameAndDebug(criticalDepth, 0);
    addToRunTimeSelectionTable(surfaceOutlet, criticalDepth, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceOutlets::criticalDepth::criticalDepth
(
    const word& patchName,
    const scalar length,
    const dictionary& dict
)
:
    surfaceOutlet(patchName, length, dict)
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::surfaceOutlets::criticalDepth::outflow
(
    const edgeWater& water,
    scalar& dDepth
) const
{
    const scalar velocity = sqrt(standardGravity*water.depth);

    dDepth = 1.5*velocity;

    return velocity*water.depth;
}

// ************************************************************************* //
