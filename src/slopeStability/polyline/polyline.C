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

#include "polyline.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::polyline::polyline
(
    std::vector<point> points,
    const std::string& name
)
:
    points_(std::move(points)),
    steepest_(0)
{
    if (points_.size() < 2)
    {
        throw std::invalid_argument
        (
            "The " + name + " line has " + std::to_string(points_.size())
          + " points; at least 2 are needed"
        );
    }

    for (const point& p : points_)
    {
        if (!p.allFinite())
        {
            throw std::invalid_argument
            (
                "The " + name + " line has a point that is not finite"
            );
        }
    }

    for (std::size_t i = 1; i < points_.size(); ++i)
    {
        if (points_[i].x() <= points_[i - 1].x())
        {
            throw std::invalid_argument
            (
                "The " + name + " line must have increasing x: point "
              + std::to_string(i) + " has x = "
              + std::to_string(points_[i].x()) + " after "
              + std::to_string(points_[i - 1].x())
              + " (a vertical or overhanging line is no function of x)"
            );
        }
        steepest_ = std::max(steepest_, std::abs(slope(i - 1)));
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

std::size_t slopeStability::polyline::segment(const double x) const
{
    const auto after = std::upper_bound
    (
        points_.begin() + 1,
        points_.end() - 1,
        x,
        [](const double value, const point& p) { return value < p.x(); }
    );

    return std::size_t(after - points_.begin()) - 1;
}


double slopeStability::polyline::y(const double x) const
{
    if (x <= xMin())
    {
        return points_.front().y();
    }
    if (x >= xMax())
    {
        return points_.back().y();
    }

    return y(x, segment(x));
}


double slopeStability::polyline::y
(
    const double x,
    const std::size_t segmenti
) const
{
    const point& a = points_[segmenti];
    const point& b = points_[segmenti + 1];
    const double w = (x - a.x())/(b.x() - a.x());

    return (1 - w)*a.y() + w*b.y();
}


double slopeStability::polyline::slope(const std::size_t segmenti) const
{
    const point d = points_[segmenti + 1] - points_[segmenti];
    return d.y()/d.x();
}


double slopeStability::polyline::distance
(
    const point& p,
    const double limit
) const
{
    double best = limit;

    for
    (
        std::size_t i = segment(p.x() - limit);
        i + 1 < points_.size() && points_[i].x() < p.x() + limit;
        ++i
    )
    {
        const point d = points_[i + 1] - points_[i];
        const double w = std::clamp
        (
            (p - points_[i]).dot(d)/d.squaredNorm(),
            0.0,
            1.0
        );
        best = std::min(best, (p - points_[i] - w*d).norm());
    }

    return best;
}


slopeStability::polyline slopeStability::polyline::mirrored() const
{
    std::vector<point> reversed(points_.rbegin(), points_.rend());
    for (point& p : reversed)
    {
        p.x() = -p.x();
    }

    return polyline(std::move(reversed), "mirrored");
}


// ************************************************************************* //
