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
#include "mpmNames.H"
#include "mpmPointTensor.H"
#include "mpmReduce.H"
#include "mpmSort.H"
#include "neoHookean.H"

#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
mpm::Vector<Dim> mpm::Simulation<Dim>::up(const Settings& settings)
{
    double square = 0;
    for (int d = 0; d < Dim; ++d)
    {
        square += settings.gravity[d]*settings.gravity[d];
    }

    Vector<Dim> u{};
    u[Dim - 1] = 1;
    for (int d = 0; square > 0 && d < Dim; ++d)
    {
        u[d] = -settings.gravity[d]/std::sqrt(square);
    }
    return u;
}


template<int Dim>
std::vector<mpm::Wall<Dim>> mpm::Simulation<Dim>::makeWalls
(
    const Settings& settings,
    const std::vector<WallSettings>& walls
)
{
    std::vector<Wall<Dim>> made;
    int nRecords = 0;

    // What absorbing sides push, other walls have to bear: they come first
    for (const bool absorbing : {true, false})
    {
        for (const WallSettings& wall : walls)
        {
            wall.validate(Dim);
            if ((wall.condition == "absorbing") == absorbing)
            {
                made.emplace_back
                (
                    wall, up(settings), wall.recordsLoad ? nRecords++ : -1
                );
            }
        }
    }
    if (settings.axisymmetric())
    {
        WallSettings axis;
        axis.name = "axis";
        axis.type = "plane";
        axis.condition = "roller";
        axis.point = {{0, 0, 0}};
        axis.normal = {{1, 0, 0}};
        made.emplace_back(axis, up(settings));
    }
    return made;
}


template<int Dim>
void mpm::Simulation<Dim>::findSpeeds()
{
    const PointCloud<Dim>& cloud = state_.cloud;

    enum { speed2Of, wave2Of, massOfPoint, lightness, nMaxima };
    std::vector<double> maxima(nMaxima, 0.0);
    ExactSum mass;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        double speed2 = 0;
        for (const double v : cloud.v[i])
        {
            speed2 += v*v;
        }
        const LawTable::Law& law = state_.laws[cloud.law[i]];
        const double stiffness =
            law.model == LawTable::Model::neoHookean
          ? neoHookeanStiffness
            (
                tensor(cloud.leftCauchyGreen[i]), law.soil.moduli
            )
          : law.stiffness;
        const double wave2 = stiffness*cloud.volume[i]/cloud.mass[i];

        maxima[speed2Of] = std::max(maxima[speed2Of], speed2);
        maxima[wave2Of] = std::max(maxima[wave2Of], wave2);
        maxima[massOfPoint] = std::max(maxima[massOfPoint], cloud.mass[i]);
        maxima[lightness] =
            std::max(maxima[lightness], cloud.volume[i]/cloud.mass[i]);
        mass.add(cloud.mass[i]);
    }

    std::vector<ExactSum> sums{mass};
    reduceExact(*state_.communicator, maxima, sums);
    clock_.speed2 = maxima[speed2Of];
    clock_.wave2 = maxima[wave2Of];
    clock_.leastDensity = state_.leastDensity = 1/maxima[lightness];
    state_.maxMass = maxima[massOfPoint];
    totalMass_ = sums[0].value();
}


template<int Dim>
double mpm::Simulation<Dim>::stableDeltaT() const
{
    const Settings& settings = state_.settings;
    const double deltaT =
        settings.cfl*settings.cellSize
       /(std::sqrt(clock_.wave2) + std::sqrt(clock_.speed2));

    return
        settings.maxDeltaT > 0 ? std::min(deltaT, settings.maxDeltaT) : deltaT;
}


template<int Dim>
void mpm::Simulation<Dim>::sort()
{
    sortPoints(state_, *cycle_);
    ++clock_.sorts;
}


template<int Dim>
typename mpm::Simulation<Dim>::Good mpm::Simulation<Dim>::keep() const
{
    std::ostringstream blocks;
    state_.grid.write(blocks);
    return Good{state_.cloud, blocks.str(), state_.partition, clock_, loads_};
}


template<int Dim>
void mpm::Simulation<Dim>::goBack(const Good& good)
{
    std::istringstream blocks(good.blocks);
    state_.grid.read(blocks);
    state_.cloud = good.cloud;
    state_.partition = good.partition;
    clock_ = good.clock;
    state_.leastDensity = clock_.leastDensity;
    loads_ = good.loads;
    state_.connect();
}


template<int Dim>
void mpm::Simulation<Dim>::halt()
{
    std::fill(state_.cloud.v.begin(), state_.cloud.v.end(), Vector<Dim>{});
    std::fill(state_.cloud.C.begin(), state_.cloud.C.end(), Tensor<Dim>{});
    clock_.speed2 = clock_.kineticEnergy = 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::Simulation<Dim>::Simulation
(
    const Settings& settings,
    const PointData& points,
    const std::vector<Material>& materials,
    const std::vector<WallSettings>& walls,
    const std::shared_ptr<Communicator>& communicator
)
:
    state_
    (
        (settings.validate(Dim), settings),
        [&settings]()
        {
            Vector<Dim> g;
            std::copy_n(settings.gravity.begin(), Dim, g.begin());
            return g;
        }(),
        [&settings]()
        {
            Vector<Dim> o;
            std::copy_n(settings.origin.begin(), Dim, o.begin());
            return o;
        }(),
        makeWalls(settings, walls),
        materials,
        communicator
    ),
    cycle_(Cycle<Dim>::New(settings)),
    nonlocalStrain_(NonlocalStrain<Dim>::New(settings, state_.laws)),
    clock_(),
    nPoints_(points.size()),
    totalMass_(0)
{
    points.validate(Dim, materials.size());
    clearLoads();

    // Each rank takes up an equal part, then gives each point to its owner
    const std::size_t rank = communicator->rank();
    const std::size_t nRanks = communicator->size();
    const std::size_t first = nPoints_*rank/nRanks;
    state_.cloud.assign(points, first, nPoints_*(rank + 1)/nRanks);
    if
    (
        settings.shapeFunction == "uGIMP" || settings.shapeFunction == "cpGIMP"
    )
    {
        state_.cloud.keepSize();
    }
    if (settings.axisymmetric())
    {
        communicator->agree([this]() { state_.cloud.turn(); });
    }

    communicator->agree
    (
        [&]()
        {
            for (std::size_t i = 0; i < state_.cloud.size(); ++i)
            {
                state_.cloud.law[i] = state_.laws.find
                (
                    points.zone[first + i],
                    points.frictionAngle.empty()
                  ? 0
                  : points.frictionAngle[first + i]
                );
            }
            if (state_.laws.needsDeformation())
            {
                refuseStressOfDeformation(ownField("sigma"));
            }
        }
    );
    if (state_.laws.needsDeformation())
    {
        state_.cloud.keepDeformation();
    }
    if (state_.laws.nonlocal())
    {
        state_.cloud.keepSofteningStrain();
    }
    if (averagesDilation())
    {
        state_.cloud.dilation.assign(state_.cloud.size(), 0);
    }
    if (settings.energyAccount)
    {
        account_ = std::make_unique<EnergyAccount<Dim>>();
        state_.cloud.plasticWork.assign(state_.cloud.size(), 0);
        state_.cloud.integrationWork.assign(state_.cloud.size(), 0);
    }

    findSpeeds();
    placePoints(state_, *cycle_);
    sort();
    measureSides();
    startAccount();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
double mpm::Simulation<Dim>::step(const double deltaTLimit)
{
    if (!(deltaTLimit > 0))
    {
        outOfRange("time step limit", deltaTLimit, "> 0 [s]");
    }
    if (clock_.step > 0 && clock_.step % state_.settings.sortInterval == 0)
    {
        sort();
    }

    clock_.deltaT = std::min(stableDeltaT(), deltaTLimit);
    if (nonlocalStrain_)
    {
        nonlocalStrain_->update(state_, clock_.step);
    }
    if (account_)
    {
        account_->begin(state_, *cycle_, clock_.deltaT);
    }
    cycle_->step(state_, clock_.deltaT);
    if (account_)
    {
        account_->end(state_, *cycle_, clock_.losses);
    }
    collectReports();

    clock_.time += clock_.deltaT;
    ++clock_.step;
    return clock_.deltaT;
}


template<int Dim>
void mpm::Simulation<Dim>::advance(const double endTime)
{
    if (!(endTime >= clock_.time))
    {
        std::ostringstream range;
        range << ">= the present time, " << clock_.time << " s";
        outOfRange("end time", endTime, range.str());
    }
    checkDuration("time to advance", endTime - clock_.time);

    const Good good(keep());
    try
    {
        while (clock_.time < endTime)
        {
            // The last two steps share what is left, so that none is tiny
            const double left = endTime - clock_.time;
            const double stable = stableDeltaT();
            const bool last = left <= stable;
            step(last || left >= 2*stable ? left : 0.5*left);
            if (last)
            {
                clock_.time = endTime;
            }
        }
    }
    catch (const std::runtime_error&)
    {
        goBack(good);
        throw;
    }
}


template<int Dim>
void mpm::Simulation<Dim>::useGenericKernels()
{
    cycle_ = Cycle<Dim>::NewGeneric(state_.settings);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Simulation<2>;
template class mpm::Simulation<3>;


// ************************************************************************* //
