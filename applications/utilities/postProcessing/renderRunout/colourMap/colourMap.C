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

#include "colourMap.H"

#include <map>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using runoutPicture::colour;

const std::map<std::string, std::vector<colour>>& table()
{
    static const std::map<std::string, std::vector<colour>> maps
    {
        {
            "viridis",
            {
                {68, 1, 84}, {71, 44, 122}, {59, 81, 139}, {44, 113, 142},
                {33, 144, 141}, {39, 173, 129}, {92, 200, 99}, {170, 220, 50},
                {253, 231, 37}
            }
        },
        {
            "inferno",
            {
                {0, 0, 4}, {31, 12, 72}, {85, 15, 109}, {136, 34, 106},
                {187, 55, 84}, {227, 89, 51}, {249, 140, 10}, {249, 201, 50},
                {252, 255, 164}
            }
        },
        {
            "strain",
            {
                {232, 222, 200}, {246, 205, 128}, {242, 158, 66},
                {221, 96, 42}, {172, 40, 40}, {110, 14, 46}, {56, 4, 40}
            }
        },
        {
            "blues",
            {
                {235, 243, 251}, {205, 224, 241}, {160, 203, 226},
                {107, 174, 214}, {58, 137, 193}, {24, 100, 170}, {8, 61, 126},
                {6, 34, 84}
            }
        },
        {
            "balance",
            {
                {24, 63, 122}, {50, 110, 175}, {110, 165, 210},
                {185, 212, 232}, {245, 245, 242}, {245, 205, 178},
                {229, 140, 105}, {198, 70, 60}, {128, 14, 38}
            }
        },
        {
            "earth",
            {
                {92, 108, 74}, {128, 141, 92}, {170, 174, 122},
                {205, 196, 150}, {214, 184, 144}, {197, 158, 124},
                {214, 194, 178}, {243, 238, 232}
            }
        },
        {
            "greys",
            {
                {238, 238, 238}, {190, 190, 190}, {140, 140, 140},
                {90, 90, 90}, {40, 40, 40}
            }
        }
    };

    return maps;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::colourMap::colourMap
(
    const std::string& name,
    const bool reversed
)
:
    colours_(nullptr),
    reversed_(reversed)
{
    const auto found = table().find(name);

    if (found == table().end())
    {
        std::string valid;
        for (const std::string& n : names())
        {
            valid += ' ' + n;
        }

        throw std::invalid_argument
        (
            "Unknown colour map " + name + "\n    Valid maps:" + valid
        );
    }

    colours_ = &found->second;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<std::string> runoutPicture::colourMap::names()
{
    std::vector<std::string> result;
    for (const auto& [name, colours] : table())
    {
        result.push_back(name);
    }
    return result;
}


runoutPicture::colour runoutPicture::colourMap::at(double fraction) const
{
    fraction = std::clamp(fraction, 0.0, 1.0);
    if (reversed_)
    {
        fraction = 1 - fraction;
    }

    const double place = fraction*(colours_->size() - 1);
    const auto low = std::min(std::size_t(place), colours_->size() - 2);
    const double share = place - low;

    colour mixed;
    for (int k = 0; k < 3; ++k)
    {
        mixed[k] = static_cast<unsigned char>
        (
            std::lround
            (
                (1 - share)*(*colours_)[low][k] + share*(*colours_)[low + 1][k]
            )
        );
    }
    return mixed;
}


// ************************************************************************* //
