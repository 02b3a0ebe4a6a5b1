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

#include "mpmStartState.H"
#include "mpmNames.H"

#include <cmath>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const std::vector<std::string>& mpm::StartSettings::types()
{
    static const std::vector<std::string> names
    {
        "columnK0", "elasticGravity", "none", "given"
    };
    return names;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::StartSettings::validate(const std::size_t nPoints) const
{
    choose("initialState type", type, types());
    require
    (
        K0 <= 100 && std::isfinite(K0),
        "K0", K0, "0 to 100, or negative: 1 - sin(phi')"
    );
    require(elasticTime >= 0, "elasticTime", elasticTime, ">= 0 [s]");
    require
    (
        relaxationTime >= 0,
        "relaxationTime", relaxationTime, ">= 0 [s]"
    );
    require(restVelocity > 0, "restVelocity", restVelocity, "> 0 [m/s]");
    require(addedCohesion >= 0, "addedCohesion", addedCohesion, ">= 0 [Pa]");
    if (!stableCohesionIntercept.empty())
    {
        requireSize
        (
            "stableCohesionIntercept",
            stableCohesionIntercept.size(),
            nPoints
        );
    }
    if (!stableFrictionAngle.empty())
    {
        requireSize
        (
            "stableFrictionAngle",
            stableFrictionAngle.size(),
            nPoints
        );
    }
}


// ************************************************************************* //
