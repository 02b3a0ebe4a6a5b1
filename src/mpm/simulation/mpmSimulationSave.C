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

#include "mpmBinary.H"
#include "mpmSimulation.H"
#include "mpmSort.H"

#include <set>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::commonLaws
(
    std::vector<std::pair<int, double>>& laws,
    std::vector<std::int32_t>& number
) const
{
    typedef std::pair<int, double> ZoneAndAngle;
    const auto lawOf = [this](const std::int32_t i)
    {
        return ZoneAndAngle(state_.laws[i].zone, state_.laws[i].frictionAngle);
    };

    std::set<ZoneAndAngle> own;
    for (const std::int32_t i : state_.cloud.law)
    {
        own.insert(lawOf(i));
    }

    Communicator& communicator = *state_.communicator;
    Buffer mine;
    for (const ZoneAndAngle& law : own)
    {
        append(mine, &law.first, 1);
        append(mine, &law.second, 1);
    }
    std::vector<Buffer> sent(communicator.size(), mine);
    std::set<ZoneAndAngle> all;
    for (const Buffer& buffer : communicator.allToAll(sent))
    {
        for (std::size_t at = 0; at < buffer.size();)
        {
            ZoneAndAngle law;
            take(buffer, at, &law.first, 1);
            take(buffer, at, &law.second, 1);
            all.insert(law);
        }
    }

    laws.assign(all.begin(), all.end());
    number.resize(state_.laws.size());
    for (std::size_t i = 0; i < number.size(); ++i)
    {
        number[i] = std::int32_t
        (
            std::lower_bound(laws.begin(), laws.end(), lawOf(i)) - laws.begin()
        );
    }
}


template<int Dim>
void mpm::Simulation<Dim>::writeBlocks
(
    std::ostream& os,
    const std::vector<std::int32_t>& blocks
) const
{
    Buffer mine;
    for (const std::int32_t b : blocks)
    {
        const auto& block = state_.grid[b];
        const std::uint64_t n = block.points.size();
        append(mine, &block.at, 1);
        append(mine, &block.rest, 1);
        append(mine, &n, 1);
    }

    // The ranks' pieces of the curve follow one another
    const std::vector<Buffer> all(state_.communicator->gather(mine));
    if (master())
    {
        std::vector<char> bytes;
        for (const Buffer& buffer : all)
        {
            bytes.insert(bytes.end(), buffer.begin(), buffer.end());
        }
        writeBinary(os, bytes);
    }
}


template<int Dim>
std::vector<double> mpm::Simulation<Dim>::packedLoads() const
{
    std::vector<double> values;
    for (const WallLoad& load : loads_)
    {
        values.insert(values.end(), load.impulse.begin(), load.impulse.end());
        values.insert(values.end(), load.force.begin(), load.force.end());
        values.push_back(load.maxForce);
        values.push_back(load.maxForceTime);
    }
    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::save(std::ostream& os) const
{
    Communicator& communicator = *state_.communicator;

    std::vector<double> nothing;
    std::vector<std::int64_t> clamped
    {
        std::int64_t(clock_.clampedByWalls),
        std::int64_t(clock_.clampedByGrid)
    };
    communicator.reduce(nothing, clamped);
    Clock clock(clock_);
    clock.clampedByWalls = clamped[0];
    clock.clampedByGrid = clamped[1];

    std::vector<std::pair<int, double>> laws;
    std::vector<std::int32_t> number;
    commonLaws(laws, number);

    if (master())
    {
        os.write(magic_, sizeof(magic_));
        writeBinary(os, std::int32_t(Dim));
        writeBinary(os, state_.settings.cellSize);
        writeBinary(os, std::uint64_t(nPoints_));
        writeBinary(os, clock);
        writeBinary(os, packedLoads());
        state_.sides.write(os);

        std::vector<std::int32_t> zones;
        std::vector<double> angles;
        for (const auto& law : laws)
        {
            zones.push_back(law.first);
            angles.push_back(law.second);
        }
        writeBinary(os, zones);
        writeBinary(os, angles);
    }

    const std::vector<std::int32_t> blocks(alongCurve(state_.grid));
    writeBlocks(os, blocks);

    PointCloud<Dim> cloud(state_.cloud);
    for (std::int32_t& law : cloud.law)
    {
        law = number[law];
    }
    cloud.forAll
    (
        [&](const auto& a)
        {
            Buffer mine;
            for (const std::int32_t b : blocks)
            {
                for (const std::int32_t p : state_.grid[b].points)
                {
                    append(mine, a.data() + p, a.empty() ? 0 : 1);
                }
            }
            const std::vector<Buffer> all(communicator.gather(mine));
            std::uint64_t size = 0;
            for (const Buffer& buffer : all)
            {
                size += buffer.size();
            }
            if (master())
            {
                writeBinary(os, size);
            }
            for (const Buffer& buffer : all)
            {
                os.write(buffer.data(), std::streamsize(buffer.size()));
            }
        }
    );

    communicator.agree
    (
        [&]()
        {
            if (master() && !os)
            {
                throw std::runtime_error("The run could not be written");
            }
        }
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::Simulation<Dim>::commonLaws                             \
    (                                                                          \
        std::vector<std::pair<int, double>>&,                                  \
        std::vector<std::int32_t>&                                             \
    ) const;                                                                   \
    template void mpm::Simulation<Dim>::writeBlocks                            \
    (                                                                          \
        std::ostream&,                                                         \
        const std::vector<std::int32_t>&                                       \
    ) const;                                                                   \
    template std::vector<double> mpm::Simulation<Dim>::packedLoads() const;    \
    template void mpm::Simulation<Dim>::save(std::ostream&) const;

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
