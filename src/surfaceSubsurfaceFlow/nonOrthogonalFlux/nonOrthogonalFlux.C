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

#include "nonOrthogonalFlux.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonOrthogonalFlux::setFace
(
    const label facei,
    const vector& delta,
    const bool open
)
{
    // Smaller parts of a face's area are round-off of the mesh's points
    const scalar negligible = 1e-6;

    const vector& area = mesh_.faceAreas()[facei];

    rest_[facei] = Zero;
    direction_[facei] = area/magSqr(area);

    if (open)
    {
        // The flux of two points is that over the area T |d|
        const scalar T = magSqr(area)/(area & delta);
        const vector rest(area - T*delta);

        if (mag(rest) > negligible*mag(area))
        {
            rest_[facei] = rest;
            direction_[facei] = delta/(T*magSqr(delta));
            active_ = true;
        }
    }
}


Foam::scalar Foam::nonOrthogonalFlux::limited
(
    const label facei,
    const vector& velocity,
    const scalar pointFlux,
    const scalar KOwner,
    const scalar KOther
) const
{
    // Where the conductivities differ by more than this a front passes
    const scalar front = 2;

    const scalar correction = velocity & rest_[facei];
    const scalar KLoser = correction > 0 ? KOwner : KOther;
    const scalar KLargest = max(KOwner, KOther);

    if (KLargest <= front*min(KOwner, KOther))
    {
        return correction*(KLoser/KLargest);
    }

    const scalar bound = mag(pointFlux);

    return min(max(correction*(KLoser/KLargest), -bound), bound);
}


Foam::tmp<Foam::vectorField> Foam::nonOrthogonalFlux::cellVelocity
(
    const scalarField& pointFlux
) const
{
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    auto tvelocity = tmp<vectorField>::New(mesh_.nCells(), Zero);
    vectorField& velocity = tvelocity.ref();

    forAll(owner, facei)
    {
        const vector part(pointFlux[facei]*direction_[facei]);

        velocity[owner[facei]] += part;
        if (facei < neighbour.size())
        {
            velocity[neighbour[facei]] += part;
        }
    }

    forAll(velocity, celli)
    {
        velocity[celli] = inverse_[celli] & velocity[celli];
    }

    return tvelocity;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonOrthogonalFlux::nonOrthogonalFlux(const fvMesh& mesh)
:
    mesh_(mesh),
    rest_(mesh.nFaces(), Zero),
    direction_(mesh.nFaces(), Zero),
    active_(false),
    inverse_(mesh.nCells(), Zero),
    correction_(mesh.nFaces(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonOrthogonalFlux::setGeometry(const UList<bool>& open)
{
    const vectorField& centres = mesh_.cellCentres();
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    vectorField otherCentres;
    syncTools::swapBoundaryCellPositions(mesh_, centres, otherCentres);

    forAll(neighbour, facei)
    {
        setFace
        (
            facei,
            centres[neighbour[facei]] - centres[owner[facei]],
            true
        );
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label b = facei - mesh_.nInternalFaces();
            const vector& other =
                patch.coupled()
              ? otherCentres[b]
              : mesh_.faceCentres()[facei];

            setFace
            (
                facei,
                other - centres[owner[facei]],
                patch.coupled() || open[b]
            );
        }
    }

    reduce(active_, orOp<bool>());

    inverse_ = Zero;
    forAll(owner, facei)
    {
        const symmTensor square
        (
            sqr(direction_[facei])/magSqr(direction_[facei])
        );

        inverse_[owner[facei]] += square;
        if (facei < neighbour.size())
        {
            inverse_[neighbour[facei]] += square;
        }
    }

    for (symmTensor& t : inverse_)
    {
        t = inv(t);
    }
}


void Foam::nonOrthogonalFlux::update
(
    const scalarField& pointFlux,
    const scalarField& K,
    const scalarField& boundaryK
)
{
    if (!active_)
    {
        return;
    }

    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    const vectorField velocity(cellVelocity(pointFlux));

    forAll(neighbour, facei)
    {
        correction_[facei] = limited
        (
            facei,
            0.5*(velocity[owner[facei]] + velocity[neighbour[facei]]),
            pointFlux[facei],
            K[owner[facei]],
            K[neighbour[facei]]
        );
    }

    vectorField otherVelocity;
    syncTools::swapBoundaryCellList(mesh_, velocity, otherVelocity);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label b = facei - mesh_.nInternalFaces();

            vector u(velocity[owner[facei]]);
            if (patch.coupled())
            {
                u = 0.5*(u + otherVelocity[b]);
            }
            correction_[facei] = limited
            (
                facei,
                u,
                pointFlux[facei],
                K[owner[facei]],
                boundaryK[b]
            );
        }
    }
}

// ************************************************************************* //
