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


void Foam::groundSurface::add
(
    const word& name,
    const labelUList& faces,
    const dictionary& rain
)
{
    faces_.append(faces);
    starts_.append(faces_.size());
    updateGeometry();

    names_.append(name);
    rains_.append
    (
        rainfall::New("rainfall", rain, groundPlan(mesh_, faces, up_))
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::groundSurface::groundSurface(const fvMesh& mesh, const vector& up)
:
    mesh_(mesh),
    up_(up),
    nRouted_(0),
    faces_(),
    starts_(1, Zero),
    names_(),
    rains_(),
    heldRain_(-1),
    planArea_(),
    elevation_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::groundSurface::addRouted
(
    const faMesh& aMesh,
    const dictionary& rain
)
{
    nRouted_ = aMesh.nFaces();
    add("ground", aMesh.faceLabels(), rain);
}


void Foam::groundSurface::addPatch
(
    const polyPatch& patch,
    const dictionary& rain
)
{
    add(patch.name(), identity(patch.size(), patch.start()), rain);
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
    if (heldRain_ >= 0)
    {
        return heldRain_*(t2 - t1)*planArea_;
    }

    auto tvolume = tmp<scalarField>::New(size(), Zero);
    scalarField& volume = tvolume.ref();

    forAll(rains_, groupi)
    {
        SubList<scalar> group
        (
            volume,
            starts_[groupi + 1] - starts_[groupi],
            starts_[groupi]
        );
        rains_[groupi].addDepth(t1, t2, group);
    }

    volume *= planArea_;

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


void Foam::groundSurface::reportRain(const scalar t1, const scalar t2) const
{
    const scalar millimetres = 1e3;

    // Mean over an hour or more that no gauge has recorded [mm/h]
    const scalar mostRain = 500;

    const scalarField volume(rainVolume(t1, t2));

    forAll(rains_, groupi)
    {
        scalar area = 0;
        scalar total = 0;
        for (label i = starts_[groupi]; i < starts_[groupi + 1]; ++i)
        {
            area += planArea_[i];
            total += volume[i];
        }
        reduce(area, sumOp<scalar>());
        reduce(total, sumOp<scalar>());

        const rainfall::record own(rains_[groupi].recorded());
        const scalar depth = total/max(area, VSMALL);

        Info<< "Rain on " << names_[groupi] << ": " << millimetres*depth
            << " mm from " << t1 << " s to " << t2 << " s, mean over "
            << area << " m2";

        if (own.given)
        {
            Info<< "; on record " << millimetres*own.depth << " mm from "
                << own.begin << " s to " << own.end << " s";

            if (t1 > own.begin)
            {
                Info<< "; the run begins after the record";
            }
            if (t2 < own.end)
            {
                Info<< "; the run ends before the record";
            }
        }

        Info<< endl;

        const scalar hours = (t2 - t1)/3600;
        if (millimetres*depth > mostRain*max(hours, scalar(1)))
        {
            WarningInFunction
                << "Rain on " << names_[groupi] << " of "
                << millimetres*depth << " mm in " << hours
                << " h is more than has ever fallen. Is its unit right?"
                << endl;
        }
    }
}

// ************************************************************************* //
