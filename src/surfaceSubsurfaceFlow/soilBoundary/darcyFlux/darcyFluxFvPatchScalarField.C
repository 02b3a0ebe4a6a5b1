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

#include "darcyFluxFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(p, iF),
    flux_()
{}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    soilBoundaryFvPatchScalarField(p, iF, dict),
    flux_(Function1<scalar>::New("flux", dict))
{}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    soilBoundaryFvPatchScalarField(ptf, p, iF, mapper),
    flux_(ptf.flux_.clone())
{}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf
)
:
    soilBoundaryFvPatchScalarField(ptf),
    flux_(ptf.flux_.clone())
{}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(ptf, iF),
    flux_(ptf.flux_.clone())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::darcyFluxFvPatchScalarField::inflow
(
    const scalar t1,
    const scalar t2
) const
{
    return flux_->value(0.5*(t1 + t2));
}


void Foam::darcyFluxFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    flux_->writeData(os);
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField(fvPatchScalarField, darcyFluxFvPatchScalarField);
}

// ************************************************************************* //
