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

#include "arcFamily.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Static Data  * * * * * * * * * * * * * * * //

namespace
{

//- Steepest inclination at the entry: near the vertical a slice has no width
const double steepestEntry = 85*M_PI/180;

//- Steepest rise at the exit. Passive failure leaves the ground at 45 deg -
//  phi/2 at most; steeper exits only meet the limit of m_alpha.
const double steepestExit = 60*M_PI/180;

//- Points of a surface at which its depth is looked at
const int nDepthPoints = 32;

//- Halvings of an interval of half angles: exact to 1e-12
const int nHalvings = 40;

} // End anonymous namespace

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool slopeStability::arcFamily::aboveBase(const slipArc& arc) const
{
    const polyline& base = section_.base();
    const std::vector<point>& points = base.points();
    const point& from = arc.entry();
    const point& to = arc.exit();
    const double tolerance = 1e-9*(to - from).norm();

    if
    (
        base.y(from.x()) > from.y() + tolerance
     || base.y(to.x()) > to.y() + tolerance
    )
    {
        return false;
    }

    // Nearest approach of the base to the centre; for a plane, to the chord
    const bool curved = arc.halfAngle() > 1e-6;
    const point centre = curved ? arc.centre() : point(from);
    const double radius = curved ? 1/arc.curvature() : 0;
    const point up(std::sin(arc.chordAngle()), std::cos(arc.chordAngle()));

    const std::size_t last = base.segment(to.x());
    for (std::size_t i = base.segment(from.x()); i <= last; ++i)
    {
        const double xa = std::max(points[i].x(), from.x());
        const double xb = std::min(points[i + 1].x(), to.x());
        if (xb <= xa)
        {
            continue;
        }
        const point a(xa, base.y(xa, i));
        const point b(xb, base.y(xb, i));

        if (curved)
        {
            const point d = b - a;
            const double w = std::clamp
            (
                (centre - a).dot(d)/d.squaredNorm(),
                0.0,
                1.0
            );
            if ((a + w*d - centre).norm() < radius - tolerance)
            {
                return false;
            }
        }
        else if
        (
            up.dot(a - from) > tolerance
         || up.dot(b - from) > tolerance
        )
        {
            return false;
        }
    }

    return true;
}


bool slopeStability::arcFamily::deepEnough(const slipArc& arc) const
{
    for (int i = 0; i < nDepthPoints; ++i)
    {
        const point p = arc.at((i + 0.5)/nDepthPoints);
        if
        (
            section_.ground().y(p.x()) - p.y() >= minDepth_
         && section_.ground().distance(p, minDepth_) >= minDepth_
        )
        {
            return true;
        }
    }

    return false;
}


template<class Property>
double slopeStability::arcFamily::changeOf
(
    const Property& property,
    const bool rising,
    const range& between
)
{
    double low = between.min;
    double high = between.max;

    for (int i = 0; i < nHalvings; ++i)
    {
        const double middle = 0.5*(low + high);
        if (property(middle) == rising)
        {
            high = middle;
        }
        else
        {
            low = middle;
        }
    }

    return rising ? high : low;
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::arcFamily::arcFamily
(
    const slopeSection& section,
    const double minDepth
)
:
    section_(section),
    minDepth_(minDepth)
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

std::optional<slopeStability::arcFamily::range>
slopeStability::arcFamily::admitted
(
    const double entryX,
    const double exitX
) const
{
    const polyline& ground = section_.ground();
    const point entry(entryX, ground.y(entryX));
    const point exit(exitX, ground.y(exitX));

    if (exitX <= entryX || exit.y() >= entry.y())
    {
        return std::nullopt;
    }

    const double fall = slipArc(entry, exit, 0).chordAngle();
    range result
    {
        0,
        std::min(steepestEntry - fall, steepestExit + fall)
    };

    // Under the points of the ground that lie below the chord
    const point up(std::sin(fall), std::cos(fall));
    for
    (
        std::size_t i = ground.segment(entryX) + 1;
        i < ground.points().size() && ground.points()[i].x() < exitX;
        ++i
    )
    {
        const point& p = ground.points()[i];
        if (p.x() > entryX && up.dot(p - entry) < 0)
        {
            result.min = std::max
            (
                result.min,
                slipArc::halfAngleThrough(entry, exit, p)
            );
        }
    }
    if (result.min >= result.max)
    {
        return std::nullopt;
    }

    const auto clear = [&](const double halfAngle)
    {
        return aboveBase(slipArc(entry, exit, halfAngle));
    };
    if (!clear(result.max))
    {
        if (!clear(result.min))
        {
            return std::nullopt;
        }
        result.max = changeOf(clear, false, result);
    }

    const auto deep = [&](const double halfAngle)
    {
        return deepEnough(slipArc(entry, exit, halfAngle));
    };
    if (!deep(result.min))
    {
        if (!deep(result.max))
        {
            return std::nullopt;
        }
        result.min = changeOf(deep, true, result);
    }

    return result;
}


std::optional<slopeStability::slipArc> slopeStability::arcFamily::arc
(
    const double entryX,
    const double exitX,
    const double deepness
) const
{
    const std::optional<range> halfAngles = admitted(entryX, exitX);
    if (!halfAngles)
    {
        return std::nullopt;
    }

    return slipArc
    (
        {entryX, section_.ground().y(entryX)},
        {exitX, section_.ground().y(exitX)},
        (1 - deepness)*halfAngles->min + deepness*halfAngles->max
    );
}


double slopeStability::arcFamily::depth(const slipArc& arc) const
{
    double deepest = 0;

    for (int i = 0; i < nDepthPoints; ++i)
    {
        const point p = arc.at((i + 0.5)/nDepthPoints);
        const double vertical = section_.ground().y(p.x()) - p.y();
        if (vertical > deepest)
        {
            deepest = std::max
            (
                deepest,
                section_.ground().distance(p, vertical)
            );
        }
    }

    return deepest;
}


// ************************************************************************* //
