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
#include <numeric>

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


template<int Dim>
struct ColumnPoint
{
    std::array<std::int64_t, Dim - 1> column;
    double height;
    double mass;
    std::int64_t id;
};


//- Weight above each point of whole columns, and half of that of its level,
//  over the area
template<int Dim>
std::vector<double> columnStress
(
    const std::vector<ColumnPoint<Dim>>& points,
    const double gravity,
    const double cellSize
)
{
    // Column by column from the top; ids decide between equal heights, so that
    // the order of the points does not matter
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(),
        order.end(),
        [&points](const std::size_t i, const std::size_t j)
        {
            const auto& a = points[i];
            const auto& b = points[j];
            return
                a.column != b.column ? a.column < b.column
              : a.height != b.height ? a.height > b.height
              : a.id < b.id;
        }
    );

    // Points of one level differ by round-off only
    const double level = 1e-6*cellSize;
    const double area = std::pow(cellSize, Dim - 1);
    std::vector<double> stress(points.size());
    double above = 0;
    for (std::size_t i = 0; i < order.size();)
    {
        const auto& top = points[order[i]];
        if (i > 0 && top.column != points[order[i - 1]].column)
        {
            above = 0;
        }
        double mass = 0;
        std::size_t end = i;
        while
        (
            end < order.size()
         && points[order[end]].column == top.column
         && top.height - points[order[end]].height <= level
        )
        {
            mass += points[order[end++]].mass;
        }
        for (; i < end; ++i)
        {
            stress[order[i]] = gravity*(above + 0.5*mass)/area;
        }
        above += mass;
    }
    return stress;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
std::vector<double> mpm::overburden
(
    Communicator& communicator,
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

    // All points of a column on one rank
    typedef ColumnPoint<Dim> Entry;
    const std::size_t nRanks = communicator.size();
    std::vector<Buffer> sent(nRanks);
    std::vector<std::size_t> rankOf(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        Entry entry{};
        std::uint64_t hash = 0;
        for (int a = 0; a < Dim - 1; ++a)
        {
            entry.column[a] =
                std::int64_t(std::floor(along(i, axes[a])/cellSize));
            hash += std::uint64_t(entry.column[a]);
        }
        entry.height = along(i, up);
        entry.mass = cloud.mass[i]/(axisymmetric ? cloud.x[i][0] : 1);
        entry.id = cloud.id[i];
        rankOf[i] = hash%nRanks;
        append(sent[rankOf[i]], &entry, 1);
    }

    std::vector<Entry> points;
    std::vector<std::size_t> end;
    for (const Buffer& buffer : communicator.allToAll(sent))
    {
        const std::size_t n = points.size();
        std::size_t at = 0;
        points.resize(n + buffer.size()/sizeof(Entry));
        take(buffer, at, points.data() + n, points.size() - n);
        end.push_back(points.size());
    }
    const std::vector<double> stress
    (
        columnStress(points, gravity, cellSize)
    );

    // And back
    std::size_t first = 0;
    for (std::size_t r = 0; r < nRanks; ++r)
    {
        sent[r].clear();
        append(sent[r], stress.data() + first, end[r] - first);
        first = end[r];
    }
    const std::vector<Buffer> received(communicator.allToAll(sent));
    std::vector<std::size_t> at(nRanks, 0);
    std::vector<double> result(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        take(received[rankOf[i]], at[rankOf[i]], &result[i], 1);
    }
    return result;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template std::vector<double> mpm::overburden<2>
(
    Communicator&,
    const PointCloud<2>&,
    const Vector<2>&,
    double,
    double,
    const Vector<2>&,
    bool
);

template std::vector<double> mpm::overburden<3>
(
    Communicator&,
    const PointCloud<3>&,
    const Vector<3>&,
    double,
    double,
    const Vector<3>&,
    bool
);


// ************************************************************************* //
