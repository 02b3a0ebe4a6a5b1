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

#include "facePaths.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::facePaths::side Foam::facePaths::of
(
    const label facei,
    const vector& delta,
    const symmTensor& tensor
) const
{
    const vector& area = mesh_.faceAreas()[facei];

    side result;
    result.delta = delta;
    result.coArea = tensor & area;
    result.transmissibility = (area & result.coArea)/(area & delta);
    return result;
}


Foam::scalar Foam::facePaths::ownerShare(const label facei) const
{
    // The least on either side, for concave cells
    const scalar least = 0.01;

    const vector& area = mesh_.faceAreas()[facei];
    const vector& centre = mesh_.cellCentres()[mesh_.faceOwner()[facei]];

    const scalar share =
        (area & (mesh_.faceCentres()[facei] - centre))/(area & delta(facei));

    return min(max(share, least), 1 - least);
}


const Foam::symmTensor& Foam::facePaths::otherTensor(const label facei) const
{
    return
        mesh_.isInternalFace(facei)
      ? tensors_[mesh_.faceNeighbour()[facei]]
      : otherTensors_[facei - mesh_.nInternalFaces()];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::facePaths::facePaths
(
    const fvMesh& mesh,
    const symmTensorField& tensors
)
:
    mesh_(mesh),
    tensors_(tensors),
    otherCentres_(),
    otherTensors_()
{
    syncTools::swapBoundaryCellPositions
    (
        mesh,
        mesh.cellCentres(),
        otherCentres_
    );
    syncTools::swapBoundaryCellList(mesh, tensors, otherTensors_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::facePaths::twoSided(const label facei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    return
        mesh_.isInternalFace(facei)
     || patches[patches.whichPatch(facei)].coupled();
}


bool Foam::facePaths::uniform(const label facei) const
{
    return tensors_[mesh_.faceOwner()[facei]] == otherTensor(facei);
}


Foam::facePaths::side Foam::facePaths::first(const label facei) const
{
    const scalar share = twoSided(facei) ? ownerShare(facei) : 1;

    return of
    (
        facei,
        share*delta(facei),
        tensors_[mesh_.faceOwner()[facei]]
    );
}


Foam::facePaths::side Foam::facePaths::second(const label facei) const
{
    return of
    (
        facei,
        (1 - ownerShare(facei))*delta(facei),
        otherTensor(facei)
    );
}


Foam::vector Foam::facePaths::delta(const label facei) const
{
    const vector& centre = mesh_.cellCentres()[mesh_.faceOwner()[facei]];

    if (mesh_.isInternalFace(facei))
    {
        return mesh_.cellCentres()[mesh_.faceNeighbour()[facei]] - centre;
    }

    return
        (
            twoSided(facei)
          ? otherCentres_[facei - mesh_.nInternalFaces()]
          : mesh_.faceCentres()[facei]
        )
      - centre;
}


Foam::scalar Foam::facePaths::transmissibility(const label facei) const
{
    const scalar T1 = first(facei).transmissibility;

    return
        twoSided(facei)
      ? 1/(1/T1 + 1/second(facei).transmissibility)
      : T1;
}

// ************************************************************************* //
