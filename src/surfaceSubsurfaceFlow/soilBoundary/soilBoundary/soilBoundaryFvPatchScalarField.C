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

#include "soilBoundaryFvPatchScalarField.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(soilBoundaryFvPatchScalarField, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilBoundaryFvPatchScalarField::soilBoundaryFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(p, iF),
    valueGiven_(false)
{}


Foam::soilBoundaryFvPatchScalarField::soilBoundaryFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchScalarField(p, iF, dict, false),
    valueGiven_(dict.found("value"))
{
    if (valueGiven_)
    {
        fvPatchScalarField::operator=(scalarField("value", dict, p.size()));
    }
    else
    {
        fvPatchScalarField::operator=(patchInternalField());
    }
}


Foam::soilBoundaryFvPatchScalarField::soilBoundaryFvPatchScalarField
(
    const soilBoundaryFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchScalarField(ptf, p, iF, mapper),
    valueGiven_(ptf.valueGiven_)
{}


Foam::soilBoundaryFvPatchScalarField::soilBoundaryFvPatchScalarField
(
    const soilBoundaryFvPatchScalarField& ptf
)
:
    fixedValueFvPatchScalarField(ptf),
    valueGiven_(ptf.valueGiven_)
{}


Foam::soilBoundaryFvPatchScalarField::soilBoundaryFvPatchScalarField
(
    const soilBoundaryFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(ptf, iF),
    valueGiven_(ptf.valueGiven_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::soilBoundaryFvPatchScalarField::inflow
(
    const scalar,
    const scalar
) const
{
    return 0;
}

// ************************************************************************* //
