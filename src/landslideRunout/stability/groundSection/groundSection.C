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

#include "groundSection.H"
#include "emptyPolyPatch.H"
#include "fvMesh.H"
#include "ListOps.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::point Foam::groundSection::planePoint
(
    const fvMesh& mesh,
    const mappingSection& section
)
{
    // A direction across the plane within 1e-6 rad
    const scalar along = 1 - 1e-12;

    point origin(section.origin());

    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if
        (
            mesh.geometricD()[cmpt] == -1
         && mag(section.normal()[cmpt]) > along
        )
        {
            origin[cmpt] = mesh.bounds().centre()[cmpt];
        }
    }

    return origin;
}


void Foam::groundSection::cutPatch
(
    const polyPatch& patch,
    const point& origin,
    const Map<scalar>& depths,
    DynamicList<cut>& cuts
) const
{
    const pointField& points = patch.points();
    DynamicList<vector2D> ends;

    forAll(patch, facei)
    {
        const face& f = patch[facei];
        ends.clear();

        forAll(f, i)
        {
            const point& a = points[f[i]];
            const point& b = points[f.nextLabel(i)];
            const scalar da = (a - origin) & section_.normal();
            const scalar db = (b - origin) & section_.normal();

            if ((da < 0) != (db < 0))
            {
                // The same digits from both faces of an edge
                const point& low = (da < 0 ? a : b);
                const point& high = (da < 0 ? b : a);
                const scalar w = min(da, db)/(min(da, db) - max(da, db));

                ends.append(section_.toSection(low + w*(high - low)));
            }
        }

        std::sort
        (
            ends.begin(),
            ends.end(),
            [](const vector2D& a, const vector2D& b)
            {
                return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
            }
        );

        for (label i = 0; i + 1 < ends.size(); i += 2)
        {
            const auto depth = depths.cfind(patch.start() + facei);

            cut c;
            c[0] = ends[i].x();
            c[1] = ends[i].y();
            c[2] = ends[i + 1].x();
            c[3] = ends[i + 1].y();
            c[4] = depth.good() ? depth.val() : 0;
            cuts.append(c);
        }
    }
}


Foam::List<Foam::groundSection::cut> Foam::groundSection::gather
(
    const DynamicList<cut>& cuts
)
{
    List<List<cut>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = cuts;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    DynamicList<cut> joined;
    for (const List<cut>& part : all)
    {
        joined.append(part);
    }

    std::sort
    (
        joined.begin(),
        joined.end(),
        [](const cut& a, const cut& b)
        {
            return a[0] + a[2] < b[0] + b[2];
        }
    );

    return List<cut>(std::move(joined));
}


void Foam::groundSection::joinGround(const List<cut>& cuts)
{
    DynamicList<vector2D> line;
    DynamicList<vector2D> pond;

    for (const cut& c : cuts)
    {
        const vector2D from(c[0], c[1]);
        const vector2D to(c[2], c[3]);

        if (to.x() - from.x() <= tolerance_)
        {
            if (mag(to.y() - from.y()) > tolerance_)
            {
                FatalErrorInFunction
                    << "The ground is vertical at x = " << from.x()
                    << " of the section, from y = " << from.y() << " to "
                    << to.y()
                    << exit(FatalError);
            }
            continue;
        }

        if (line.empty())
        {
            line.append(from);
        }
        else if (mag(from.x() - line.last().x()) > tolerance_)
        {
            FatalErrorInFunction
                << "The ground "
                << (from.x() > line.last().x() ? "is interrupted" : "overhangs")
                << " in the section between x = "
                << min(from.x(), line.last().x()) << " and "
                << max(from.x(), line.last().x())
                << exit(FatalError);
        }

        line.append(to);
        pond.append(vector2D(0.5*(from.x() + to.x()), c[4]));
    }

    if (line.empty())
    {
        FatalErrorInFunction
            << "The section through " << section_.origin() << " along "
            << section_.xAxis() << " does not cut the ground"
            << exit(FatalError);
    }

    ground_ = withoutCollinear(line);
    pond_.transfer(pond);
}


void Foam::groundSection::joinBase(const List<cut>& cuts)
{
    const scalar first = ground_.first().x();
    const scalar last = ground_.last().x();

    DynamicList<scalar> x;
    for (const vector2D& p : ground_)
    {
        x.append(p.x());
    }
    for (const cut& c : cuts)
    {
        for (const scalar xi : {c[0], c[2]})
        {
            if (xi > first && xi < last)
            {
                x.append(xi);
            }
        }
    }
    sort(x);

    DynamicList<vector2D> line;
    for (const scalar xi : x)
    {
        if (line.size() && xi - line.last().x() <= tolerance_)
        {
            continue;
        }

        scalar lowest = GREAT;
        for (const cut& c : cuts)
        {
            if (xi >= c[0] - tolerance_ && xi <= c[2] + tolerance_)
            {
                const scalar length = c[2] - c[0];
                const scalar w =
                    length > tolerance_
                  ? min(max((xi - c[0])/length, scalar(0)), scalar(1))
                  : scalar(c[3] < c[1]);
                lowest = min(lowest, (1 - w)*c[1] + w*c[3]);
            }
        }

        if (lowest == GREAT)
        {
            FatalErrorInFunction
                << "No boundary of the mesh lies below the ground at x = "
                << xi << " of the section"
                << exit(FatalError);
        }
        line.append(vector2D(xi, lowest));
    }

    base_ = withoutCollinear(line);
}


Foam::List<Foam::vector2D> Foam::groundSection::withoutCollinear
(
    const UList<vector2D>& line
) const
{
    DynamicList<vector2D> kept;
    kept.append(line.first());

    // Keep the points up to which some point left out would be off the line
    label from = 0;
    for (label i = 2; i < line.size(); ++i)
    {
        const vector2D d(line[i] - line[from]);
        for (label j = from + 1; j < i; ++j)
        {
            const vector2D e(line[j] - line[from]);
            if (mag(d.x()*e.y() - d.y()*e.x()) > tolerance_*mag(d))
            {
                from = i - 1;
                kept.append(line[from]);
                break;
            }
        }
    }
    kept.append(line.last());

    return List<vector2D>(std::move(kept));
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::groundSection::groundSection
(
    const fvMesh& mesh,
    const mappingSection& section,
    const labelHashSet& groundPatches,
    const Map<scalar>& depths
)
:
    section_(section),
    tolerance_(1e-6*mesh.bounds().mag()),
    ground_(),
    base_(),
    pond_()
{
    const point origin(planePoint(mesh, section));

    DynamicList<cut> ground;
    DynamicList<cut> others;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (groundPatches.found(patch.index()))
        {
            cutPatch(patch, origin, depths, ground);
        }
        else if (!patch.coupled() && !isA<emptyPolyPatch>(patch))
        {
            cutPatch(patch, origin, depths, others);
        }
    }

    joinGround(gather(ground));
    joinBase(gather(others));
}

// ************************************************************************* //
