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

#include "sandColumn.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::WallSettings wall
(
    const char* name,
    const int direction,
    const char* condition
)
{
    mpm::WallSettings w;
    w.name = name;
    w.normal = {{0, 0, 0}};
    w.normal[direction] = 1;
    w.condition = condition;
    return w;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

mpm::Settings sandColumn::settings
(
    const int dimension,
    const int cells,
    const int threads
)
{
    mpm::Settings s;
    s.cellSize = 1.0/cells;
    s.gravity[dimension - 1] = -9.81;
    s.threads = threads;
    return s;
}


mpm::PointData sandColumn::points
(
    const int dimension,
    const int cells,
    const int width
)
{
    mpm::PointData data;
    const double spacing = 0.5/cells;
    const int depth = dimension == 3 ? 2*cells : 1;
    for (int k = 0; k < depth; ++k)
    {
        for (int j = 0; j < 2*cells; ++j)
        {
            for (int i = 0; i < 2*cells*width; ++i)
            {
                data.position.push_back
                ({{
                    (i + 0.5)*spacing,
                    (j + 0.5)*spacing,
                    dimension == 3 ? (k + 0.5)*spacing : 0
                }});
            }
        }
    }
    const std::size_t n = data.position.size();
    data.volume.assign(n, std::pow(spacing, dimension));
    data.rho.assign(n, 2000);
    data.zone.assign(n, 0);
    data.frictionAngle.assign(n, 30);
    return data;
}


mpm::Material sandColumn::soil()
{
    mpm::Material material;
    material.E = 1e6;
    material.nu = 0.3;
    return material;
}


std::vector<mpm::WallSettings> sandColumn::walls(const int dimension)
{
    std::vector<mpm::WallSettings> all
    {
        wall("base", dimension - 1, "rough"), wall("back", 0, "roller")
    };
    if (dimension == 3)
    {
        all.push_back(wall("side", 1, "roller"));
    }
    return all;
}

// ************************************************************************* //
