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

#include "planSurface.H"
#include "DynamicList.H"
#include "PstreamReduceOps.H"
#include "polyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // A place may be off the plan, and a triangle's plan be flat, by this part
    // of the surface's extent: the round-off of meshes written as text
    const Foam::scalar relativeTolerance = 1e-6;
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planSurface::flatten
(
    const pointField& points,
    const List<labelledTri>& faces
)
{
    elevation_ = points & up_;

    const pointField flatPoints(points - up_*elevation_);
    const boundBox bounds(flatPoints, false);
    const scalar flatArea = sqr(relativeTolerance*bounds.mag());

    DynamicList<labelledTri> flatFaces(faces.size());

    for (const labelledTri& face : faces)
    {
        if (face.tri(flatPoints).mag() > flatArea)
        {
            flatFaces.append(face);
        }
    }

    if (flatFaces.empty())
    {
        FatalErrorInFunction
            << "The surface " << name_.c_str() << " covers no area in the plan"
            << exit(FatalError);
    }

    flat_ = triSurface(flatFaces, flatPoints);
    search_.reset(new triSurfaceSearch(flat_));
}


Foam::triSurface Foam::planSurface::trianglesOf(const polyPatch& patch)
{
    List<pointField> points(Pstream::nProcs());
    List<faceList> faces(Pstream::nProcs());
    points[Pstream::myProcNo()] = patch.localPoints();
    faces[Pstream::myProcNo()] = patch.localFaces();
    Pstream::gatherList(points);
    Pstream::scatterList(points);
    Pstream::gatherList(faces);
    Pstream::scatterList(faces);

    DynamicList<point> allPoints;
    DynamicList<labelledTri> triangles;

    forAll(points, proci)
    {
        const label start = allPoints.size();
        allPoints.append(points[proci]);

        for (const face& f : faces[proci])
        {
            // The centre and each edge, so that a warped face's elevation at
            // its centre is that of the centre
            const label centre = allPoints.size();
            allPoints.append(f.centre(points[proci]));

            forAll(f, fp)
            {
                triangles.append
                (
                    labelledTri
                    (
                        start + f[fp],
                        start + f.nextLabel(fp),
                        centre,
                        0
                    )
                );
            }
        }
    }

    return triSurface(triangles, pointField(allPoints));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planSurface::planSurface
(
    const string& name,
    const triSurface& surface,
    const vector& up
)
:
    name_(name),
    up_(up)
{
    flatten(surface.points(), surface);
}


Foam::planSurface::planSurface(const polyPatch& patch, const vector& up)
:
    planSurface("patch " + patch.name(), trianglesOf(patch), up)
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::planSurface::elevation
(
    const UList<point>& points
) const
{
    const pointField& flatPoints = flat_.points();
    const scalar extent = boundBox(flatPoints, false).mag();
    scalarField result(points.size());

    forAll(points, i)
    {
        const point place(points[i] - up_*(points[i] & up_));
        const pointIndexHit hit
        (
            search_->tree().findNearest(place, sqr(GREAT*extent))
        );

        if (mag(hit.hitPoint() - place) > relativeTolerance*extent)
        {
            FatalErrorInFunction
                << "The point " << points[i] << " is "
                << mag(hit.hitPoint() - place)
                << " m outside the plan of the surface " << name_.c_str() << nl
                << "    The surface must cover the mesh as seen from above"
                << exit(FatalError);
        }

        const labelledTri& face = flat_[hit.index()];
        const barycentric2D weight
        (
            face.tri(flatPoints).pointToBarycentric(hit.hitPoint())
        );

        result[i] =
            weight.a()*elevation_[face[0]]
          + weight.b()*elevation_[face[1]]
          + weight.c()*elevation_[face[2]];
    }

    return result;
}

// ************************************************************************* //
