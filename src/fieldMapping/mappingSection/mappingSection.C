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

#include "mappingSection.H"
#include "readChecked.H"
#include "IOstreams.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mappingSection::setAxes(const vector& direction, const vector& g)
{
    // A direction within 1e-6 rad of the vertical has no usable horizontal part
    const scalar minHorizontal = 1e-6;

    if (mag(g) < VSMALL)
    {
        return false;
    }

    yAxis_ = -g/mag(g);

    const vector horizontal(direction - (direction & yAxis_)*yAxis_);

    if (mag(horizontal) <= minHorizontal*mag(direction))
    {
        return false;
    }

    xAxis_ = horizontal/mag(horizontal);
    normal_ = xAxis_ ^ yAxis_;

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mappingSection::mappingSection
(
    const point& origin,
    const vector& direction,
    const vector& g
)
:
    origin_(origin),
    xAxis_(Zero),
    yAxis_(Zero),
    normal_(Zero)
{
    if (!setAxes(direction, g))
    {
        FatalErrorInFunction
            << "A section needs a direction with a horizontal part and a"
            << " gravity that is not zero, but direction is " << direction
            << " and g is " << g
            << exit(FatalError);
    }
}


Foam::mappingSection::mappingSection(const dictionary& dict, const vector& g)
:
    origin_(checkKeys(dict, {"origin", "direction"}).get<point>("origin")),
    xAxis_(Zero),
    yAxis_(Zero),
    normal_(Zero)
{
    const vector direction(dict.get<vector>("direction"));

    if (!setAxes(direction, g))
    {
        FatalIOErrorInFunction(dict)
            << "direction " << direction << " has no horizontal part:"
            << " a section's direction is horizontal, g being " << g
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::mappingSection::toSpace(const vector2D& xy) const
{
    return origin_ + xy.x()*xAxis_ + xy.y()*yAxis_;
}


Foam::vector2D Foam::mappingSection::toSection(const point& p) const
{
    return vector2D((p - origin_) & xAxis_, (p - origin_) & yAxis_);
}


Foam::Pair<Foam::vector2D> Foam::mappingSection::limits
(
    const boundBox& bounds
) const
{
    vector2D low(GREAT, GREAT);
    vector2D high(-GREAT, -GREAT);

    const pointField corners(bounds.points());

    for (const point& corner : corners)
    {
        const vector2D xy(toSection(corner));

        low = vector2D(min(low.x(), xy.x()), min(low.y(), xy.y()));
        high = vector2D(max(high.x(), xy.x()), max(high.y(), xy.y()));
    }

    return Pair<vector2D>(low, high);
}

// ************************************************************************* //
