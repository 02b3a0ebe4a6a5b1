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

#include "gardnerRetention.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterRetentionModels
{
    defineTypeNameAndDebug(gardnerRetention, 0);
    addToRunTimeSelectionTable
    (
        waterRetentionModel,
        gardnerRetention,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModels::gardnerRetention::gardnerRetention
(
    const dictionary& dict
)
:
    waterRetentionModel(dict),
    alpha_
    (
        readChecked
        (
            dict,
            "alpha",
            [](const scalar x) { return x > 0; },
            "alpha > 0 [1/m]"
        )
    )
{
    checkKeys(dict, {"type", "thetaS", "thetaR", "alpha"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::gardnerRetention::SeIntegral
(
    const scalar h
) const
{
    return h < 0 ? std::expm1(alpha_*h)/alpha_ : h;
}

// ************************************************************************* //
