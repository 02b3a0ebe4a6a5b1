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

#include "stepHistory.H"
#include "groundSurface.H"
#include "areaFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::stepHistory::forAllValues(const Operation& operation)
{
    if (faces_)
    {
        surfaceScalarField& field = *faces_;
        const fvMesh& mesh = field.mesh();

        forAll(field, facei)
        {
            operation(lduMesh_.faceCoupling(facei), field[facei]);
        }
        forAll(field.boundaryField(), patchi)
        {
            scalarField& values = field.boundaryFieldRef()[patchi];
            const label start = mesh.boundaryMesh()[patchi].start();

            forAll(values, i)
            {
                operation(volumes_.boundaryFace(start + i), values[i]);
            }
        }
        forAll(ground_.faces(), i)
        {
            const label facei = ground_.faces()[i];
            const label patchi = mesh.boundaryMesh().whichPatch(facei);

            operation
            (
                lduMesh_.groundCoupling(i),
                field.boundaryFieldRef()[patchi]
                [
                    facei - mesh.boundaryMesh()[patchi].start()
                ]
            );
        }
    }

    if (edges_)
    {
        edgeScalarField& field = *edges_;

        forAll(field, edgei)
        {
            operation(lduMesh_.edgeCoupling(edgei), field[edgei]);
        }
        forAll(field.boundaryField(), patchi)
        {
            scalarField& values = field.boundaryFieldRef()[patchi];
            forAll(values, i)
            {
                operation(volumes_.groundEdge(patchi, i), values[i]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepHistory::stepHistory
(
    stepVolumes& volumes,
    const coupledLduMesh& lduMesh,
    const fvMesh& mesh,
    const groundSurface& ground,
    const faMesh* aMesh,
    const bool hasSoil
)
:
    volumes_(volumes),
    lduMesh_(lduMesh),
    ground_(ground),
    faces_(),
    edges_()
{
    if (hasSoil)
    {
        faces_.reset
        (
            new surfaceScalarField
            (
                IOobject
                (
                    "stepVolume",
                    mesh.time().timeName(),
                    mesh,
                    IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedScalar(dimVolume, Zero)
            )
        );
        faces_->setOriented(true);
    }

    if (aMesh)
    {
        const IOobject io
        (
            "stepEdgeVolume",
            mesh.time().timeName(),
            aMesh->thisDb(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        );

        edges_.reset
        (
            IOobject(io).typeHeaderOk<edgeScalarField>(true)
          ? new edgeScalarField(io, *aMesh)
          : new edgeScalarField
            (
                IOobject(io),
                *aMesh,
                dimensionedScalar(dimVolume, Zero)
            )
        );
    }

    forAllValues
    (
        [&](const label place, const scalar value)
        {
            volumes_.history()[place] = value;
        }
    );

    // The faces of the ground are couplings, not boundary
    for (const label facei : ground_.faces())
    {
        if (hasSoil)
        {
            volumes_.history()[volumes_.boundaryFace(facei)] = 0;
        }
    }
    volumes_.matchHistory();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepHistory::keep()
{
    forAllValues
    (
        [&](const label place, scalar& value)
        {
            value = volumes_.history()[place];
        }
    );
}

// ************************************************************************* //
