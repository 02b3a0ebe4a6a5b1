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

#include "mpmGather.H"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- As many points as a Lanes has
struct Points
{
    std::int32_t index[mpm::laneCount];

    //- From a first one on
    explicit Points(const std::int32_t first)
    {
        std::iota(index, index + mpm::laneCount, first);
    }
};


//- Those that follow each other, the same with one of them elsewhere, in
//  falling order, and a last one that is repeated
std::vector<Points> orders()
{
    std::vector<Points> all{Points(3)};
    for (int l = 0; l < mpm::laneCount; ++l)
    {
        all.emplace_back(3);
        all.back().index[l] = 1;
    }
    all.emplace_back(3);
    std::reverse(all.back().index, all.back().index + mpm::laneCount);
    all.emplace_back(3);
    all.back().index[mpm::laneCount - 1] =
        all.back().index[mpm::laneCount - 2];
    return all;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * Test Cases  * * * * * * * * * * * * * * * //

TEST_CASE("gather: consecutive points are known from others")
{
    const std::vector<Points> all = orders();
    CHECK(mpm::areConsecutive(all[0].index));
    for (std::size_t i = 1; i < all.size(); ++i)
    {
        CAPTURE(i);
        CHECK_FALSE(mpm::areConsecutive(all[i].index));
    }
}


TEST_CASE("gather, scatter: each point has its own entry, others stay")
{
    std::vector<double> entries(3 + 2*mpm::laneCount);
    std::iota(entries.begin(), entries.end(), 100);

    for (const Points& points : orders())
    {
        const std::int32_t* p = points.index;
        const mpm::Lanes values = mpm::gather(p, entries);
        for (int l = 0; l < mpm::laneCount; ++l)
        {
            CHECK(values[l] == 100 + p[l]);
        }

        for (const int n : {1, mpm::laneCount - 1, mpm::laneCount})
        {
            std::vector<double> numbers(entries), wantedNumbers(entries);
            std::vector<std::uint8_t> flags(entries.size(), 9);
            std::vector<std::uint8_t> wantedFlags(flags);

            // True for every other lane
            mpm::Lanes sign(0.0);
            for (int l = 0; l < mpm::laneCount; ++l)
            {
                sign.v[l] = l % 2 ? 1 : -1;
            }
            for (int l = 0; l < n; ++l)
            {
                wantedNumbers[p[l]] = -values[l];
                wantedFlags[p[l]] = l % 2;
            }
            mpm::scatter(-values, p, n, numbers);
            mpm::scatter(sign > mpm::Lanes(0.0), p, n, flags);

            CHECK(numbers == wantedNumbers);
            CHECK(flags == wantedFlags);
        }
    }
}


// ************************************************************************* //
