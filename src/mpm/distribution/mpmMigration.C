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

#include "mpmMigration.H"

#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
mpm::Buffer mpm::Migration<Dim>::pack
(
    const std::vector<Traveller>& travellers
) const
{
    Buffer buffer;
    if (travellers.empty())
    {
        return buffer;
    }
    const std::uint64_t n = travellers.size();
    append(buffer, &n, 1);
    for (const Traveller& t : travellers)
    {
        append(buffer, &t.to, 1);
    }
    state_.cloud.forAll
    (
        [&](auto& a)
        {
            const bool given = !a.empty();
            append(buffer, &given, 1);
            for (std::size_t i = 0; given && i < travellers.size(); ++i)
            {
                append(buffer, &a[travellers[i].point], 1);
            }
        }
    );

    // The number of a law is this rank's own
    state_.cloud.forLaws
    (
        [&](auto& a)
        {
            for (std::size_t i = 0; !a.empty() && i < travellers.size(); ++i)
            {
                const LawTable::Law& law = state_.laws[a[travellers[i].point]];
                append(buffer, &law.zone, 1);
                append(buffer, &law.frictionAngle, 1);
            }
        }
    );
    return buffer;
}


template<int Dim>
void mpm::Migration<Dim>::unpack(const Buffer& buffer)
{
    if (buffer.empty())
    {
        return;
    }
    PointCloud<Dim>& cloud = state_.cloud;
    const std::size_t first = cloud.size();
    std::size_t at = 0;
    std::uint64_t n = 0;
    take(buffer, at, &n, 1);
    for (std::size_t i = first; i < first + n; ++i)
    {
        Traveller t;
        t.point = std::int32_t(i);
        take(buffer, at, &t.to, 1);
        here_.push_back(t);
    }
    cloud.forAll
    (
        [&](auto& a)
        {
            bool given = false;
            take(buffer, at, &given, 1);
            if (given)
            {
                a.resize(first + n);
                take(buffer, at, a.data() + first, n);
            }
        }
    );
    cloud.forLaws
    (
        [&](auto& a)
        {
            for (std::size_t i = first; i < a.size(); ++i)
            {
                int zone = 0;
                double frictionAngle = 0;
                take(buffer, at, &zone, 1);
                take(buffer, at, &frictionAngle, 1);
                a[i] = state_.laws.find(zone, frictionAngle);
            }
        }
    );
}


template<int Dim>
void mpm::Migration<Dim>::removeAway()
{
    std::vector<std::int32_t> gone;
    for (const auto& travellers : away_)
    {
        for (const Traveller& t : travellers)
        {
            gone.push_back(t.point);
        }
    }
    std::sort(gone.begin(), gone.end());

    // The last points move into the holes
    PointCloud<Dim>& cloud = state_.cloud;
    const std::int32_t n = std::int32_t(cloud.size());
    const std::int32_t left = n - std::int32_t(gone.size());
    std::vector<std::int32_t> place(gone.size(), -1);
    std::size_t hole = 0;
    for (std::int32_t p = left; p < n; ++p)
    {
        if (!std::binary_search(gone.begin(), gone.end(), p))
        {
            place[p - left] = gone[hole++];
        }
    }

    cloud.forAll
    (
        [&](auto& a)
        {
            for (std::int32_t p = left; p < n && !a.empty(); ++p)
            {
                if (place[p - left] >= 0)
                {
                    a[place[p - left]] = a[p];
                }
            }
            a.resize(a.empty() ? 0 : left);
        }
    );

    const auto renumber = [&](std::int32_t& p)
    {
        if (p >= left)
        {
            p = place[p - left];
        }
    };
    for (std::size_t b = 0; b < state_.grid.size(); ++b)
    {
        for (std::int32_t& p : state_.grid[b].points)
        {
            renumber(p);
        }
    }
    for (Traveller& t : here_)
    {
        renumber(t.point);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::Migration<Dim>::Migration(State<Dim>& state)
:
    state_(state),
    reach_(none),
    opens_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::Migration<Dim>::add(const std::int32_t point, const Coordinates& to)
{
    const Traveller traveller{point, to};
    Communicator& communicator = *state_.communicator;
    const int owner = state_.partition.owner(to);

    if (communicator.size() > 1 && !opens_)
    {
        const std::int32_t b = state_.grid.lookUp(to);
        const bool isKnown =
            b >= 0
         && (
                state_.grid[b].ghost
             || !state_.grid[b].points.empty()
             || state_.halo.isKnown(b)
            );
        opens_ =
            !isKnown
         && (
                owner != communicator.rank()
             || state_.halo.atBorder(state_.partition, owner, to)
            );
    }

    if (owner == communicator.rank())
    {
        here_.push_back(traveller);
        return;
    }
    away_.resize(communicator.size());
    away_[owner].push_back(traveller);

    const std::vector<int>& ranks = state_.halo.neighbours();
    reach_ = std::max
    (
        reach_,
        std::binary_search(ranks.begin(), ranks.end(), owner)
      ? neighbours
      : anywhere
    );
}


template<int Dim>
void mpm::Migration<Dim>::send(const Reach reach)
{
    if (reach == none)
    {
        return;
    }

    Communicator& communicator = *state_.communicator;
    away_.resize(communicator.size());
    std::vector<int> ranks(state_.halo.neighbours());
    if (reach == anywhere)
    {
        ranks.resize(communicator.size());
        std::iota(ranks.begin(), ranks.end(), 0);
    }
    std::vector<Buffer> sent;
    for (const int r : ranks)
    {
        sent.push_back(pack(away_[r]));
    }
    removeAway();
    away_.clear();

    const std::vector<Buffer> received
    (
        reach == anywhere
      ? communicator.allToAll(sent)
      : communicator.exchangeSized(ranks, sent)
    );
    for (const Buffer& buffer : received)
    {
        unpack(buffer);
    }
}


template<int Dim>
void mpm::Migration<Dim>::settle()
{
    const auto earlier = [this](const Traveller& a, const Traveller& b)
    {
        return state_.cloud.id[a.point] < state_.cloud.id[b.point];
    };
    if (!std::is_sorted(here_.begin(), here_.end(), earlier))
    {
        std::sort(here_.begin(), here_.end(), earlier);
    }
    settleInOrder();
}


template<int Dim>
void mpm::Migration<Dim>::settleInOrder()
{
    std::int32_t b = -1;
    for (const Traveller& t : here_)
    {
        if (b < 0 || state_.grid[b].at != t.to)
        {
            b = state_.grid.find(t.to);
        }
        state_.grid[b].points.push_back(t.point);
        state_.grid[b].wake();
    }
    here_.clear();
    state_.reports.resize(state_.grid.size());
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Migration<2>;
template class mpm::Migration<3>;


// ************************************************************************* //
