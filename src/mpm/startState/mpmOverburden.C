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

#include "mpmOverburden.H"

#include <algorithm>
#include <cmath>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Horizontal unit vectors
std::array<mpm::Vector<2>, 1> horizontal(const mpm::Vector<2>& up)
{
    return {{{{up[1], -up[0]}}}};
}


std::array<mpm::Vector<3>, 2> horizontal(const mpm::Vector<3>& up)
{
    // Across the coordinate direction least along up, and across both
    int least = 0;
    for (int d = 1; d < 3; ++d)
    {
        if (std::fabs(up[d]) < std::fabs(up[least]))
        {
            least = d;
        }
    }
    mpm::Vector<3> a{};
    double square = 0;
    for (int d = 0; d < 3; ++d)
    {
        a[d] = (d == least ? 1 : 0) - up[least]*up[d];
        square += a[d]*a[d];
    }
    for (double& c : a)
    {
        c /= std::sqrt(square);
    }
    const mpm::Vector<3> b
    {{
        up[1]*a[2] - up[2]*a[1],
        up[2]*a[0] - up[0]*a[2],
        up[0]*a[1] - up[1]*a[0]
    }};
    return {{a, b}};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
std::vector<double> mpm::overburden
(
    const PointCloud<Dim>& cloud,
    const Vector<Dim>& up,
    const double gravity,
    const double cellSize,
    const Vector<Dim>& origin,
    const bool axisymmetric
)
{
    const auto axes = horizontal(up);
    const auto along = [&](const std::size_t i, const Vector<Dim>& axis)
    {
        double s = 0;
        for (int d = 0; d < Dim; ++d)
        {
            s += (cloud.x[i][d] - origin[d])*axis[d];
        }
        return s;
    };

    typedef std::pair<double, std::size_t> HeightAndPoint;
    std::map<std::array<long, Dim - 1>, std::vector<HeightAndPoint>> columns;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        std::array<long, Dim - 1> column;
        for (int a = 0; a < Dim - 1; ++a)
        {
            column[a] = long(std::floor(along(i, axes[a])/cellSize));
        }
        columns[column].emplace_back(along(i, up), i);
    }

    // Points of one level differ by round-off only
    const double level = 1e-6*cellSize;
    const double area = std::pow(cellSize, Dim - 1);
    std::vector<double> stress(cloud.size());
    for (auto& column : columns)
    {
        std::vector<HeightAndPoint>& points = column.second;
        std::sort(points.rbegin(), points.rend());

        double above = 0;
        for (std::size_t i = 0; i < points.size();)
        {
            double mass = 0;
            std::size_t end = i;
            while
            (
                end < points.size()
             && points[i].first - points[end].first <= level
            )
            {
                const std::size_t p = points[end++].second;
                mass += cloud.mass[p]/(axisymmetric ? cloud.x[p][0] : 1);
            }
            for (; i < end; ++i)
            {
                stress[points[i].second] =
                    gravity*(above + 0.5*mass)/area;
            }
            above += mass;
        }
    }

    return stress;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template std::vector<double> mpm::overburden<2>
(
    const PointCloud<2>&,
    const Vector<2>&,
    double,
    double,
    const Vector<2>&,
    bool
);

template std::vector<double> mpm::overburden<3>
(
    const PointCloud<3>&,
    const Vector<3>&,
    double,
    double,
    const Vector<3>&,
    bool
);


// ************************************************************************* //
