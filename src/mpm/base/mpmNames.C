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

#include "mpmNames.H"

#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::size_t mpm::choose
(
    const std::string& key,
    const std::string& name,
    const std::vector<std::string>& valid
)
{
    for (std::size_t i = 0; i < valid.size(); ++i)
    {
        if (valid[i] == name)
        {
            return i;
        }
    }

    std::ostringstream message;
    message << "Unknown " << key << " '" << name << "'. Valid names:";
    for (const std::string& v : valid)
    {
        message << ' ' << v;
    }
    throw std::invalid_argument(message.str());
}


void mpm::outOfRange
(
    const std::string& key,
    const double value,
    const std::string& range
)
{
    std::ostringstream message;
    message.precision(12);
    message << key << " = " << value << " is not allowed: " << range;
    throw std::invalid_argument(message.str());
}


void mpm::requireSize
(
    const std::string& key,
    const std::size_t size,
    const std::size_t expected
)
{
    if (size != expected)
    {
        std::ostringstream message;
        message
            << key << " has " << size << " values for " << expected
            << " points";
        throw std::invalid_argument(message.str());
    }
}


// ************************************************************************* //
