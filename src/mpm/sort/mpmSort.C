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

#include "mpmSort.H"
#include "mpmBalance.H"
#include "mpmMigration.H"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Block of a point; throws if it is beyond the largest grid
template<int Dim>
typename BlockGrid<Dim>::Coordinates blockOf
(
    const State<Dim>& state,
    const Cycle<Dim>& cycle,
    const std::size_t i
)
{
    typename BlockGrid<Dim>::Coordinates at;
    if (!cycle.blockOf(state.grid, state.cloud.x[i], at))
    {
        std::ostringstream message;
        message << "point " << state.cloud.id[i] << " at (";
        for (const double x : state.cloud.x[i])
        {
            message << ' ' << x;
        }
        message
            << " ) is farther from the origin of the grid than "
            << BlockGrid<Dim>::maxBlock << " blocks of "
            << BlockGrid<Dim>::edge << " cells: its cellSize is "
            << state.settings.cellSize << " m";
        throw std::invalid_argument(message.str());
    }
    return at;
}


//- Cell of a point within its block
template<int Dim>
int cellOf
(
    const BlockGrid<Dim>& grid,
    const Vector<Dim>& x,
    const typename BlockGrid<Dim>::Coordinates& at
)
{
    constexpr int edge = BlockGrid<Dim>::edge;
    int cell = 0;
    for (int d = Dim - 1; d >= 0; --d)
    {
        // Orders memory only: any shape function may share it
        const double local = std::floor
        (
            (x[d] - grid.origin()[d])/grid.cellSize() - 0.5
        ) - double(edge)*at[d];
        cell = edge*cell + int(std::min(edge - 1.0, std::max(0.0, local)));
    }
    return cell;
}


//- Blocks with points
template<int Dim>
std::vector<std::int32_t> occupied(const BlockGrid<Dim>& grid)
{
    std::vector<std::int32_t> blocks;
    for (std::size_t b = 0; b < grid.size(); ++b)
    {
        if (!grid[b].points.empty())
        {
            blocks.push_back(std::int32_t(b));
        }
    }
    return blocks;
}


//- Points whose block is another one by a bit of round-off change lists
template<int Dim>
void moveStrays(State<Dim>& state, const Cycle<Dim>& cycle)
{
    Migration<Dim> migration(state);
    state.communicator->agree
    (
        [&]()
        {
            for (std::size_t b = 0; b < state.grid.size(); ++b)
            {
                auto& block = state.grid[b];
                std::size_t kept = 0;
                for (const std::int32_t p : block.points)
                {
                    const auto at = blockOf(state, cycle, p);
                    if (at == block.at)
                    {
                        block.points[kept++] = p;
                    }
                    else
                    {
                        migration.add(p, at);
                    }
                }
                block.points.resize(kept);
            }
        }
    );

    std::vector<double> reach{double(migration.reach())};
    std::vector<std::int64_t> nothing;
    state.communicator->reduce(reach, nothing);
    migration.send(typename Migration<Dim>::Reach(reach[0]));
    migration.settle();
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::placePoints(State<Dim>& state, const Cycle<Dim>& cycle)
{
    const std::size_t n = state.cloud.size();
    std::vector<typename BlockGrid<Dim>::Coordinates> at(n);
    state.communicator->agree
    (
        [&]()
        {
            for (std::size_t i = 0; i < n; ++i)
            {
                at[i] = blockOf(state, cycle, i);
            }
        }
    );

    if (state.communicator->size() > 1)
    {
        std::vector<Partition::Weight> weights;
        for (std::size_t i = 0; i < n; ++i)
        {
            if (i == 0 || at[i] != at[i - 1])
            {
                weights.push_back({hilbertKey<Dim>(at[i]), 0});
            }
            ++weights.back().work;
        }
        state.partition.cut(*state.communicator, weights);
    }

    Migration<Dim> migration(state);
    for (std::size_t i = 0; i < n; ++i)
    {
        migration.add(std::int32_t(i), at[i]);
    }
    if (state.communicator->size() > 1)
    {
        migration.send(Migration<Dim>::anywhere);
    }
    migration.settle();
}


template<int Dim>
std::vector<std::int32_t> mpm::alongCurve(const BlockGrid<Dim>& grid)
{
    std::vector<std::pair<std::uint64_t, std::int32_t>> places;
    for (const std::int32_t b : occupied(grid))
    {
        places.emplace_back(hilbertKey<Dim>(grid[b].at), b);
    }
    std::sort(places.begin(), places.end());

    std::vector<std::int32_t> blocks;
    for (const auto& place : places)
    {
        blocks.push_back(place.second);
    }
    return blocks;
}


template<int Dim>
void mpm::sortPoints(State<Dim>& state, const Cycle<Dim>& cycle)
{
    constexpr int nCells = BlockGrid<Dim>::nNodes;
    typedef typename BlockGrid<Dim>::Coordinates Coordinates;

    moveStrays(state, cycle);
    balance(state);

    // Counting sort by cell, block by block
    BlockGrid<Dim>& grid = state.grid;
    std::vector<std::int32_t> blocks(occupied(grid));
    std::sort
    (
        blocks.begin(),
        blocks.end(),
        [&grid](const std::int32_t a, const std::int32_t b)
        {
            return std::lexicographical_compare
            (
                grid[a].at.rbegin(), grid[a].at.rend(),
                grid[b].at.rbegin(), grid[b].at.rend()
            );
        }
    );
    std::vector<Coordinates> places;
    std::vector<std::int32_t> first;
    std::vector<std::int32_t> order(state.cloud.size());
    std::vector<std::int32_t> cells;
    std::int32_t n = 0;
    for (const std::int32_t b : blocks)
    {
        const auto& block = grid[b];
        std::array<std::int32_t, nCells + 1> start{};
        cells.clear();
        for (const std::int32_t p : block.points)
        {
            cells.push_back(cellOf<Dim>(grid, state.cloud.x[p], block.at));
            ++start[cells.back() + 1];
        }
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            order[n + start[cells[i]]++] = block.points[i];
        }
        places.push_back(block.at);
        first.push_back(n);
        n += std::int32_t(cells.size());
    }
    first.push_back(n);
    state.cloud.reorder(order);

    grid.rebuild(places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        auto& points = grid[grid.find(places[i])].points;
        points.resize(first[i + 1] - first[i]);
        std::iota(points.begin(), points.end(), first[i]);
    }
    state.connect();
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::placePoints(State<Dim>&, const Cycle<Dim>&);            \
    template void mpm::sortPoints(State<Dim>&, const Cycle<Dim>&);             \
    template std::vector<std::int32_t> mpm::alongCurve(const BlockGrid<Dim>&);

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
