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

#include "mpmSimulation.H"
#include "mpmMigration.H"
#include "mpmReduce.H"

#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::clearLoads()
{
    loads_.clear();
    for (const Wall<Dim>& wall : state_.walls)
    {
        if (wall.record() >= 0)
        {
            loads_.emplace_back();
            loads_.back().wall = wall.name();
        }
    }
}


template<int Dim>
void mpm::Simulation<Dim>::addPushes(ExactSum* sums) const
{
    for (const BlockReport<Dim>& report : state_.reports)
    {
        for (const auto& push : report.pushes)
        {
            for (int d = 0; d < Dim; ++d)
            {
                sums[push.record*Dim + d].add(push.impulse[d]);
            }
        }
    }
}


template<int Dim>
void mpm::Simulation<Dim>::setLoads(const ExactSum* sums)
{
    for (WallLoad& load : loads_)
    {
        double square = 0;
        for (int d = 0; d < Dim; ++d, ++sums)
        {
            const double impulse = -sums->value();
            load.impulse[d] += impulse;
            load.force[d] = impulse/clock_.deltaT;
            square += load.force[d]*load.force[d];
        }
        if (square > load.maxForce*load.maxForce)
        {
            load.maxForce = std::sqrt(square);
            load.maxForceTime = clock_.time + clock_.deltaT;
        }
    }
}


template<int Dim>
void mpm::Simulation<Dim>::collectReports()
{
    Migration<Dim> migration(state_);
    enum { speed2, wave2, minusBroken, reach, opens, nMaxima };
    std::vector<double> maxima(nMaxima, 0.0);
    std::vector<ExactSum> sums(1 + Dim*loads_.size());
    const double noPoint = -double(nPoints_);
    std::int32_t broken = -1;
    maxima[minusBroken] = noPoint;

    const std::size_t nBlocks = state_.grid.size();
    for (std::size_t b = 0; b < nBlocks; ++b)
    {
        const BlockReport<Dim>& report = state_.reports[b];
        if (report.broken >= 0)
        {
            const double id = state_.cloud.id[report.broken];
            if (-id > maxima[minusBroken])
            {
                maxima[minusBroken] = -id;
                broken = report.broken;
            }
        }
        maxima[speed2] = std::max(maxima[speed2], report.speed2);
        maxima[wave2] = std::max(maxima[wave2], report.wave2);
        sums[0].add(report.kineticEnergy);
        clock_.clampedByWalls += report.clampedByWalls;
        clock_.clampedByGrid += report.clampedByGrid;
        for (const auto& leaving : report.leaving)
        {
            migration.add(leaving.point, leaving.to);
        }
    }
    addPushes(sums.data() + 1);
    maxima[reach] = migration.reach();
    maxima[opens] = migration.opens();
    const double mine = maxima[minusBroken];
    reduceExact(*state_.communicator, maxima, sums);

    if (maxima[minusBroken] > noPoint)
    {
        state_.communicator->agree
        (
            [&]()
            {
                if (mine == maxima[minusBroken])
                {
                    throw std::runtime_error(describeBroken(broken));
                }
            }
        );
    }
    clock_.speed2 = maxima[speed2];
    clock_.wave2 = maxima[wave2];
    clock_.kineticEnergy = sums[0].value();
    setLoads(sums.data() + 1);

    migration.send(typename Migration<Dim>::Reach(maxima[reach]));
    migration.settle();
    if (maxima[opens] > 0 || maxima[reach] == Migration<Dim>::anywhere)
    {
        state_.connect();
    }
}


template<int Dim>
std::string mpm::Simulation<Dim>::describeBroken(const std::int32_t p) const
{
    const PointCloud<Dim>& cloud = state_.cloud;
    const LawTable::Law& law = state_.laws[cloud.law[p]];

    std::ostringstream message;
    message
        << "point " << cloud.id[p] << " at (";
    for (const double x : cloud.x[p])
    {
        message << ' ' << x;
    }
    message
        << " ) of material " << state_.laws.materials()[law.zone].name
        <<  (
                cloud.volume[p] <= 0
              ? " was turned inside out"
              : " is not a number"
            )
        << " in step " << clock_.step + 1 << " after time " << clock_.time
        << " s (step length " << clock_.deltaT << " s, volume "
        << cloud.volume[p] << " m3)";
    return message.str();
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::Simulation<Dim>::clearLoads();                          \
    template void mpm::Simulation<Dim>::collectReports();

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
