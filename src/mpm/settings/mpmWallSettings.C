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

#include "mpmWallSettings.H"
#include "mpmNames.H"

#include <cmath>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const std::vector<std::string>& mpm::WallSettings::types()
{
    static const std::vector<std::string> names
    {
        "plane", "terrain", "box", "levelSet"
    };
    return names;
}


const std::vector<std::string>& mpm::WallSettings::conditions()
{
    static const std::vector<std::string> names
    {
        "rough", "roller", "slip", "coulomb", "absorbing"
    };
    return names;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::WallSettings::validate(const int dimension) const
{
    const std::string wall("wall " + name + ": ");

    choose(wall + "type", type, types());
    choose(wall + "condition", condition, conditions());
    require
    (
        friction >= 0 && std::isfinite(friction),
        wall + "friction", friction, ">= 0 (tangent of the friction angle)"
    );
    require
    (
        adhesion >= 0 && std::isfinite(adhesion),
        wall + "adhesion", adhesion, ">= 0 [Pa]"
    );
    require
    (
        adhesion == 0 || condition == "coulomb",
        wall + "adhesion", adhesion, "0 unless the condition is coulomb"
    );

    if (type == "plane")
    {
        double square = 0;
        for (int d = 0; d < dimension; ++d)
        {
            square += normal[d]*normal[d];
        }
        require
        (
            square > 0 && std::isfinite(square),
            wall + "normal (square of its length)", square, "> 0"
        );
        return;
    }

    if (type != "terrain")
    {
        for (int d = 0; d < dimension; ++d)
        {
            require
            (
                upper[d] > lower[d] && std::isfinite(upper[d] - lower[d]),
                wall + "extent of the box", upper[d] - lower[d], "> 0 [m]"
            );
        }
        require
        (
            type == "box" || (spacing > 0 && std::isfinite(spacing)),
            wall + "spacing of the samples", spacing, "> 0 [m]"
        );
        return;
    }

    const std::size_t least = dimension;
    require
    (
        vertices.size() >= least,
        wall + "number of vertices", double(vertices.size()),
        dimension == 2 ? ">= 2" : ">= 3"
    );
    for (const Point3& v : vertices)
    {
        for (int d = 0; d < dimension; ++d)
        {
            require(std::isfinite(v[d]), wall + "vertex", v[d], "finite");
        }
    }
    if (dimension == 3)
    {
        require
        (
            !triangles.empty(),
            wall + "number of triangles", double(triangles.size()), ">= 1"
        );
        for (const std::array<int, 3>& t : triangles)
        {
            for (const int i : t)
            {
                require
                (
                    i >= 0 && std::size_t(i) < vertices.size(),
                    wall + "vertex of a triangle", i,
                    "0 .. number of vertices - 1"
                );
            }
        }
    }
}


// ************************************************************************* //
