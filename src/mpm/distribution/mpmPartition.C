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

#include "mpmPartition.H"

#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- In the order of the curve, one weight a place
void merge(std::vector<mpm::Partition::Weight>& weights)
{
    typedef mpm::Partition::Weight Weight;

    std::sort
    (
        weights.begin(),
        weights.end(),
        [](const Weight& a, const Weight& b) { return a.key < b.key; }
    );
    std::size_t n = 0;
    for (const Weight& w : weights)
    {
        if (n > 0 && weights[n - 1].key == w.key)
        {
            // Works are whole numbers of points: their sums are exact
            weights[n - 1].work += w.work;
        }
        else
        {
            weights[n++] = w;
        }
    }
    weights.resize(n);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mpm::Partition::cut
(
    Communicator& communicator,
    const std::vector<Weight>& given
)
{
    const int nRanks = communicator.size();
    if (nRanks == 1)
    {
        return;
    }

    std::vector<Weight> weights(given);
    merge(weights);
    Buffer mine;
    append(mine, weights.data(), weights.size());
    const std::vector<Buffer> gathered(communicator.gather(mine));

    Buffer cuts;
    if (communicator.master())
    {
        std::vector<Weight> all;
        for (const Buffer& buffer : gathered)
        {
            const std::size_t n = all.size();
            std::size_t at = 0;
            all.resize(n + buffer.size()/sizeof(Weight));
            take(buffer, at, all.data() + n, all.size() - n);
        }
        merge(all);

        double total = 0;
        for (const Weight& w : all)
        {
            total += w.work;
        }

        // A piece starts at the block whose middle is beyond its share
        starts_.assign
        (
            nRanks - 1,
            std::numeric_limits<std::uint64_t>::max()
        );
        int rank = 1;
        double before = 0;
        for (const Weight& here : all)
        {
            while (rank < nRanks && before + 0.5*here.work > total*rank/nRanks)
            {
                starts_[rank - 1] = here.key;
                ++rank;
            }
            before += here.work;
        }
        append(cuts, starts_.data(), starts_.size());
    }

    communicator.broadcast(cuts);
    std::size_t at = 0;
    starts_.resize(nRanks - 1);
    take(cuts, at, starts_.data(), starts_.size());
}


// ************************************************************************* //
