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
#include "mpmBinary.H"
#include "mpmSimulation.H"

#include <numeric>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::unpackLoads(const std::vector<double>& values)
{
    const double* next = values.data();
    const auto takeOut = [&next](auto& numbers)
    {
        std::copy_n(next, numbers.size(), numbers.begin());
        next += numbers.size();
    };
    for (WallLoad& load : loads_)
    {
        takeOut(load.impulse);
        takeOut(load.force);
        load.maxForce = *next++;
        load.maxForceTime = *next++;
    }
}


template<int Dim>
void mpm::Simulation<Dim>::readLaws(std::istream& is)
{
    std::vector<std::int32_t> zones;
    std::vector<double> angles;
    state_.communicator->agree
    (
        [&]()
        {
            if (!master())
            {
                return;
            }
            readBinary(is, zones);
            readBinary(is, angles);
            const std::size_t n = state_.laws.materials().size();
            for (const std::int32_t zone : zones)
            {
                if (zone < 0 || std::size_t(zone) >= n)
                {
                    throw std::runtime_error
                    (
                        "The saved run has a zone " + std::to_string(zone)
                      + " where " + std::to_string(n)
                      + " materials are given"
                    );
                }
            }
        }
    );

    Buffer buffer;
    append(buffer, zones.data(), zones.size());
    append(buffer, angles.data(), angles.size());
    state_.communicator->broadcast(buffer);
    const std::size_t n =
        buffer.size()/(sizeof(std::int32_t) + sizeof(double));
    zones.resize(n);
    angles.resize(n);
    std::size_t at = 0;
    take(buffer, at, zones.data(), n);
    take(buffer, at, angles.data(), n);

    LawTable laws(state_.laws.materials(), state_.settings.cellSize);
    for (std::size_t i = 0; i < n; ++i)
    {
        laws.find(zones[i], angles[i]);
    }
    state_.laws = laws;
}


template<int Dim>
std::vector<std::size_t> mpm::Simulation<Dim>::readBlocks(std::istream& is)
{
    typedef typename BlockGrid<Dim>::Coordinates Coordinates;
    typedef typename BlockGrid<Dim>::Rest Rest;

    Communicator& communicator = *state_.communicator;
    std::vector<char> bytes;
    communicator.agree
    (
        [&]()
        {
            if (master())
            {
                readBinary(is, bytes);
            }
        }
    );

    std::vector<Coordinates> places;
    std::vector<Rest> rests;
    std::vector<std::uint64_t> sizes;
    std::vector<Partition::Weight> weights;
    for (std::size_t at = 0; at < bytes.size();)
    {
        Coordinates place;
        Rest rest;
        std::uint64_t n = 0;
        take(bytes, at, &place, 1);
        take(bytes, at, &rest, 1);
        take(bytes, at, &n, 1);
        places.push_back(place);
        rests.push_back(rest);
        sizes.push_back(n);
        weights.push_back
        (
            {hilbertKey<Dim>(place), workOf(rest.asleep ? 0 : n)}
        );
    }
    state_.partition.cut(communicator, weights);

    std::vector<Buffer> sent(communicator.size());
    std::vector<std::size_t> shares(communicator.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const int owner = state_.partition.owner(places[i]);
        append(sent[owner], &places[i], 1);
        append(sent[owner], &rests[i], 1);
        append(sent[owner], &sizes[i], 1);
        shares[owner] += sizes[i];
    }
    const Buffer mine(communicator.allToAll(sent)[0]);

    state_.grid.rebuild({});
    std::int32_t next = 0;
    for (std::size_t at = 0; at < mine.size();)
    {
        Coordinates place;
        Rest rest;
        std::uint64_t n = 0;
        take(mine, at, &place, 1);
        take(mine, at, &rest, 1);
        take(mine, at, &n, 1);
        auto& block = state_.grid[state_.grid.find(place)];
        block.rest = rest;
        block.points.resize(n);
        std::iota(block.points.begin(), block.points.end(), next);
        next += std::int32_t(n);
    }
    return shares;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::restore(std::istream& is)
{
    Communicator& communicator = *state_.communicator;
    Clock clock{};
    std::vector<double> loads(packedLoads());
    communicator.agree
    (
        [&]()
        {
            if (!master())
            {
                return;
            }
            char magic[sizeof(magic_)];
            is.read(magic, sizeof(magic));
            if (!is || std::string(magic, sizeof(magic) - 1) != magic_)
            {
                throw std::runtime_error("This is not a saved run");
            }

            std::int32_t dim = 0;
            double cellSize = 0;
            std::uint64_t n = 0;
            readBinary(is, dim);
            readBinary(is, cellSize);
            readBinary(is, n);
            if
            (
                dim != Dim
             || cellSize != state_.settings.cellSize
             || n != nPoints_
            )
            {
                std::ostringstream message;
                message
                    << "The saved run has dimension " << dim << ", cells of "
                    << cellSize << " m and " << n << " points, this one "
                    << Dim << ", " << state_.settings.cellSize << " m and "
                    << nPoints_;
                throw std::runtime_error(message.str());
            }
            readBinary(is, clock);
            loads.clear();
            readBinary(is, loads);
            if (loads.size() != packedLoads().size())
            {
                throw std::runtime_error
                (
                    "The saved run has other walls whose load is recorded"
                );
            }
        }
    );

    // Counts of all ranks go on at the master
    Buffer bytes;
    append(bytes, &clock, 1);
    append(bytes, loads.data(), loads.size());
    communicator.broadcast(bytes);
    std::size_t at = 0;
    take(bytes, at, &clock, 1);
    take(bytes, at, loads.data(), loads.size());
    if (!master())
    {
        clock.clampedByWalls = clock.clampedByGrid = 0;
    }

    state_.sides.read(communicator, is);
    readLaws(is);
    const std::vector<std::size_t> shares(readBlocks(is));

    state_.cloud.forAll
    (
        [&](auto& a)
        {
            typedef typename std::remove_reference<decltype(a)>::type Array;
            std::vector<Buffer> sent(communicator.size());
            communicator.agree
            (
                [&]()
                {
                    if (!master())
                    {
                        return;
                    }
                    constexpr std::size_t one =
                        sizeof(typename Array::value_type);
                    std::uint64_t size = 0;
                    readBinary(is, size);
                    if (size != 0 && size != nPoints_*one)
                    {
                        throw std::runtime_error
                        (
                            "The saved run has an array of "
                          + std::to_string(size) + " bytes for "
                          + std::to_string(nPoints_) + " points"
                        );
                    }
                    for (std::size_t r = 0; size > 0 && r < sent.size(); ++r)
                    {
                        sent[r].resize(shares[r]*one);
                        readBytes(is, sent[r].data(), sent[r].size());
                    }
                }
            );
            const Buffer mine(communicator.allToAll(sent)[0]);
            a.resize(mine.size()/sizeof(typename Array::value_type));
            std::size_t at = 0;
            take(mine, at, a.data(), a.size());
        }
    );
    communicator.agree
    (
        [&]()
        {
            const PointCloud<Dim>& cloud = state_.cloud;
            const auto isGiven = [&cloud](const auto& array, const bool needed)
            {
                return array.size() == (needed ? cloud.size() : 0);
            };
            if
            (
                !isGiven
                (
                    cloud.leftCauchyGreen, state_.laws.needsDeformation()
                )
             || !isGiven(cloud.softeningStrain, state_.laws.nonlocal())
             || !isGiven(cloud.dilation, averagesDilation())
             || !isGiven(cloud.plasticWork, state_.settings.energyAccount)
            )
            {
                throw std::runtime_error
                (
                    "The saved run was made with other constitutive models, "
                    "another antiLocking or another energyAccount"
                );
            }
        }
    );
    state_.connect();

    // Masses are those of the saved points
    findSpeeds();
    clock_ = clock;
    state_.leastDensity = clock_.leastDensity;
    unpackLoads(loads);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::Simulation<Dim>::unpackLoads                            \
    (                                                                          \
        const std::vector<double>&                                             \
    );                                                                         \
    template void mpm::Simulation<Dim>::readLaws(std::istream&);               \
    template std::vector<std::size_t> mpm::Simulation<Dim>::readBlocks         \
    (                                                                          \
        std::istream&                                                          \
    );                                                                         \
    template void mpm::Simulation<Dim>::restore(std::istream&);

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
