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

Foam::tmp<Foam::vectorField> Foam::nonOrthogonalFlux::cellVelocity
(
    const scalarField& faceFlux
) const
{
    const vectorField& area = mesh_.faceAreas();
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    auto tvelocity = tmp<vectorField>::New(mesh_.nCells(), Zero);
    vectorField& velocity = tvelocity.ref();

    forAll(area, facei)
    {
        const vector part(area[facei]*(faceFlux[facei]/mag(area[facei])));

        velocity[owner[facei]] += part;
        if (facei < neighbour.size())
        {
            velocity[neighbour[facei]] += part;
        }
    }

    forAll(velocity, celli)
    {
        velocity[celli] = reconstruction_[celli] & velocity[celli];
    }

    return tvelocity;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonOrthogonalFlux::nonOrthogonalFlux(const fvMesh& mesh)
:
    mesh_(mesh),
    rest_(mesh.nFaces(), Zero),
    active_(false),
    reconstruction_(mesh.nCells(), Zero),
    correction_(mesh.nFaces(), Zero)
{
    // Smaller parts of a face's area are round-off of the mesh's points
    const scalar negligible = 1e-6;

    const vectorField& area = mesh.faceAreas();
    const vectorField& faceCentres = mesh.faceCentres();
    const vectorField& centres = mesh.cellCentres();
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    vectorField otherCentres;
    syncTools::swapBoundaryCellPositions(mesh, centres, otherCentres);

    forAll(area, facei)
    {
        const label own = owner[facei];
        const symmTensor square(sqr(area[facei])/mag(area[facei]));

        reconstruction_[own] += square;

        vector other(faceCentres[facei]);
        bool open = true;
        if (facei < neighbour.size())
        {
            other = centres[neighbour[facei]];
            reconstruction_[neighbour[facei]] += square;
        }
        else
        {
            const polyPatch& patch = patches[patches.whichPatch(facei)];
            if (patch.coupled())
            {
                other = otherCentres[facei - mesh.nInternalFaces()];
            }
            open = !polyPatch::constraintType(patch.type()) || patch.coupled();
        }

        if (open)
        {
            const vector k(rest(area[facei], other - centres[own]));
            if (mag(k) > negligible*mag(area[facei]))
            {
                rest_[facei] = k;
                active_ = true;
            }
        }
    }

    reduce(active_, orOp<bool>());

    if (active_)
    {
        for (symmTensor& t : reconstruction_)
        {
            t = inv(t);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonOrthogonalFlux::update(const scalarField& faceFlux)
{
    if (!active_)
    {
        return;
    }

    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    const vectorField velocity(cellVelocity(faceFlux));

    forAll(neighbour, facei)
    {
        correction_[facei] =
            0.5*(velocity[owner[facei]] + velocity[neighbour[facei]])
          & rest_[facei];
    }

    vectorField otherVelocity;
    syncTools::swapBoundaryCellList(mesh_, velocity, otherVelocity);

    for (const polyPatch& patch : patches)
    {
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            vector u(velocity[owner[facei]]);
            if (patch.coupled())
            {
                u = 0.5*(u + otherVelocity[facei - mesh_.nInternalFaces()]);
            }
            correction_[facei] = u & rest_[facei];
        }
    }
}

// ************************************************************************* //
