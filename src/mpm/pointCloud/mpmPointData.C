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

//- mpm::require of a quantity of a point; the message is made when needed
void requireOf
(
    const bool inside,
    const std::size_t i,
    const char* quantity,
    const double value,
    const char* range
)
{
    if (!inside)
    {
        mpm::outOfRange
        (
            "point " + std::to_string(i) + ": " + quantity, value, range
        );
    }
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
    optional("equivalentPlasticStrain", equivalentPlasticStrain.size());

    const auto finite = [](const double v, const std::size_t i, const char* q)
    {
        requireOf(std::isfinite(v), i, q, v, "finite");
    };

    const std::string zones("0 .. " + std::to_string(nMaterials - 1));
    for (std::size_t i = 0; i < n; ++i)
    {
        for (int d = 0; d < dimension; ++d)
        {
            finite(position[i][d], i, "position");
        }
        requireOf
        (
            volume[i] > 0 && std::isfinite(volume[i]),
            i, "volume", volume[i], "> 0 [m3]"
        );
        requireOf
        (
            rho[i] > 0 && std::isfinite(rho[i]),
            i, "rho", rho[i], "> 0 [kg/m3]"
        );
        requireOf
        (
            zone[i] >= 0 && std::size_t(zone[i]) < nMaterials,
            i, "zone", zone[i], zones.c_str()
        );
    }
    for (std::size_t i = 0; i < cohesionIntercept.size(); ++i)
    {
        finite(cohesionIntercept[i], i, "cohesionIntercept");
    }
    for (std::size_t i = 0; i < frictionAngle.size(); ++i)
    {
        requireOf
        (
            frictionAngle[i] >= 0 && frictionAngle[i] < 90,
            i, "frictionAngle", frictionAngle[i],
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
    for (std::size_t i = 0; i < equivalentPlasticStrain.size(); ++i)
    {
        const double strain = equivalentPlasticStrain[i];
        requireOf
        (
            strain >= 0 && std::isfinite(strain),
            i, "equivalentPlasticStrain", strain, ">= 0"
        );
    }
}


// ************************************************************************* //
