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

#include "mpmHalo.H"

#include <unordered_set>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
typename mpm::Halo<Dim>::Coordinates mpm::Halo<Dim>::beside
(
    const Coordinates& at,
    int o
)
{
    Coordinates result(at);
    for (int d = 0; d < Dim; ++d)
    {
        result[d] += o%3 - 1;
        o /= 3;
    }
    return result;
}


template<int Dim>
void mpm::Halo<Dim>::markOverlap
(
    const int reach,
    int o,
    std::vector<char>& marked
)
{
    const int patchEdge = Grid::edge + reach;
    std::array<int, 3> first{{0, 0, 0}};
    std::array<int, 3> end{{1, 1, 1}};
    for (int d = 0; d < Dim; ++d)
    {
        const int step = o%3 - 1;
        first[d] = step > 0 ? Grid::edge : 0;
        end[d] = step < 0 ? reach : patchEdge;
        o /= 3;
    }

    for (int z = first[2]; z < end[2]; ++z)
    {
        for (int y = first[1]; y < end[1]; ++y)
        {
            for (int x = first[0]; x < end[0]; ++x)
            {
                marked[x + patchEdge*(y + patchEdge*z)] = 1;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
bool mpm::Halo<Dim>::atBorder
(
    const Partition& partition,
    const int rank,
    const Coordinates& at
)
{
    for (int o = 0; o < Grid::nBeside; ++o)
    {
        if (partition.owner(beside(at, o)) != rank)
        {
            return true;
        }
    }
    return false;
}


template<int Dim>
void mpm::Halo<Dim>::connect
(
    Communicator& communicator,
    const Partition& partition,
    Grid& grid
)
{
    const int nRanks = communicator.size();
    if (nRanks == 1)
    {
        return;
    }
    const int me = communicator.rank();

    for (std::size_t b = 0; b < grid.size(); ++b)
    {
        grid[b].ghost = false;
    }

    // Tell each rank of the blocks beside its piece
    border_.clear();
    std::vector<std::vector<std::int32_t>> mine(nRanks);
    for (std::size_t b = 0; b < grid.size(); ++b)
    {
        if (grid[b].points.empty())
        {
            continue;
        }
        for (int o = 0; o < Grid::nBeside; ++o)
        {
            // Most neighbours have points, which are mine
            const Coordinates at(beside(grid[b].at, o));
            const std::int32_t other = grid.lookUp(at);
            if (other >= 0 && !grid[other].points.empty())
            {
                continue;
            }
            const int r = partition.owner(at);
            if (r != me && (mine[r].empty() || mine[r].back() != int(b)))
            {
                mine[r].push_back(std::int32_t(b));
            }
            if (r != me && (border_.empty() || border_.back() != int(b)))
            {
                border_.push_back(std::int32_t(b));
            }
        }
    }

    std::vector<Buffer> sent(nRanks);
    for (int r = 0; r < nRanks; ++r)
    {
        for (const std::int32_t b : mine[r])
        {
            append(sent[r], &grid[b].at, 1);
        }
    }
    const std::vector<Buffer> received(communicator.allToAll(sent));

    neighbours_.clear();
    ranks_.clear();
    sentNodes_.clear();
    receivedNodes_.clear();
    sent_.clear();
    received_.clear();

    const int nPatchNodes = Grid::nPatchNodes(grid.reach());
    std::vector<char> marked(nPatchNodes);
    const auto takeMarked = [&marked, nPatchNodes]
    (
        const std::int32_t block,
        std::vector<std::int32_t>& nodes
    )
    {
        for (std::int32_t i = 0; i < nPatchNodes; ++i)
        {
            if (marked[i])
            {
                nodes.push_back(block*nPatchNodes + i);
            }
        }
    };

    for (int r = 0; r < nRanks; ++r)
    {
        if (r == me || (mine[r].empty() && received[r].empty()))
        {
            continue;
        }
        neighbours_.push_back(r);

        std::vector<Coordinates> theirs(received[r].size()/sizeof(Coordinates));
        std::size_t at = 0;
        take(received[r], at, theirs.data(), theirs.size());

        // Both sides go through both lists in the same order
        std::vector<std::int32_t> in;
        for (const Coordinates& their : theirs)
        {
            std::fill(marked.begin(), marked.end(), 0);
            bool touches = false;
            for (int o = 0; o < Grid::nBeside; ++o)
            {
                const std::int32_t b = grid.lookUp(beside(their, o));
                if (b >= 0 && !grid[b].points.empty())
                {
                    markOverlap(grid.reach(), o, marked);
                    touches = true;
                }
            }
            if (touches)
            {
                const std::int32_t ghost = grid.add(their);
                grid[ghost].ghost = true;
                takeMarked(ghost, in);
            }
        }

        std::unordered_set<std::uint64_t> known;
        for (const Coordinates& their : theirs)
        {
            known.insert(Grid::key(their));
        }
        std::vector<std::int32_t> out;
        for (const std::int32_t b : mine[r])
        {
            std::fill(marked.begin(), marked.end(), 0);
            for (int o = 0; o < Grid::nBeside; ++o)
            {
                if (known.count(Grid::key(beside(grid[b].at, o))))
                {
                    markOverlap(grid.reach(), o, marked);
                }
            }
            takeMarked(b, out);
        }

        if (!out.empty())
        {
            ranks_.push_back(r);
            sent_.emplace_back(out.size()*sizeof(Node));
            received_.emplace_back(in.size()*sizeof(Node));
            sentNodes_.push_back(std::move(out));
            receivedNodes_.push_back(std::move(in));
        }
    }
}


template<int Dim>
void mpm::Halo<Dim>::complete
(
    Communicator& communicator,
    const Grid& grid,
    typename Grid::NodeField& patches
)
{
    if (communicator.size() == 1)
    {
        return;
    }

    // A block that lost all its points has an old patch
    for (const std::int32_t b : border_)
    {
        if (grid[b].points.empty())
        {
            const int n = Grid::nPatchNodes(grid.reach());
            std::fill_n(patches.data() + std::size_t(b)*n, n, Node{});
        }
    }

    for (std::size_t i = 0; i < ranks_.size(); ++i)
    {
        char* to = sent_[i].data();
        for (const std::int32_t node : sentNodes_[i])
        {
            std::memcpy(to, &patches[node], sizeof(Node));
            to += sizeof(Node);
        }
    }

    communicator.exchange(ranks_, sent_, received_);

    for (std::size_t i = 0; i < ranks_.size(); ++i)
    {
        const char* from = received_[i].data();
        for (const std::int32_t node : receivedNodes_[i])
        {
            std::memcpy(&patches[node], from, sizeof(Node));
            from += sizeof(Node);
        }
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Halo<2>;
template class mpm::Halo<3>;


// ************************************************************************* //
