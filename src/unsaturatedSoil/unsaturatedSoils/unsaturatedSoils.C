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

#include "unsaturatedSoils.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Curve>
Foam::tmp<Foam::volScalarField> Foam::unsaturatedSoils::curveField
(
    const word& fieldName,
    const volScalarField& psi,
    const Curve& curve
) const
{
    auto tfield =
        tmp<volScalarField>::New
        (
            IOobject
            (
                fieldName,
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh_,
            dimensionedScalar(dimless, Zero)
        );
    volScalarField& field = tfield.ref();

    forAll(psi, celli)
    {
        field[celli] = curve(celli, psi[celli]);
    }

    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& pfield = field.boundaryFieldRef()[patchi];
        const fvPatchScalarField& ppsi = psi.boundaryField()[patchi];

        if (!pfield.coupled())
        {
            const labelUList& faceCells = pfield.patch().faceCells();

            forAll(pfield, facei)
            {
                pfield[facei] = curve(faceCells[facei], ppsi[facei]);
            }
        }
    }

    field.correctBoundaryConditions();

    return tfield;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unsaturatedSoils::unsaturatedSoils(const fvMesh& mesh)
:
    mesh_(mesh),
    zones_(mesh),
    hydraulics_(zones_.size()),
    variation_()
{
    Info<< "Soils" << nl;

    forAll(hydraulics_, soili)
    {
        hydraulics_.set
        (
            soili,
            new soilHydraulics
            (
                zones_.names()[soili],
                zones_.soilDict(soili).subDict("hydraulic")
            )
        );

        hydraulics_[soili].writeInfo(Info);
    }

    variation_.reset(new soilVariation(mesh, zones_, hydraulics_));

    Info<< endl;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField> Foam::unsaturatedSoils::theta
(
    const volScalarField& psi
) const
{
    return curveField
    (
        "theta",
        psi,
        [this](const label celli, const scalar h)
        {
            return variation_->theta(celli, ofCell(celli).theta(h));
        }
    );
}


Foam::tmp<Foam::volScalarField> Foam::unsaturatedSoils::Se
(
    const volScalarField& psi
) const
{
    return curveField
    (
        "Se",
        psi,
        [this](const label celli, const scalar h)
        {
            return ofCell(celli).retention().Se(h);
        }
    );
}


Foam::tmp<Foam::volScalarField> Foam::unsaturatedSoils::kr
(
    const volScalarField& psi
) const
{
    return curveField
    (
        "kr",
        psi,
        [this](const label celli, const scalar h)
        {
            return ofCell(celli).permeability().kr(h);
        }
    );
}

// ************************************************************************* //
