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

#include "fixedPiezometricHeadFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"
#include "gravityMeshObject.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fixedPiezometricHeadFvPatchScalarField::
fixedPiezometricHeadFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(p, iF),
    head_()
{}


Foam::fixedPiezometricHeadFvPatchScalarField::
fixedPiezometricHeadFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    soilBoundaryFvPatchScalarField(p, iF, dict),
    head_(Function1<scalar>::New("head", dict))
{}


Foam::fixedPiezometricHeadFvPatchScalarField::
fixedPiezometricHeadFvPatchScalarField
(
    const fixedPiezometricHeadFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    soilBoundaryFvPatchScalarField(ptf, p, iF, mapper),
    head_(ptf.head_.clone())
{}


Foam::fixedPiezometricHeadFvPatchScalarField::
fixedPiezometricHeadFvPatchScalarField
(
    const fixedPiezometricHeadFvPatchScalarField& ptf
)
:
    soilBoundaryFvPatchScalarField(ptf),
    head_(ptf.head_.clone())
{}


Foam::fixedPiezometricHeadFvPatchScalarField::
fixedPiezometricHeadFvPatchScalarField
(
    const fixedPiezometricHeadFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(ptf, iF),
    head_(ptf.head_.clone())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fixedPiezometricHeadFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const Time& time = db().time();
    const vector g(meshObjects::gravity::New(time).value());

    operator==(head_->value(time.value()) + (patch().Cf() & g)/mag(g));

    soilBoundaryFvPatchScalarField::updateCoeffs();
}


void Foam::fixedPiezometricHeadFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    head_->writeData(os);
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchScalarField,
        fixedPiezometricHeadFvPatchScalarField
    );
}

// ************************************************************************* //
