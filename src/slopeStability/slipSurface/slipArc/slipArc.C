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

#include "slipArc.H"

#include <cmath>

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::slipArc::slipArc
(
    const point& entry,
    const point& exit,
    const double halfAngle
)
:
    entry_(entry),
    exit_(exit),
    halfAngle_(halfAngle),
    chord_((exit - entry).norm()),
    chordAngle_(std::atan2(entry.y() - exit.y(), exit.x() - entry.x()))
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

double slopeStability::slipArc::curvature() const
{
    return 2*std::sin(halfAngle_)/chord_;
}


slopeStability::point slopeStability::slipArc::centre() const
{
    const double radius = 1/curvature();
    const double alpha = inclination(0);

    return entry_ + radius*point(std::sin(alpha), std::cos(alpha));
}


slopeStability::point slopeStability::slipArc::at(const double fraction) const
{
    // The part of the chord to this point; sin(f x)/sin(x) -> f as x -> 0
    const double part =
        halfAngle_ > 1e-8
      ? std::sin(halfAngle_*fraction)/std::sin(halfAngle_)
      : fraction;
    const double fall = chordAngle_ + halfAngle_*(1 - fraction);

    return entry_ + chord_*part*point(std::cos(fall), -std::sin(fall));
}


double slopeStability::slipArc::halfAngleThrough
(
    const point& entry,
    const point& exit,
    const point& p
)
{
    // The angle at p over the chord is pi - half angle
    const point a = entry - p;
    const point b = exit - p;

    return std::atan2
    (
        std::abs(a.x()*b.y() - a.y()*b.x()),
        -a.dot(b)
    );
}


// ************************************************************************* //
