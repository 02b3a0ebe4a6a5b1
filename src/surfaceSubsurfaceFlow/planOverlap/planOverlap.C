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

#include "planOverlap.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The part of a convex polygon on one side of a line across an axis
static DynamicList<vector2D> clipped
(
    const UList<vector2D>& polygon,
    const direction axis,
    const scalar bound,
    const bool keepAbove
)
{
    DynamicList<vector2D> result(polygon.size() + 1);

    forAll(polygon, i)
    {
        const vector2D& from = polygon[i];
        const vector2D& to = polygon[polygon.fcIndex(i)];
        const bool fromInside = (from[axis] >= bound) == keepAbove;
        const bool toInside = (to[axis] >= bound) == keepAbove;

        if (fromInside)
        {
            result.append(from);
        }
        if (fromInside != toInside)
        {
            const scalar share =
                (bound - from[axis])/(to[axis] - from[axis]);

            result.append(from + share*(to - from));
        }
    }

    return result;
}


//- Area, positive if the corners run counter-clockwise
static scalar signedArea(const UList<vector2D>& polygon)
{
    scalar area = 0;

    for (label i = 2; i < polygon.size(); ++i)
    {
        const vector2D a(polygon[i - 1] - polygon[0]);
        const vector2D b(polygon[i] - polygon[0]);

        area += 0.5*(a.x()*b.y() - a.y()*b.x());
    }

    return area;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::planOverlap
(
    const UList<vector2D>& polygon,
    const vector2D& low,
    const vector2D& high
)
{
    // Signed triangles from the first corner add up to any polygon
    scalar area = 0;

    for (label i = 2; i < polygon.size(); ++i)
    {
        DynamicList<vector2D> part(4);
        part.append(polygon[0]);
        part.append(polygon[i - 1]);
        part.append(polygon[i]);

        for (const direction axis : {0, 1})
        {
            part = clipped(part, axis, low[axis], true);
            part = clipped(part, axis, high[axis], false);
        }

        area += signedArea(part);
    }

    return mag(area);
}

// ************************************************************************* //
