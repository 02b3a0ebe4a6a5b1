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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::darcyFluxFvPatchScalarField::readFlux()
{
    if (!fluxDict_.empty())
    {
        // Water may go out too
        const scalar least = -GREAT;

        flux_.reset(new rateSeries("flux", fluxDict_, least));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(p, iF),
    fluxDict_(),
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
    fluxDict_(),
    flux_()
{
    for
    (
        const word key
      : {"flux", "fluxCoeffs", "outOfBounds", "interpolationScheme"}
    )
    {
        if (const entry* e = dict.findEntry(key, keyType::LITERAL))
        {
            fluxDict_.add(*e);
        }
    }

    // For messages
    fluxDict_.name() = dict.name();

    if (!fluxDict_.found("flux"))
    {
        FatalIOErrorInFunction(dict)
            << "darcyFlux needs the entry flux [m/s]" << exit(FatalIOError);
    }

    readFlux();
}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    soilBoundaryFvPatchScalarField(ptf, p, iF, mapper),
    fluxDict_(ptf.fluxDict_),
    flux_()
{
    readFlux();
}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf
)
:
    soilBoundaryFvPatchScalarField(ptf),
    fluxDict_(ptf.fluxDict_),
    flux_()
{
    readFlux();
}


Foam::darcyFluxFvPatchScalarField::darcyFluxFvPatchScalarField
(
    const darcyFluxFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    soilBoundaryFvPatchScalarField(ptf, iF),
    fluxDict_(ptf.fluxDict_),
    flux_()
{
    readFlux();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::darcyFluxFvPatchScalarField::inflow
(
    const scalar t1,
    const scalar t2
) const
{
    return flux_->amount(t1, t2)/(t2 - t1);
}


void Foam::darcyFluxFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    forAllConstIters(fluxDict_, e)
    {
        e().write(os);
    }
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * Build Macro Function  * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField(fvPatchScalarField, darcyFluxFvPatchScalarField);
}

// ************************************************************************* //
