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

#include "gardnerPermeability.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace relativePermeabilityModels
{
    defineTypeNameAndDebug(gardnerPermeability, 0);
    addToRunTimeSelectionTable
    (
        relativePermeabilityModel,
        gardnerPermeability,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::relativePermeabilityModels::gardnerPermeability::gardnerPermeability
(
    const dictionary& dict,
    const waterRetentionModel& retention
)
:
    relativePermeabilityModel(),
    alpha_
    (
        readChecked
        (
            dict,
            "alpha",
            [](const scalar x) { return x > 0; },
            "alpha > 0 [1/m]"
        )
    ),
    saturationHead_(retention.saturationHead())
{
    checkKeys(dict, {"type", "alpha"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::relativePermeabilityModels::gardnerPermeability::logKr
(
    const scalar h
) const
{
    return h < saturationHead_ ? alpha_*(h - saturationHead_) : 0;
}


Foam::scalar Foam::relativePermeabilityModels::gardnerPermeability::dkrdh
(
    const scalar h
) const
{
    return h < saturationHead_ ? alpha_*kr(h) : 0;
}

// ************************************************************************* //
