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

#include "colourScale.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::colourScale::colourScale
(
    const colourSettings& settings,
    const double dataLow,
    const double dataHigh
)
:
    settings_(settings),
    map_(settings.map.empty() ? "viridis" : settings.map, settings.reversed),
    low_(dataLow),
    high_(dataHigh),
    below_(false),
    above_(false)
{
    if (settings_.range)
    {
        low_ = (*settings_.range)[0];
        high_ = (*settings_.range)[1];
    }

    if (settings_.logarithmic && low_ <= 0)
    {
        throw std::invalid_argument
        (
            "A logarithmic scale cannot begin at " + std::to_string(low_)
          + "; give -range with two positive values"
        );
    }

    // A uniform field still needs a range
    if (!(high_ > low_))
    {
        const double around = std::max(1e-12, 1e-3*std::abs(low_));
        high_ = low_ + around;
        low_ -= settings_.logarithmic ? 0 : around;
    }

    const double slack = 1e-6*(high_ - low_);
    above_ = dataHigh > high_ + slack;
    below_ =
        dataLow < low_ - slack
     && !(settings_.hideBelow && *settings_.hideBelow >= low_ - slack);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double runoutPicture::colourScale::fraction(const double value) const
{
    if (settings_.logarithmic)
    {
        return
            value > 0 ? std::log(value/low_)/std::log(high_/low_) : -1;
    }

    return (value - low_)/(high_ - low_);
}


runoutPicture::colour
runoutPicture::colourScale::atFraction(const double fraction) const
{
    if (settings_.bands < 1)
    {
        return map_.at(fraction);
    }

    // The first and last band have the first and last colour
    const int n = settings_.bands;
    const int band = std::clamp(int(fraction*n), 0, n - 1);

    return map_.at(n > 1 ? double(band)/(n - 1) : 0.5);
}


runoutPicture::colour
runoutPicture::colourScale::at(const double value) const
{
    if
    (
        !std::isfinite(value)
     || (settings_.hideBelow && value < *settings_.hideBelow)
    )
    {
        return bare;
    }

    return atFraction(fraction(value));
}


std::vector<runoutPicture::axisTick>
runoutPicture::colourScale::ticks(const int wanted) const
{
    return
        settings_.logarithmic
      ? logarithmicTicks(low_, high_)
      : linearTicks(low_, high_, wanted);
}


// ************************************************************************* //
