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

#include "subsurfaceFlow.H"
#include "fixedValueFvPatchFields.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::subsurfaceFlow::readConditions()
{
    forAll(conditions_, patchi)
    {
        const fvPatchScalarField& field = psi_.boundaryField()[patchi];
        const fvPatch& patch = field.patch();

        if (isA<soilBoundaryFvPatchScalarField>(field))
        {
            conditions_[patchi] =
                refCast<const soilBoundaryFvPatchScalarField>(field)
               .prescribes();
        }
        else if (field.fixesValue() && !patch.coupled())
        {
            conditions_[patchi] = condition::head;
        }
        else if
        (
            !isA<processorPolyPatch>(patch.patch())
         && (
                patch.coupled()
             || !polyPatch::constraintType(patch.patch().type())
            )
        )
        {
            FatalErrorInFunction
                << "psi, patch " << patch.name() << ": type " << field.type()
                << " does not say how water passes. Use noFlow, fixedValue or"
                << " another fixed head, fixedPiezometricHead, darcyFlux,"
                << " freeDrainage, seepageFace, groundSurface or surfaceRain;"
                << " empty, symmetry, symmetryPlane and wedge patches are"
                << " walls, cyclic ones are not supported (file "
                << psi_.objectPath() << ')'
                << exit(FatalError);
        }
    }
}


bool Foam::subsurfaceFlow::open(const condition type)
{
    return
        type == condition::head
     || type == condition::seepage
     || type == condition::surface;
}


void Foam::subsurfaceFlow::setConnection
(
    richardsFlux::connection& c,
    const label facei,
    const vector& otherPoint,
    const label otherSoil
) const
{
    const label own = mesh_.faceOwner()[facei];
    const vector& centre = mesh_.cellCentres()[own];
    const vector& area = mesh_.faceAreas()[facei];
    const vector delta(otherPoint - centre);

    c.transmissibility = magSqr(area)/(area & delta);
    c.drop = -(delta & up_);
    c.soil1 = soils_.zones().cellSoil()[own];
    c.soil2 = otherSoil;

    if (c.soil1 != c.soil2)
    {
        // Share of the way that lies in the first soil
        const scalar share =
            (area & (mesh_.faceCentres()[facei] - centre))/(area & delta);

        c.Ks =
            1/(
                share/tables_[c.soil1].Ks()
              + (1 - share)/tables_[c.soil2].Ks()
            );
    }
}


void Foam::subsurfaceFlow::makeConnections()
{
    const labelList& cellSoil = soils_.zones().cellSoil();
    const vectorField& centres = mesh_.cellCentres();
    const labelList& neighbour = mesh_.faceNeighbour();

    vectorField otherCentres;
    syncTools::swapBoundaryCellPositions(mesh_, centres, otherCentres);
    syncTools::swapBoundaryCellList(mesh_, cellSoil, otherSoil_);

    forAll(neighbour, facei)
    {
        setConnection
        (
            connections_[facei],
            facei,
            centres[neighbour[facei]],
            cellSoil[neighbour[facei]]
        );
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label b = facei - mesh_.nInternalFaces();

            setConnection
            (
                connections_[facei],
                facei,
                patch.coupled() ? otherCentres[b] : mesh_.faceCentres()[facei],
                patch.coupled()
              ? otherSoil_[b]
              : cellSoil[mesh_.faceOwner()[facei]]
            );
        }
    }

    flux_->prepare(connections_);

    boolList openFaces(mesh_.nFaces() - mesh_.nInternalFaces(), false);
    forAll(conditions_, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        SubList<bool>
        (
            openFaces,
            patch.size(),
            patch.start() - mesh_.nInternalFaces()
        ) = open(conditions_[patchi]);
    }
    correction_.setGeometry(openFaces);
}

// ************************************************************************* //
