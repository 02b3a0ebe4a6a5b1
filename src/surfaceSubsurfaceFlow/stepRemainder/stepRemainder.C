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

#include "stepRemainder.H"
#include "groundSurface.H"
#include "calculatedFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::stepRemainder::forAllValues(const Operation& operation)
{
    for (label celli = 0; celli < nCells_; ++celli)
    {
        operation(celli, field_[celli]);
    }

    const polyBoundaryMesh& patches = field_.mesh().boundaryMesh();
    volScalarField::Boundary& fieldBf = field_.boundaryFieldRef();

    forAll(ground_.faces(), i)
    {
        const label facei = ground_.faces()[i];
        const label patchi = patches.whichPatch(facei);

        operation(nCells_ + i, fieldBf[patchi][facei - patches[patchi].start()]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepRemainder::stepRemainder
(
    const fvMesh& mesh,
    const groundSurface& ground,
    const label nCells
)
:
    ground_(ground),
    nCells_(nCells),
    field_
    (
        IOobject
        (
            "stepRemainder",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimVolume, Zero),
        calculatedFvPatchScalarField::typeName
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepRemainder::get(scalarField& values)
{
    forAllValues
    (
        [&](const label i, const scalar value)
        {
            values[i] = value;
        }
    );
}


void Foam::stepRemainder::keep(const scalarField& values)
{
    forAllValues
    (
        [&](const label i, scalar& value)
        {
            value = values[i];
        }
    );
}

// ************************************************************************* //
