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

#include "meshTerrain.H"
#include "fvMesh.H"
#include "meshPointLocator.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::meshTerrain::inside
(
    const fvMesh& mesh,
    const slidePoints& points,
    const boolList& marked,
    const UList<point>& places
)
{
    const meshPointLocator locator(mesh, points.frame().toSpace(places)());

    labelList flags(places.size(), Zero);

    forAll(flags, i)
    {
        const label celli = locator.cells()[i];

        flags[i] = (celli != -1 && marked[celli]);
    }

    Pstream::listCombineGather(flags, maxEqOp<label>());
    Pstream::listCombineScatter(flags);

    boolList result(places.size());
    forAll(result, i)
    {
        result[i] = (flags[i] == 1);
    }

    return result;
}


void Foam::meshTerrain::makeColumns(const slidePoints& points)
{
    point low(vector::uniform(GREAT));
    point high(vector::uniform(-GREAT));

    for (const point& p : points.position())
    {
        low = min(low, p);
        high = max(high, p);
    }

    // In space a column a cell is enough: triangles cost more than pieces of a
    // line
    const scalar target =
        (up_ == vector::Y ? points.spacing() : points.cellSize());

    const auto nColumns =
        [&](const scalar length)
        {
            return 1 + max(label(1), label(length/target + 0.5));
        };

    const vector extent(high - low);

    nX_ = nColumns(extent.x());
    nY_ = (up_ == vector::Y ? 1 : nColumns(extent.y()));

    place_.setSize(nX_*nY_, Zero);
    found_.setSize(nX_*nY_, false);

    for (label j = 0; j < nY_; ++j)
    {
        for (label i = 0; i < nX_; ++i)
        {
            point& p = place_[j*nX_ + i];

            p.x() = low.x() + extent.x()*i/(nX_ - 1);
            if (up_ == vector::Z)
            {
                p.y() = low.y() + extent.y()*j/(nY_ - 1);
            }
        }
    }
}


void Foam::meshTerrain::search
(
    const fvMesh& mesh,
    const slidePoints& points,
    const boolList& marked,
    const side which
)
{
    // Halvings that bring half a spacing to a millionth of it
    const label nHalvings = 19;

    const scalar step = 0.5*points.spacing();
    const Pair<vector> limits(points.limits(mesh));
    const scalar bottom = limits.first()[up_];
    const label nSamples = 1 + label((limits.second()[up_] - bottom)/step);

    pointField samples(place_.size()*nSamples);
    forAll(place_, columni)
    {
        for (label k = 0; k < nSamples; ++k)
        {
            point& p = samples[columni*nSamples + k];

            p = place_[columni];
            p[up_] = bottom + (k + 0.5)*step;
        }
    }

    const boolList isIn(inside(mesh, points, marked, samples));

    // The heights between which the side lies
    scalarField in(place_.size(), Zero);
    scalarField out(place_.size(), Zero);
    const scalar outward = (which == TOP ? step : -step);

    forAll(place_, columni)
    {
        for (label n = 0; n < nSamples && !found_[columni]; ++n)
        {
            const label k = (which == TOP ? nSamples - 1 - n : n);

            if (isIn[columni*nSamples + k])
            {
                found_[columni] = true;
                in[columni] = samples[columni*nSamples + k][up_];
                out[columni] = in[columni] + outward;
            }
        }
    }

    for (label halving = 0; halving < nHalvings; ++halving)
    {
        forAll(place_, columni)
        {
            place_[columni][up_] = 0.5*(in[columni] + out[columni]);
        }

        const boolList middleIn(inside(mesh, points, marked, place_));

        forAll(place_, columni)
        {
            (middleIn[columni] ? in : out)[columni] = place_[columni][up_];
        }
    }

    forAll(place_, columni)
    {
        place_[columni][up_] = in[columni];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshTerrain::meshTerrain
(
    const fvMesh& mesh,
    const slidePoints& points,
    const boolList& marked,
    const side which
)
:
    up_(points.frame().vertical()),
    nX_(0),
    nY_(0),
    place_(),
    found_()
{
    makeColumns(points);
    search(mesh, points, marked, which);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshTerrain::fill(mpm::WallSettings& wall) const
{
    labelList vertexOf(place_.size(), -1);

    forAll(place_, columni)
    {
        if (found_[columni])
        {
            vertexOf[columni] = wall.vertices.size();
            wall.vertices.push_back
            ({{
                place_[columni].x(),
                place_[columni].y(),
                place_[columni].z()
            }});
        }
    }

    const auto addTriangle =
        [&](const label a, const label b, const label c)
        {
            if (vertexOf[a] != -1 && vertexOf[b] != -1 && vertexOf[c] != -1)
            {
                wall.triangles.push_back
                ({{int(vertexOf[a]), int(vertexOf[b]), int(vertexOf[c])}});
            }
        };

    for (label j = 0; j + 1 < nY_; ++j)
    {
        for (label i = 0; i + 1 < nX_; ++i)
        {
            const label a = j*nX_ + i;

            addTriangle(a, a + 1, a + nX_);
            addTriangle(a + 1, a + nX_ + 1, a + nX_);
        }
    }
}

// ************************************************************************* //
