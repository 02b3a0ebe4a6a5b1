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

#include "oddDraw.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

oddDraw::oddDraw(const unsigned long long seed)
:
    engine_(seed),
    level_(plausibleCase)
{
    const double u = uniform();

    level_ =
        u < 0.4 ? plausibleCase
      : u < 0.7 ? odd
      : u < 0.88 ? absurd
      : invalid;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string oddDraw::levelName() const
{
    return
        std::vector<std::string>({"plausible", "odd", "absurd", "invalid"})
        [level_];
}


double oddDraw::uniform()
{
    // 53 bits: the standard's distributions differ between libraries
    return (engine_() >> 11)*std::pow(2.0, -53);
}


double oddDraw::between(const range& bounds)
{
    const double u = uniform();

    return
        bounds.first > 0
      ? bounds.first*std::pow(bounds.second/bounds.first, u)
      : bounds.first + u*(bounds.second - bounds.first);
}


double oddDraw::byLevel
(
    const range& plausibleBounds,
    const range& oddBounds,
    const range& absurdBounds
)
{
    return between
    (
        plausible() ? plausibleBounds
      : level_ == odd ? oddBounds
      : absurdBounds
    );
}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string text(const double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.4g", value);
    return buffer;
}

// ************************************************************************* //
