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
#include "mpmSimulation.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

std::unique_ptr<mpm::Run> mpm::Run::New
(
    const int dimension,
    const Settings& settings,
    const PointData& points,
    const std::vector<Material>& materials,
    const std::vector<WallSettings>& walls,
    const std::shared_ptr<Communicator>& communicator
)
{
    // Refuses any other dimension
    settings.validate(dimension);

    if (dimension == 2)
    {
        return std::make_unique<Simulation<2>>
        (
            settings, points, materials, walls, communicator
        );
    }
    return std::make_unique<Simulation<3>>
    (
        settings, points, materials, walls, communicator
    );
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const std::vector<std::string>& mpm::Run::fields()
{
    static const std::vector<std::string> names
    {
        "position", "velocity", "displacement", "sigma", "cohesionIntercept",
        "frictionAngle", "porePressure", "rho", "mass", "volume", "zone",
        "equivalentPlasticStrain", "yielding"
    };
    return names;
}


int mpm::Run::nComponents(const std::string& name)
{
    // Three vectors, a symmetric tensor, then scalars
    constexpr std::size_t sigma = 3;
    const std::size_t i = choose("field", name, fields());
    return i < sigma ? 3 : i == sigma ? 6 : 1;
}


// ************************************************************************* //
