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

#include "axisTicks.H"

#include <algorithm>
#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The shortest text that shows a number with the given decimals
std::string text(const double value, const int decimals)
{
    char buffer[64];

    if (std::abs(value) >= 1e6 || decimals > 5)
    {
        std::snprintf(buffer, sizeof(buffer), "%.3g", value);
    }
    else
    {
        std::snprintf(buffer, sizeof(buffer), "%.*f", decimals, value);
    }

    return buffer;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

double runoutPicture::tickStep
(
    const double low,
    const double high,
    const int wanted
)
{
    const double raw = (high - low)/std::max(1, wanted);
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));

    for (const double factor : {1.0, 2.0, 5.0})
    {
        if (raw <= factor*decade*(1 + 1e-9))
        {
            return factor*decade;
        }
    }

    return 10*decade;
}


std::vector<runoutPicture::axisTick> runoutPicture::linearTicks
(
    const double low,
    const double high,
    const int wanted
)
{
    const double step = tickStep(low, high, wanted);
    const int decimals = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));

    std::vector<axisTick> ticks;

    // The ends belong to the range whatever the rounding
    const double slack = 1e-6*step;
    const auto first = std::lround(std::ceil((low - slack)/step));
    const auto last = std::lround(std::floor((high + slack)/step));

    for (auto k = first; k <= last; ++k)
    {
        ticks.push_back({k*step, text(k*step, decimals)});
    }

    return ticks;
}


std::vector<runoutPicture::axisTick> runoutPicture::logarithmicTicks
(
    const double low,
    const double high
)
{
    const int first = int(std::floor(std::log10(low) - 1e-9));
    const int last = int(std::ceil(std::log10(high) + 1e-9));
    const bool dense = last - first <= 3;

    std::vector<axisTick> ticks;

    for (int power = first; power <= last; ++power)
    {
        for (const int factor : {1, 2, 5})
        {
            const double value = factor*std::pow(10.0, power);

            if
            (
                (factor == 1 || dense)
             && value >= low*(1 - 1e-9)
             && value <= high*(1 + 1e-9)
            )
            {
                ticks.push_back({value, text(value, std::max(0, -power))});
            }
        }
    }

    return ticks;
}


// ************************************************************************* //
