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

#include "bedSlopeDiffusionWave.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace overlandFlowModels
{
    defineTypeNameAndDebug(bedSlopeDiffusionWave, 0);
    addToRunTimeSelectionTable
    (
        overlandFlowModel,
        bedSlopeDiffusionWave,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::overlandFlowModels::bedSlopeDiffusionWave::bedSlopeDiffusionWave
(
    const dictionary& dict
)
:
    overlandFlowModel(dict),
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
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::overlandFlowModels::bedSlopeDiffusionWave::frictionSlopeSqr
(
    const side& upwind,
    const scalar,
    const scalar,
    scalar& dNormal
) const
{
    dNormal = 0;

    return sqr(slope_ > 0 ? slope_ : upwind.bedSlope);
}


// ************************************************************************* //
