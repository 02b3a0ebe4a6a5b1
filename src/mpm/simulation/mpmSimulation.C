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
#include "mpmBinary.H"
#include "mpmNames.H"
#include "mpmPointTensor.H"
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
    for (const WallSettings& wall : walls)
    {
        wall.validate(Dim);
        made.emplace_back(wall, up(settings));
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

    clock_.speed2 = clock_.wave2 = 0;
    totalMass_ = 0;
    state_.maxMass = 0;
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

        clock_.speed2 = std::max(clock_.speed2, speed2);
        clock_.wave2 = std::max(clock_.wave2, wave2);
        state_.maxMass = std::max(state_.maxMass, cloud.mass[i]);
        totalMass_ += cloud.mass[i];
    }
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
void mpm::Simulation<Dim>::collectReports()
{
    clock_.speed2 = clock_.wave2 = clock_.kineticEnergy = 0;

    const std::size_t nBlocks = state_.grid.size();
    for (std::size_t b = 0; b < nBlocks; ++b)
    {
        const BlockReport<Dim>& report = state_.reports[b];
        if (report.broken >= 0)
        {
            stopAt(report.broken);
        }
        clock_.speed2 = std::max(clock_.speed2, report.speed2);
        clock_.wave2 = std::max(clock_.wave2, report.wave2);
        clock_.kineticEnergy += report.kineticEnergy;
        clock_.clampedByWalls += report.clampedByWalls;
        clock_.clampedByGrid += report.clampedByGrid;

        for (const auto& leaving : report.leaving)
        {
            const std::int32_t target = state_.grid.find(leaving.to);
            state_.grid[target].points.push_back(leaving.point);
        }
    }
    state_.reports.resize(state_.grid.size());
}


template<int Dim>
void mpm::Simulation<Dim>::stopAt(const std::int32_t p) const
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
    throw std::runtime_error(message.str());
}


template<int Dim>
typename mpm::Simulation<Dim>::Good mpm::Simulation<Dim>::keep() const
{
    std::ostringstream blocks;
    state_.grid.write(blocks);
    return Good{state_.cloud, blocks.str(), clock_};
}


template<int Dim>
void mpm::Simulation<Dim>::goBack(const Good& good)
{
    std::istringstream blocks(good.blocks);
    state_.grid.read(blocks);
    state_.reports.resize(state_.grid.size());
    state_.cloud = good.cloud;
    clock_ = good.clock;
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
    const std::vector<WallSettings>& walls
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
        materials
    ),
    cycle_(Cycle<Dim>::New(settings)),
    clock_(),
    totalMass_(0)
{
    points.validate(Dim, materials.size());
    state_.cloud.assign(points);
    if
    (
        settings.shapeFunction == "uGIMP" || settings.shapeFunction == "cpGIMP"
    )
    {
        state_.cloud.keepSize();
    }
    if (settings.axisymmetric())
    {
        state_.cloud.turn();
    }

    std::vector<double> angles(points.frictionAngle);
    angles.resize(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        state_.cloud.law[i] = state_.laws.find(points.zone[i], angles[i]);
    }
    if (state_.laws.needsDeformation())
    {
        refuseStressOfDeformation(field("sigma"));
        state_.cloud.keepDeformation();
    }

    findSpeeds();
    sort();
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
    cycle_->step(state_, clock_.deltaT);
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


template<int Dim>
void mpm::Simulation<Dim>::save(std::ostream& os) const
{
    static const char magic[] = "slideFoam mpm 2";
    os.write(magic, sizeof(magic));
    writeBinary(os, std::int32_t(Dim));
    writeBinary(os, state_.settings.cellSize);
    writeBinary(os, clock_);

    // Laws are made anew from zones and angles
    std::vector<std::int32_t> zones(state_.laws.size());
    std::vector<double> angles(state_.laws.size());
    for (std::size_t i = 0; i < state_.laws.size(); ++i)
    {
        zones[i] = state_.laws[i].zone;
        angles[i] = state_.laws[i].frictionAngle;
    }
    writeBinary(os, zones);
    writeBinary(os, angles);

    state_.cloud.write(os);
    state_.grid.write(os);
    if (!os)
    {
        throw std::runtime_error("The run could not be written");
    }
}


template<int Dim>
void mpm::Simulation<Dim>::restore(std::istream& is)
{
    char magic[sizeof("slideFoam mpm 2")];
    std::int32_t dim = 0;
    double cellSize = 0;
    is.read(magic, sizeof(magic));
    if (!is || std::string(magic, sizeof(magic) - 1) != "slideFoam mpm 2")
    {
        throw std::runtime_error("This is not a saved run");
    }
    readBinary(is, dim);
    readBinary(is, cellSize);
    if (dim != Dim || cellSize != state_.settings.cellSize)
    {
        std::ostringstream message;
        message
            << "The saved run has dimension " << dim << " and cells of "
            << cellSize << " m, this one " << Dim << " and "
            << state_.settings.cellSize << " m";
        throw std::runtime_error(message.str());
    }

    readBinary(is, clock_);
    std::vector<std::int32_t> zones;
    std::vector<double> angles;
    readBinary(is, zones);
    readBinary(is, angles);
    LawTable laws(state_.laws.materials(), state_.settings.cellSize);
    for (std::size_t i = 0; i < zones.size(); ++i)
    {
        if
        (
            zones[i] < 0
         || std::size_t(zones[i]) >= laws.materials().size()
        )
        {
            throw std::runtime_error
            (
                "The saved run has a zone " + std::to_string(zones[i])
              + " where " + std::to_string(laws.materials().size())
              + " materials are given"
            );
        }
        laws.find(zones[i], angles[i]);
    }
    state_.laws = laws;
    state_.cloud.read(is);
    if (laws.needsDeformation() == state_.cloud.leftCauchyGreen.empty())
    {
        throw std::runtime_error
        (
            "The saved run was made with other constitutive models"
        );
    }
    state_.grid.read(is);
    state_.reports.resize(state_.grid.size());

    // Masses are those of the saved points
    const Clock clock = clock_;
    findSpeeds();
    clock_ = clock;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::Simulation<2>;
template class mpm::Simulation<3>;


// ************************************************************************* //
