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

#include "bodyDistance.H"
#include "slideFrame.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyDistance::bodyDistance
(
    const std::shared_ptr<const wallSurface>& surface,
    const slideFrame& frame
)
:
    surface_((surface->requireClosed(), surface)),
    search_(std::make_shared<const triSurfaceSearch>(surface_->surface())),
    frame_(frame),
    cut_(),
    bounds_(surface_->surface().points(), false)
{
    if (frame_.dimension() == 2)
    {
        cut_ = surface_->cut(frame_);
        bounds_ = boundBox();
        for (const wallSurface::segment& s : cut_)
        {
            bounds_.add(s.first());
            bounds_.add(s.second());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::bodyDistance::operator()(const mpm::Point3& x) const
{
    const point p(x[0], x[1], x[2]);
    const point place(frame_.toSpace(p));
    scalar distance = GREAT;

    if (frame_.dimension() == 2)
    {
        for (const wallSurface::segment& s : cut_)
        {
            distance = min
            (
                distance,
                linePointRef(s.first(), s.second()).nearestDist(p).distance()
            );
        }
    }
    else
    {
        distance = mag
        (
            search_->tree().findNearest(place, sqr(GREAT)).hitPoint() - place
        );
    }

    return
        search_->tree().getVolumeType(place) == volumeType::INSIDE
      ? -distance
      : distance;
}


void Foam::bodyDistance::fill(mpm::WallSettings& wall) const
{
    for (const wallSurface::segment& s : cut_)
    {
        wall.vertices.push_back(toMpm(s.first()));
        wall.vertices.push_back(toMpm(s.second()));
    }
    if (cut_.empty())
    {
        for (const point& p : surface_->surface().points())
        {
            wall.vertices.push_back(toMpm(p));
        }
    }
}

// ************************************************************************* //
