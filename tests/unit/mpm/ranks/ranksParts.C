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

#include "mpmExactSum.H"
#include "mpmPartition.H"
#include "threadRanks.H"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("an exact sum has no rounding and no order")
{
    const auto sum = [](const std::vector<double>& terms)
    {
        mpm::ExactSum s;
        for (const double t : terms)
        {
            s.add(t);
        }
        return s.value();
    };
    const double tiny = std::numeric_limits<double>::denorm_min();
    const double huge = std::numeric_limits<double>::max();

    CHECK(sum({}) == 0);
    CHECK(sum({1e300, 1, -1e300}) == 1);
    CHECK(sum({-3, 1}) == -2);
    CHECK(sum({tiny, tiny, tiny}) == 3*tiny);
    CHECK(sum({huge, tiny, -huge}) == tiny);
    CHECK(sum({-huge, tiny, huge, -2*tiny}) == -tiny);
    CHECK(sum({0.1, 0.2, 0.3, -0.6}) == doctest::Approx(2.7755575615628914e-17));
    CHECK(std::isnan(sum({1, std::numeric_limits<double>::infinity()})));

    // Integers that a double holds exactly
    double integers = 0;
    std::vector<double> terms;
    for (int i = 0; i < 10000; ++i)
    {
        terms.push_back((i % 2 ? -1.0 : 1.0)*i*i*1234567);
        integers += terms.back();
    }
    CHECK(sum(terms) == integers);

    std::mt19937 generator(3);
    std::normal_distribution<double> number(0, 1);
    for (double& t : terms)
    {
        t = number(generator)*std::exp(20*number(generator));
    }
    const double one = sum(terms);
    std::shuffle(terms.begin(), terms.end(), generator);
    CHECK(sum(terms) == one);
}


TEST_CASE("the curve goes from block to block without a jump")
{
    const auto check = [](auto dimension, const int n)
    {
        constexpr int Dim = decltype(dimension)::value;
        typedef std::array<std::int32_t, Dim> Coordinates;

        // A cube that the curve enters, fills and leaves
        std::map<std::uint64_t, Coordinates> places;
        const int depth = Dim == 3 ? n : 1;
        for (int i = 0; i < n*n*depth; ++i)
        {
            Coordinates at;
            int rest = i;
            for (int d = 0; d < Dim; ++d)
            {
                at[d] = rest%n + 64;
                rest /= n;
            }
            places[mpm::hilbertKey<Dim>(at)] = at;
        }
        CHECK(places.size() == std::size_t(n*n*depth));
        CHECK(places.rbegin()->first - places.begin()->first + 1 == places.size());

        const Coordinates* last = nullptr;
        for (const auto& place : places)
        {
            int steps = 0;
            for (int d = 0; last && d < Dim; ++d)
            {
                steps += std::abs(place.second[d] - (*last)[d]);
            }
            CHECK(steps == (last ? 1 : 0));
            last = &place.second;
        }
    };
    check(std::integral_constant<int, 2>(), 16);
    check(std::integral_constant<int, 3>(), 8);
}


TEST_CASE("pieces of the curve have equal work, whoever knows the weights")
{
    const int nRanks = 3;
    const int n = 100;
    std::vector<std::vector<int>> owners(nRanks);
    threadRanks::run
    (
        nRanks,
        [&](const std::shared_ptr<mpm::Communicator>& ranks)
        {
            // Each rank knows a part of each weight
            std::vector<mpm::Partition::Weight> weights;
            for (std::uint64_t i = 0; i < n; ++i)
            {
                if (int(i) % nRanks != ranks->rank())
                {
                    weights.push_back({10*i, double(i)});
                }
            }
            mpm::Partition partition;
            partition.cut(*ranks, weights);
            for (std::uint64_t i = 0; i < n; ++i)
            {
                owners[ranks->rank()].push_back(partition.owner(10*i));
            }
        }
    );

    CHECK(owners[1] == owners[0]);
    CHECK(owners[2] == owners[0]);
    CHECK(std::is_sorted(owners[0].begin(), owners[0].end()));
    std::vector<double> work(nRanks, 0.0);
    for (int i = 0; i < n; ++i)
    {
        work[owners[0][i]] += 2*i;
    }
    for (const double w : work)
    {
        // Half of the heaviest block at either end
        CHECK(std::fabs(w - double(n*(n - 1))/nRanks) <= 2*n);
    }
}


TEST_CASE("more ranks than blocks: some have none")
{
    threadRanks::run
    (
        4,
        [&](const std::shared_ptr<mpm::Communicator>& ranks)
        {
            std::vector<mpm::Partition::Weight> weights;
            if (ranks->rank() == 2)
            {
                weights = {{5, 1}, {9, 1}};
            }
            mpm::Partition partition;
            partition.cut(*ranks, weights);
            if (partition.owner(5) == partition.owner(9))
            {
                throw std::logic_error("one rank has both blocks");
            }
        }
    );
}


TEST_CASE("an error of one rank is an error of all")
{
    std::vector<std::string> messages(3);
    threadRanks::run
    (
        3,
        [&](const std::shared_ptr<mpm::Communicator>& ranks)
        {
            try
            {
                ranks->agree
                (
                    [&]()
                    {
                        if (ranks->rank() > 0)
                        {
                            throw std::invalid_argument
                            (
                                "rank " + std::to_string(ranks->rank())
                            );
                        }
                    }
                );
            }
            catch (const std::invalid_argument& e)
            {
                messages[ranks->rank()] = e.what();
            }
        }
    );
    CHECK(messages == std::vector<std::string>(3, "rank 1"));
}


// ************************************************************************* //
