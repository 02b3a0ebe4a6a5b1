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

#include "surfaceRainFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceRainFvPatchScalarField::surfaceRainFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(p, iF),
    rainDict_()
{}


Foam::surfaceRainFvPatchScalarField::surfaceRainFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    soilBoundaryFvPatchScalarField(p, iF, dict),
    rainDict_()
{
    for
    (
        const word key
      : {"rainfall", "rainfallCoeffs", "outOfBounds", "interpolationScheme"}
    )
    {
        if (const entry* e = dict.findEntry(key, keyType::LITERAL))
        {
            rainDict_.add(*e);
        }
    }

    // For messages
    rainDict_.name() = dict.name();
}


Foam::surfaceRainFvPatchScalarField::surfaceRainFvPatchScalarField
(
    const surfaceRainFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    soilBoundaryFvPatchScalarField(ptf, p, iF, mapper),
    rainDict_(ptf.rainDict_)
{}


Foam::surfaceRainFvPatchScalarField::surfaceRainFvPatchScalarField
(
    const surfaceRainFvPatchScalarField& ptf
)
:
    soilBoundaryFvPatchScalarField(ptf),
    rainDict_(ptf.rainDict_)
{}


Foam::surfaceRainFvPatchScalarField::surfaceRainFvPatchScalarField
(
    const surfaceRainFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(ptf, iF),
    rainDict_(ptf.rainDict_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::surfaceRainFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    forAllConstIters(rainDict_, e)
    {
        e().write(os);
    }
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField(fvPatchScalarField, surfaceRainFvPatchScalarField);
}

// ************************************************************************* //
