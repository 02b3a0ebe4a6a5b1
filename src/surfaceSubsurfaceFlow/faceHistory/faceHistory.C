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

#include "faceHistory.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::faceHistory::forAllFaces(const Operation& operation)
{
    forAll(field_, facei)
    {
        operation(facei, field_[facei]);
    }
    for (fvsPatchScalarField& values : field_.boundaryFieldRef())
    {
        forAll(values, i)
        {
            operation(values.patch().start() + i, values[i]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceHistory::faceHistory
(
    const word& name,
    const dimensionSet& dimensions,
    const fvMesh& mesh
)
:
    read_(false),
    field_
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimensions, Zero)
    )
{
    read_ = field_.headerOk();
    field_.setOriented(true);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::faceHistory::get(scalarField& values)
{
    forAllFaces
    (
        [&](const label facei, const scalar value)
        {
            values[facei] = value;
        }
    );
}


void Foam::faceHistory::keep(const scalarField& values)
{
    forAllFaces
    (
        [&](const label facei, scalar& value)
        {
            value = values[facei];
        }
    );
}

// ************************************************************************* //
