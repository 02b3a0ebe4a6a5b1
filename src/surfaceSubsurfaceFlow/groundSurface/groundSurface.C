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

#include "groundSurface.H"
#include "faMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::groundSurface::checkUpward
(
    const label facei,
    const scalar planArea
) const
{
    // Steeper than 89.9 degrees: a depth of water has no meaning there
    const scalar minCosine = 1e-3;

    if (planArea < minCosine*mag(mesh_.faceAreas()[facei]))
    {
        FatalErrorInFunction
            << "Ground face " << facei << " of patch "
            << mesh_.boundary()
               [
                   mesh_.boundaryMesh().whichPatch(facei)
               ].name()
            << " at " << mesh_.faceCentres()[facei]
            << " is vertical or overhangs: the cosine between its outward"
            << " normal and the upward direction " << up_ << " is "
            << planArea/mag(mesh_.faceAreas()[facei])
            << ", it must exceed " << minCosine
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::groundSurface::groundSurface(const fvMesh& mesh, const vector& up)
:
    mesh_(mesh),
    up_(up),
    nRouted_(0),
    faces_(),
    starts_(1, Zero),
    rains_(),
    planArea_(),
    elevation_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::groundSurface::addRouted(const faMesh& aMesh, const rainfall& rain)
{
    nRouted_ = aMesh.nFaces();
    faces_.append(aMesh.faceLabels());
    starts_.append(faces_.size());
    rains_.append(&rain);
    updateGeometry();
}


void Foam::groundSurface::addPatch
(
    const polyPatch& patch,
    const rainfall& rain
)
{
    faces_.append(identity(patch.size(), patch.start()));
    starts_.append(faces_.size());
    rains_.append(&rain);
    updateGeometry();
}


void Foam::groundSurface::updateGeometry()
{
    planArea_.setSize(size());
    elevation_.setSize(size());

    forAll(faces_, i)
    {
        const label facei = faces_[i];

        planArea_[i] = mesh_.faceAreas()[facei] & up_;
        elevation_[i] = mesh_.faceCentres()[facei] & up_;

        checkUpward(facei, planArea_[i]);
    }
}


Foam::tmp<Foam::scalarField> Foam::groundSurface::rainVolume
(
    const scalar t1,
    const scalar t2
) const
{
    auto tvolume = tmp<scalarField>::New(size());
    scalarField& volume = tvolume.ref();

    forAll(rains_, groupi)
    {
        const scalar depth = rains_[groupi].depth(t1, t2);

        for (label i = starts_[groupi]; i < starts_[groupi + 1]; ++i)
        {
            volume[i] = depth*planArea_[i];
        }
    }

    return tvolume;
}


Foam::scalar Foam::groundSurface::nextBreakPoint(const scalar t) const
{
    scalar result = VGREAT;

    forAll(rains_, groupi)
    {
        result = min(result, rains_[groupi].nextBreakPoint(t));
    }

    return result;
}

// ************************************************************************* //
