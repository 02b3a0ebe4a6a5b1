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

#include "mpmBalance.H"
#include "mpmMigration.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::balance(State<Dim>& state)
{
    Communicator& communicator = *state.communicator;
    if (communicator.size() == 1)
    {
        return;
    }

    BlockGrid<Dim>& grid = state.grid;
    std::vector<Partition::Weight> weights;
    std::vector<double> largest(1, 0.0);
    for (std::size_t b = 0; b < grid.size(); ++b)
    {
        if (!grid[b].points.empty())
        {
            const double work = workOf
            (
                grid[b].rest.asleep ? 0 : grid[b].points.size()
            );
            weights.push_back({hilbertKey<Dim>(grid[b].at), work});
            largest[0] += work;
        }
    }
    std::vector<std::int64_t> total{std::int64_t(largest[0])};
    communicator.reduce(largest, total);

    const double mean = double(total[0])/communicator.size();
    state.imbalance = largest[0]/mean;
    if (state.imbalance <= state.settings.maxImbalance)
    {
        return;
    }

    // Whole blocks may not share out better
    const Partition before(state.partition);
    state.partition.cut(communicator, weights);
    if (state.partition == before)
    {
        return;
    }
    ++state.rebalances;

    // What blocks know of their rest goes with them
    std::vector<Buffer> rests(communicator.size());
    Migration<Dim> migration(state);
    for (std::size_t b = 0; b < grid.size(); ++b)
    {
        auto& block = grid[b];
        const int owner = state.partition.owner(block.at);
        if (owner != communicator.rank() && !block.points.empty())
        {
            append(rests[owner], &block.at, 1);
            append(rests[owner], &block.rest, 1);
            block.wake();
            for (const std::int32_t p : block.points)
            {
                migration.add(p, block.at);
            }
            block.points.clear();
        }
    }
    migration.send(Migration<Dim>::anywhere);
    migration.settleInOrder();
    for (const Buffer& buffer : communicator.allToAll(rests))
    {
        for (std::size_t at = 0; at < buffer.size();)
        {
            typename BlockGrid<Dim>::Coordinates place;
            take(buffer, at, &place, 1);
            take(buffer, at, &grid[grid.find(place)].rest, 1);
        }
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::balance(State<2>&);
template void mpm::balance(State<3>&);


// ************************************************************************* //
