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

#include "bishop.H"
#include "morgensternPrice.H"
#include "spencer.H"

#include <stdexcept>

// * * * * * * * * * * * * * * Local Helpers  * * * * * * * * * * * * * * //

namespace
{

using maker = std::unique_ptr<slopeStability::stabilityMethod> (*)();

template<class Method>
std::unique_ptr<slopeStability::stabilityMethod> make()
{
    return std::make_unique<Method>();
}

struct entry
{
    const char* name;
    maker make;
};

//- The methods by name
const entry methods[] =
{
    {slopeStability::bishop::typeName, make<slopeStability::bishop>},
    {
        slopeStability::morgensternPrice::typeName,
        make<slopeStability::morgensternPrice>
    },
    {slopeStability::spencer::typeName, make<slopeStability::spencer>}
};

} // End anonymous namespace

// * * * * * * * * * * * * * * * Selectors  * * * * * * * * * * * * * * * //

std::unique_ptr<slopeStability::stabilityMethod>
slopeStability::stabilityMethod::New(const std::string& name)
{
    std::string valid;
    for (const entry& e : methods)
    {
        if (name == e.name)
        {
            return e.make();
        }
        valid += std::string(" ") + e.name;
    }

    throw std::invalid_argument
    (
        "Unknown method of slope stability \"" + name
      + "\". Valid methods:" + valid
    );
}


std::vector<std::string> slopeStability::stabilityMethod::names()
{
    std::vector<std::string> result;
    for (const entry& e : methods)
    {
        result.push_back(e.name);
    }

    return result;
}


// ************************************************************************* //
