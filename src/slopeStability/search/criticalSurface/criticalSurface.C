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

#include "criticalSurface.H"
#include "searchDirection.H"

#include <cmath>
#include <stdexcept>

// * * * * * * * * * * * * * * Local Helpers  * * * * * * * * * * * * * * //

namespace
{

//- Stop unless a number of something is large enough
void checkCount(const char* name, const int value, const int least)
{
    if (value < least)
    {
        throw std::invalid_argument
        (
            "The search for the slip surface needs " + std::string(name)
          + " >= " + std::to_string(least) + ", not "
          + std::to_string(value)
        );
    }
}

//- Stop unless limits are in order
void checkLimits(const char* name, const double low, const double high)
{
    if (!(low < high))
    {
        throw std::invalid_argument
        (
            "The limits of the " + std::string(name)
          + " of the slip surface are in the wrong order: "
          + std::to_string(low) + " to " + std::to_string(high)
        );
    }
}

} // End anonymous namespace

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void slopeStability::searchSettings::check() const
{
    if (!(minDepth >= 0))
    {
        throw std::invalid_argument
        (
            "The minimum depth of the slip surface must be >= 0, not "
          + std::to_string(minDepth)
        );
    }
    checkLimits("entry", entryMin, entryMax);
    checkLimits("exit", exitMin, exitMax);
    checkCount("nSlices", nSlices, 5);
    checkCount("nPlaces", nPlaces, 2);
    checkCount("nDeepness", nDeepness, 2);
    checkCount("nStarts", nStarts, 1);
}


slopeStability::criticalSurface::criticalSurface
(
    const slopeSection& section,
    const searchSettings& settings
)
:
    section_(section),
    settings_(settings)
{
    settings_.check();
}


slopeStability::slipResult slopeStability::criticalSurface::find
(
    const stabilityMethod& method
) const
{
    slipResult best = searchDirection(section_, settings_, method).find();

    searchSettings reversed = settings_;
    reversed.entryMin = -settings_.entryMax;
    reversed.entryMax = -settings_.entryMin;
    reversed.exitMin = -settings_.exitMax;
    reversed.exitMax = -settings_.exitMin;

    slipResult other =
        searchDirection(section_.mirrored(), reversed, method).find();
    for (point* p : {&other.centre, &other.entry, &other.exit})
    {
        p->x() = -p->x();
    }

    if (other.found && (!best.found || other.FOS < best.FOS))
    {
        std::swap(best, other);
    }

    best.evaluated += other.evaluated;
    for (const auto& [reason, count] : other.refused)
    {
        best.refused[reason] += count;
    }

    return best;
}


// ************************************************************************* //
