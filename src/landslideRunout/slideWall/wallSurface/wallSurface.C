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

#include "wallSurface.H"
#include "OSspecific.H"
#include "PatchTools.H"
#include "polyMesh.H"
#include "SortableList.H"
#include "slideFrame.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::triSurface Foam::wallSurface::triangles(const polyPatch& patch)
{
    pointField points(patch.localPoints());
    faceList faces(patch.localFaces());

    if (Pstream::parRun())
    {
        // Points of two processors are the same up to the digits of the files
        const scalar sameShare = 1e-8;
        const scalar size = mag(patch.boundaryMesh().mesh().bounds().span());

        labelList map;
        const primitivePatch local
        (
            SubList<face>(patch.localFaces(), patch.size()),
            patch.localPoints()
        );
        PatchTools::gatherAndMerge(sameShare*size, local, points, faces, map);
        Pstream::scatter(points);
        Pstream::scatter(faces);
    }

    labelList order(identity(points.size()));
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            const point& p = points[a];
            const point& q = points[b];
            return
                p.x() != q.x() ? p.x() < q.x()
              : p.y() != q.y() ? p.y() < q.y()
              : p.z() < q.z();
        }
    );
    const labelList number(invert(order.size(), order));

    DynamicList<triFace> result;
    for (const face& f : faces)
    {
        faceList parts(f.nTriangles());
        label n = 0;
        f.triangles(points, n, parts);
        for (const face& part : parts)
        {
            triFace t(number[part[0]], number[part[1]], number[part[2]]);
            while (t[0] > t[1] || t[0] > t[2])
            {
                t = triFace(t[1], t[2], t[0]);
            }
            result.append(t);
        }
    }
    std::sort
    (
        result.begin(),
        result.end(),
        [](const triFace& a, const triFace& b)
        {
            return std::lexicographical_compare
            (
                a.begin(), a.end(), b.begin(), b.end()
            );
        }
    );

    return triSurface(triFaceList(result), pointField(points, order));
}


Foam::List<Foam::wallSurface::segment> Foam::wallSurface::cut
(
    const slideFrame& frame,
    const scalar shift
) const
{
    const tensor axes(frame.axes());
    const vector normal(axes.z());
    const point origin(frame.toSpace(point(Zero)) + shift*normal);
    const pointField& points = surface_.points();

    DynamicList<segment> result;
    for (const labelledTri& t : surface_)
    {
        DynamicList<point, 3> ends;
        for (label i = 0; i < 3; ++i)
        {
            const point& a = points[t[i]];
            const point& b = points[t[t.fcIndex(i)]];
            const scalar da = (a - origin) & normal;
            const scalar db = (b - origin) & normal;

            if ((da >= 0) != (db >= 0))
            {
                const point p(a + da/(da - db)*(b - a) - origin);
                ends.append(point(p & axes.x(), p & axes.y(), 0));
            }
        }
        if (ends.size() == 2)
        {
            result.append(segment(ends[0], ends[1]));
        }
    }

    return List<segment>(result);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallSurface::wallSurface
(
    const dictionary& dict,
    const fileName& file,
    const scalar scale
)
:
    dict_(dict),
    what_("the surface of " + file),
    surface_()
{
    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict_)
            << "file: can't read " << file
            << exit(FatalIOError);
    }
    if (!triSurface::canRead(file, false))
    {
        FatalIOErrorInFunction(dict_)
            << "file: " << file << " is of no kind of surface that is known,"
            << " as stl, obj and vtk are"
            << exit(FatalIOError);
    }

    surface_ = triSurface(file, scale);

    if (surface_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "file: " << file << " has no triangles"
            << exit(FatalIOError);
    }
}


Foam::wallSurface::wallSurface(const dictionary& dict, const polyPatch& patch)
:
    dict_(dict),
    what_("the patch " + patch.name()),
    surface_(triangles(patch))
{
    if (surface_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "patch: " << what_.c_str() << " has no faces"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallSurface::requireClosed() const
{
    for (const labelList& faces : surface_.edgeFaces())
    {
        if (faces.size() != 2)
        {
            const label nOpen = surface_.nEdges() - surface_.nInternalEdges();

            FatalIOErrorInFunction(dict_)
                << "file: " << what_.c_str() << " does not enclose a body: "
                << nOpen << " of its " << surface_.nEdges()
                << " edges have one triangle, or an edge has more than two."
                << " A body has to be closed; for ground use type terrain"
                << exit(FatalIOError);
        }
    }

    scalar volume = 0;
    const point centre(average(surface_.points()));
    for (const labelledTri& t : surface_)
    {
        const pointField& p = surface_.points();
        volume +=
            (p[t[0]] - centre)
          & ((p[t[1]] - centre) ^ (p[t[2]] - centre))/6;
    }
    if (volume <= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "file: " << what_.c_str() << " is inside out: its triangles enclose "
            << volume << " m3 where a positive volume is needed. Turn them"
            << " round, for instance by surfaceOrient"
            << exit(FatalIOError);
    }
}


Foam::List<Foam::wallSurface::segment> Foam::wallSurface::cut
(
    const slideFrame& frame
) const
{
    // A plane along a side of the surface cuts it on one side of round-off
    const scalar nudge =
        1e-7*mag(boundBox(surface_.points(), false).span());

    for (const scalar shift : {scalar(0), nudge, -nudge})
    {
        List<segment> segments(cut(frame, shift));
        if (segments.size())
        {
            return segments;
        }
    }

    FatalIOErrorInFunction(dict_)
        << "The plane of the section does not cut " << what_.c_str() << ", which lies"
        << " in " << boundBox(surface_.points(), false)
        << exit(FatalIOError);

    return List<segment>();
}


void Foam::wallSurface::fillTerrain
(
    mpm::WallSettings& wall,
    const slideFrame& frame
) const
{
    if (frame.dimension() == 3)
    {
        for (const point& p : surface_.points())
        {
            wall.vertices.push_back(toMpm(p));
        }
        for (const labelledTri& t : surface_)
        {
            wall.triangles.push_back({{int(t[0]), int(t[1]), int(t[2])}});
        }
        return;
    }

    List<segment> segments(cut(frame));
    for (segment& s : segments)
    {
        if (s.first().x() > s.second().x())
        {
            Swap(s.first(), s.second());
        }
    }
    std::sort
    (
        segments.begin(),
        segments.end(),
        [](const segment& a, const segment& b)
        {
            return
                a.first().x() + a.second().x() < b.first().x() + b.second().x();
        }
    );

    // Shorter pieces are round-off; where there is no surface the line goes
    // straight on
    const scalar same =
        1e-6*mag(boundBox(surface_.points(), false).span());
    point last(vector::uniform(-GREAT));
    for (const segment& s : segments)
    {
        if (s.first().x() < last.x() - same)
        {
            FatalIOErrorInFunction(dict_)
                << "In the section " << what_.c_str() << " lies above itself at x = "
                << s.first().x() << ": a terrain has one height at a place."
                << " For a closed surface use type body"
                << exit(FatalIOError);
        }
        for (const point& p : s)
        {
            if (p.x() > last.x() + same)
            {
                wall.vertices.push_back(toMpm(p));
                last = p;
            }
        }
    }
}

// ************************************************************************* //
