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

#include "planPolyline.H"
#include "groundPlan.H"
#include "dictionary.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Twice the area of a triangle, positive if c is to the left of a to b
static scalar leftOf(const vector2D& a, const vector2D& b, const vector2D& c)
{
    return (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
}


//- A point is in a polygon or not further from it than a distance
static bool near
(
    const vector2D& point,
    const UList<vector2D>& polygon,
    const scalar distance
)
{
    bool inside = false;

    forAll(polygon, i)
    {
        const vector2D& a = polygon[i];
        const vector2D& b = polygon[polygon.fcIndex(i)];

        const vector2D side(b - a);
        const scalar share = ((point - a) & side)/max(magSqr(side), VSMALL);
        const vector2D nearest(a + min(max(share, scalar(0)), scalar(1))*side);

        if (mag(point - nearest) <= distance)
        {
            return true;
        }

        if
        (
            (a.y() > point.y()) != (b.y() > point.y())
         && (leftOf(a, b, point) > 0) == (b.y() > a.y())
        )
        {
            inside = !inside;
        }
    }

    return inside;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::planPolyline::checkOnGround
(
    const vector2D& point,
    const dictionary& dict,
    const groundPlan& plan
)
{
    // Beyond the rim by this share of a face's size is on the rim
    const scalar roundOff = 1e-6;

    bool found = false;

    for (label i = 0; i < plan.size() && !found; ++i)
    {
        found = near(point, plan.corners(i), roundOff*sqrt(plan.area(i)));
    }

    if (!returnReduce(found, orOp<bool>()))
    {
        FatalIOErrorInFunction(dict)
            << "points: " << point << " is not on the ground seen from above"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planPolyline::planPolyline
(
    const dictionary& dict,
    const groundPlan& plan
)
:
    points_(dict.get<List<vector2D>>("points"))
{
    if (points_.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "points: " << points_ << "; a line has two or more"
            << exit(FatalIOError);
    }

    scalar size = 0;
    for (const vector2D& point : points_)
    {
        checkOnGround(point, dict, plan);
        size = max(size, mag(point - points_[0]));
    }

    if (size <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "points: " << points_ << " are all the same"
            << exit(FatalIOError);
    }

    // In no direction that a mesh or a line is likely to have
    const scalar share = 1e-9;
    const vector2D aside(share*size*vector2D(0.8191, 0.5737));

    for (vector2D& point : points_)
    {
        point += aside;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::planPolyline::crossings
(
    const vector2D& from,
    const vector2D& to
) const
{
    label result = 0;

    for (label i = 1; i < points_.size(); ++i)
    {
        const vector2D& a = points_[i - 1];
        const vector2D& b = points_[i];

        const bool fromLeft = leftOf(a, b, from) > 0;

        if
        (
            fromLeft != (leftOf(a, b, to) > 0)
         && (leftOf(from, to, a) > 0) != (leftOf(from, to, b) > 0)
        )
        {
            result += fromLeft ? 1 : -1;
        }
    }

    return result;
}

// ************************************************************************* //
