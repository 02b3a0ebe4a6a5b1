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

#include <numeric>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Blocks that hold points, and the block of each point
template<int Dim>
class Occupied
{
    typedef typename BlockGrid<Dim>::Coordinates Coordinates;

    struct Hash
    {
        std::size_t operator()(const Coordinates& at) const
        {
            std::size_t h = 0;
            for (const std::int32_t c : at)
            {
                // An odd multiplier of the golden ratio spreads the bits
                h = (h ^ std::uint32_t(c))*0x9e3779b97f4a7c15ull;
            }
            return h ^ (h >> 32);
        }
    };

    std::unordered_map<Coordinates, std::int32_t, Hash> index_;


public:

    std::vector<Coordinates> blocks;
    std::vector<std::int32_t> ofPoint;

    Occupied(const State<Dim>& state, const Cycle<Dim>& cycle)
    :
        ofPoint(state.cloud.size())
    {
        Coordinates last{};
        std::int32_t lastIndex = -1;
        for (std::size_t i = 0; i < ofPoint.size(); ++i)
        {
            Coordinates at;
            if (!cycle.blockOf(state.grid, state.cloud.x[i], at))
            {
                std::ostringstream message;
                message
                    << "point " << state.cloud.id[i] << " at (";
                for (const double x : state.cloud.x[i])
                {
                    message << ' ' << x;
                }
                message
                    << " ) is farther from the origin of the grid than "
                    << BlockGrid<Dim>::maxBlock << " blocks of "
                    << BlockGrid<Dim>::edge << " cells";
                throw std::invalid_argument(message.str());
            }

            if (lastIndex < 0 || at != last)
            {
                const auto entry =
                    index_.emplace(at, std::int32_t(blocks.size()));
                if (entry.second)
                {
                    blocks.push_back(at);
                }
                last = at;
                lastIndex = entry.first->second;
            }
            ofPoint[i] = lastIndex;
        }
    }

    //- Row by row; the position of each block in that order
    std::vector<std::int32_t> arrange()
    {
        std::vector<std::int32_t> order(blocks.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort
        (
            order.begin(),
            order.end(),
            [this](const std::int32_t a, const std::int32_t b)
            {
                return std::lexicographical_compare
                (
                    blocks[a].rbegin(), blocks[a].rend(),
                    blocks[b].rbegin(), blocks[b].rend()
                );
            }
        );

        std::vector<Coordinates> arranged(blocks.size());
        std::vector<std::int32_t> rank(blocks.size());
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            arranged[i] = blocks[order[i]];
            rank[order[i]] = std::int32_t(i);
        }
        blocks.swap(arranged);
        return rank;
    }
};


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

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::sortPoints(State<Dim>& state, const Cycle<Dim>& cycle)
{
    constexpr int nCells = BlockGrid<Dim>::nNodes;
    PointCloud<Dim>& cloud = state.cloud;
    const std::size_t n = cloud.size();

    Occupied<Dim> occupied(state, cycle);
    const std::vector<std::int32_t> rank = occupied.arrange();
    const std::size_t nBlocks = occupied.blocks.size();

    // Counting sort by block and cell; points of a cell keep their order
    std::vector<std::int32_t> key(n);
    std::vector<std::int32_t> start(nBlocks*nCells + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::int32_t block = rank[occupied.ofPoint[i]];
        key[i] =
            block*nCells
          + cellOf<Dim>(state.grid, cloud.x[i], occupied.blocks[block]);
        ++start[key[i] + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());

    std::vector<std::int32_t> first(nBlocks + 1);
    for (std::size_t b = 0; b <= nBlocks; ++b)
    {
        first[b] = start[b*nCells];
    }

    std::vector<std::int32_t> order(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        order[start[key[i]]++] = std::int32_t(i);
    }
    cloud.reorder(order);

    state.grid.rebuild(occupied.blocks);
    for (std::size_t b = 0; b < nBlocks; ++b)
    {
        auto& points =
            state.grid[state.grid.find(occupied.blocks[b])].points;
        points.resize(first[b + 1] - first[b]);
        std::iota(points.begin(), points.end(), first[b]);
    }
    state.reports.resize(state.grid.size());
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::sortPoints(State<2>&, const Cycle<2>&);
template void mpm::sortPoints(State<3>&, const Cycle<3>&);


// ************************************************************************* //
