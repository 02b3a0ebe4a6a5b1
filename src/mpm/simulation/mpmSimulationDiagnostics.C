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

#include "mpmEnergy.H"
#include "mpmNames.H"
#include "mpmReduce.H"
#include "mpmSimulation.H"

#include <algorithm>
#include <limits>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

template<int Dim, class Direction>
double along(const Vector<Dim>& x, const Direction& direction)
{
    double s = 0;
    for (int d = 0; d < Dim; ++d)
    {
        s += x[d]*direction[d];
    }
    return s;
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::startAccount()
{
    if (!account_)
    {
        return;
    }
    PointCloud<Dim>& cloud = state_.cloud;
    cloud.plasticWork.assign(cloud.size(), 0);
    cloud.integrationWork.assign(cloud.size(), 0);
    clock_.losses = EnergyLosses();
    Diagnostics now;
    addEnergies(now);
    clock_.startEnergy = now.storedEnergy();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::addEnergies(Diagnostics& result) const
{
    // Block by block in the order of the lists, then exactly
    const double cellSize = state_.settings.cellSize;
    const double secondMoment = cycle_->secondMoment()*cellSize*cellSize;

    const auto forNumbers = [](Diagnostics& d, const auto& f)
    {
        std::size_t i = 0;
        f(i++, d.mass);
        f(i++, d.volume);
        f(i++, d.kineticEnergy);
        f(i++, d.affineKineticEnergy);
        f(i++, d.elasticEnergy);
        f(i++, d.potentialEnergy);
        f(i++, d.plasticEnergy);
        f(i++, d.integrationEnergy);
        for (int c = 0; c < 3; ++c)
        {
            f(i++, d.momentum[c]);
            f(i++, d.angularMomentum[c]);
        }
        return i;
    };

    std::vector<ExactSum> sums
    (
        forNumbers(result, [](std::size_t, double&) {})
    );
    for (std::size_t b = 0; b < state_.grid.size(); ++b)
    {
        Diagnostics part;
        sumEnergies(state_, state_.grid[b].points, secondMoment, part);
        forNumbers
        (
            part,
            [&sums](const std::size_t i, const double x) { sums[i].add(x); }
        );
    }
    std::vector<double> nothing;
    reduceExact(*state_.communicator, nothing, sums);
    forNumbers
    (
        result,
        [&sums](const std::size_t i, double& x) { x = sums[i].value(); }
    );
    result.rmsVelocity = std::sqrt(2*result.kineticEnergy/result.mass);
}


template<int Dim>
double mpm::Simulation<Dim>::kthSmallest
(
    const std::vector<double>& values,
    const std::size_t k
) const
{
    Communicator& communicator = *state_.communicator;
    Buffer mine;
    append(mine, values.data(), values.size());

    Buffer chosen;
    std::vector<double> all;
    for (const Buffer& buffer : communicator.gather(mine))
    {
        const std::size_t n = all.size();
        std::size_t at = 0;
        all.resize(n + buffer.size()/sizeof(double));
        take(buffer, at, all.data() + n, all.size() - n);
    }
    if (communicator.master())
    {
        std::nth_element(all.begin(), all.begin() + k, all.end());
        append(chosen, &all[k], 1);
    }
    communicator.broadcast(chosen);
    double result = 0;
    std::size_t at = 0;
    take(chosen, at, &result, 1);
    return result;
}


template<int Dim>
void mpm::Simulation<Dim>::checkDuration
(
    const std::string& name,
    const double duration
) const
{
    // Days for the smallest run
    const double maxSteps = 1e8;
    const double deltaT = stableDeltaT();

    if (!(duration <= maxSteps*deltaT))
    {
        std::ostringstream range;
        range
            << "more than " << maxSteps << " time steps of " << deltaT
            << " s (cfl " << state_.settings.cfl << ", cellSize "
            << state_.settings.cellSize << " m, maxDeltaT "
            << state_.settings.maxDeltaT << " s, fastest wave "
            << std::sqrt(clock_.wave2) << " m/s)";
        outOfRange(name + " [s]", duration, range.str());
    }
}


template<int Dim>
mpm::Diagnostics mpm::Simulation<Dim>::diagnostics() const
{
    const Settings& settings = state_.settings;
    const PointCloud<Dim>& cloud = state_.cloud;
    const std::size_t n = cloud.size();

    Diagnostics result;
    result.time = clock_.time;
    result.deltaT = clock_.deltaT;
    result.step = long(clock_.step);
    result.sorts = long(clock_.sorts);
    result.imbalance = state_.imbalance;
    result.rebalances = long(state_.rebalances);
    addEnergies(result);

    if (account_)
    {
        result.energyAccount = true;
        result.frictionEnergy = clock_.losses.friction;
        result.impactEnergy = clock_.losses.impact;
        result.transferEnergy = clock_.losses.transfers;
        result.integrationEnergy += clock_.losses.integration;
        result.energyRemainder =
            clock_.startEnergy - result.storedEnergy() - result.lostEnergy();
    }

    // A tenth of a cell is more than a soil at rest creeps
    const double moved =
        settings.movedDistance > 0
      ? settings.movedDistance
      : 0.1*settings.cellSize;
    const Vector<Dim> upward = up(settings);

    enum { displacement, velocity, plasticStrain, crest, front, nMaxima };
    constexpr double lowest = -std::numeric_limits<double>::max();
    std::vector<double> maxima(nMaxima, 0.0);
    maxima[crest] = maxima[front] = lowest;

    enum
    {
        active, yielding, movedPoints, sleeping, byWalls, byGrid, blocks,
        bytes, idle, nSums
    };
    std::vector<std::int64_t> sums(nSums, 0);
    sums[byWalls] = clock_.clampedByWalls;
    sums[byGrid] = clock_.clampedByGrid;
    sums[blocks] = state_.grid.size();
    sums[bytes] = cloud.bytes() + state_.grid.bytes() + cycle_->bytes();
    sums[idle] = n == 0;
    for (std::size_t b = 0; b < state_.grid.size(); ++b)
    {
        const auto& block = state_.grid[b];
        sums[sleeping] += block.rest.asleep ? block.points.size() : 0;
    }

    std::vector<double> fronts;
    for (std::size_t i = 0; i < n; ++i)
    {
        const double u = std::sqrt
        (
            along<Dim>(cloud.displacement[i], cloud.displacement[i])
        );
        const double v = std::sqrt(along<Dim>(cloud.v[i], cloud.v[i]));
        maxima[displacement] = std::max(maxima[displacement], u);
        maxima[velocity] = std::max(maxima[velocity], v);
        maxima[plasticStrain] =
            std::max(maxima[plasticStrain], cloud.plasticStrain[i]);
        maxima[crest] =
            std::max(maxima[crest], along<Dim>(cloud.x[i], upward));
        sums[active] += v > settings.restVelocity;
        sums[yielding] += cloud.yielding[i];
        if (u > moved)
        {
            fronts.push_back(along<Dim>(cloud.x[i], settings.frontDirection));
            maxima[front] = std::max(maxima[front], fronts.back());
        }
    }
    sums[movedPoints] = fronts.size();
    state_.communicator->reduce(maxima, sums);

    result.maxDisplacement = maxima[displacement];
    result.maxVelocity = maxima[velocity];
    result.maxPlasticStrain = maxima[plasticStrain];
    result.crest = maxima[crest];
    result.activePoints = sums[active];
    result.yieldingPoints = sums[yielding];
    result.movedPoints = sums[movedPoints];
    result.sleepingPoints = sums[sleeping];
    result.clampedByWalls = sums[byWalls];
    result.clampedByGrid = sums[byGrid];
    result.activeBlocks = sums[blocks];
    result.bytesPerPoint = double(sums[bytes])/double(nPoints_);
    result.idleRanks = int(sums[idle]);
    if (result.movedPoints > 0)
    {
        result.front = maxima[front];
        result.front99 = kthSmallest
        (
            fronts, std::size_t(0.99*double(result.movedPoints - 1))
        );
    }

    return result;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::Simulation<Dim>::startAccount();                        \
    template void mpm::Simulation<Dim>::addEnergies(Diagnostics&) const;       \
    template void mpm::Simulation<Dim>::checkDuration                          \
    (                                                                          \
        const std::string&,                                                    \
        double                                                                 \
    ) const;                                                                   \
    template double mpm::Simulation<Dim>::kthSmallest                          \
    (                                                                          \
        const std::vector<double>&,                                            \
        std::size_t                                                            \
    ) const;                                                                   \
    template mpm::Diagnostics mpm::Simulation<Dim>::diagnostics() const;

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
