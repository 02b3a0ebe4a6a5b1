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

#include "mpmPointData.H"
#include "mpmNames.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string pointKey(const std::size_t i, const char* quantity)
{
    return "point " + std::to_string(i) + ": " + quantity;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::PointData::validate
(
    const int dimension,
    const std::size_t nMaterials
) const
{
    const std::size_t n = size();
    require(n > 0, "number of points", 0, ">= 1");
    require(nMaterials > 0, "number of materials", 0, ">= 1");

    requireSize("volume", volume.size(), n);
    requireSize("rho", rho.size(), n);
    requireSize("zone", zone.size(), n);

    const auto optional = [n](const char* key, const std::size_t size)
    {
        if (size > 0)
        {
            requireSize(key, size, n);
        }
    };
    optional("cohesionIntercept", cohesionIntercept.size());
    optional("frictionAngle", frictionAngle.size());
    optional("porePressure", porePressure.size());
    optional("velocity", velocity.size());
    optional("sigma", sigma.size());

    const auto finite = [](const double v, const std::size_t i, const char* q)
    {
        require(std::isfinite(v), pointKey(i, q), v, "finite");
    };

    for (std::size_t i = 0; i < n; ++i)
    {
        for (int d = 0; d < dimension; ++d)
        {
            finite(position[i][d], i, "position");
        }
        require
        (
            volume[i] > 0 && std::isfinite(volume[i]),
            pointKey(i, "volume"), volume[i], "> 0 [m3]"
        );
        require
        (
            rho[i] > 0 && std::isfinite(rho[i]),
            pointKey(i, "rho"), rho[i], "> 0 [kg/m3]"
        );
        require
        (
            zone[i] >= 0 && std::size_t(zone[i]) < nMaterials,
            pointKey(i, "zone"), zone[i],
            "0 .. " + std::to_string(nMaterials - 1)
        );
    }
    for (std::size_t i = 0; i < cohesionIntercept.size(); ++i)
    {
        finite(cohesionIntercept[i], i, "cohesionIntercept");
    }
    for (std::size_t i = 0; i < frictionAngle.size(); ++i)
    {
        require
        (
            frictionAngle[i] >= 0 && frictionAngle[i] < 90,
            pointKey(i, "frictionAngle"), frictionAngle[i],
            "0 <= frictionAngle < 90 [deg]"
        );
    }
    for (std::size_t i = 0; i < porePressure.size(); ++i)
    {
        finite(porePressure[i], i, "porePressure");
    }
    for (std::size_t i = 0; i < velocity.size(); ++i)
    {
        for (int d = 0; d < dimension; ++d)
        {
            finite(velocity[i][d], i, "velocity");
        }
    }
    for (std::size_t i = 0; i < sigma.size(); ++i)
    {
        for (const double s : sigma[i])
        {
            finite(s, i, "sigma");
        }
    }
}


// ************************************************************************* //
