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

#include "mpmNames.H"
#include "mpmOverburden.H"
#include "mpmPointTensor.H"
#include "mpmReduce.H"
#include "mpmSimulation.H"
#include "mpmSleep.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- -(horizontal I + (vertical - horizontal) up up)
inline Stress<2> columnStress
(
    const double vertical,
    const double side,
    const Vector<2>& up
)
{
    const double d = vertical - side;
    return
    {{
        -side - d*up[0]*up[0], -side - d*up[1]*up[1], -side, -d*up[0]*up[1]
    }};
}


inline Stress<3> columnStress
(
    const double vertical,
    const double side,
    const Vector<3>& up
)
{
    const double d = vertical - side;
    return
    {{
        -side - d*up[0]*up[0],
        -side - d*up[1]*up[1],
        -side - d*up[2]*up[2],
        -d*up[0]*up[1],
        -d*up[1]*up[2],
        -d*up[2]*up[0]
    }};
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::setColumnStress(const StartSettings& settings)
{
    PointCloud<Dim>& cloud = state_.cloud;
    if (state_.laws.needsDeformation())
    {
        throw std::invalid_argument
        (
            "initialState type columnK0 with constitutiveModel neoHookean, "
            "whose stress is that of its deformation: use elasticGravity"
        );
    }

    const Vector<Dim> upward = up(state_.settings);
    double g2 = 0;
    for (const double g : state_.gravity)
    {
        g2 += g*g;
    }

    std::vector<double> vertical;
    if (settings.overburden)
    {
        vertical.resize(cloud.size());
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            Point3 x{{0, 0, 0}};
            std::copy(cloud.x[i].begin(), cloud.x[i].end(), x.begin());
            vertical[i] = settings.overburden(x);
        }
    }
    else
    {
        vertical = overburden<Dim>
        (
            *state_.communicator,
            cloud,
            upward,
            std::sqrt(g2),
            state_.settings.cellSize,
            state_.grid.origin(),
            state_.axisymmetric
        );
    }

    constexpr double degree = 3.14159265358979323846/180;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const double K0 =
            settings.K0 >= 0
          ? settings.K0
          : 1 - std::sin(degree*state_.laws[cloud.law[i]].frictionAngle);
        const double pw = cloud.porePressure[i];
        cloud.sigma[i] = columnStress
        (
            vertical[i], K0*(vertical[i] - pw) + pw, upward
        );
    }
}


template<int Dim>
void mpm::Simulation<Dim>::relax
(
    const double duration,
    const double restVelocity,
    StartReport& report
)
{
    const double end = clock_.time + duration;
    double last = 0;
    while (clock_.time < end)
    {
        step(end - clock_.time);
        ++report.steps;

        const double energy = clock_.kineticEnergy;
        if (energy < last)
        {
            // The last step was the peak
            report.rmsVelocity = std::sqrt(2*last/totalMass_);
            report.atRest = report.rmsVelocity < restVelocity;
            halt();
            ++report.resets;
            last = 0;
            if (report.atRest)
            {
                break;
            }
        }
        else
        {
            last = energy;
        }
    }
    report.time += duration - std::max(0.0, end - clock_.time);
}


template<int Dim>
double mpm::Simulation<Dim>::outOfBalance()
{
    // Without velocities, what the points give in one second is the force
    cycle_->scatter(state_, 1.0);

    std::vector<ExactSum> sums(2);
    ExactSum& unbalanced = sums[0];
    ExactSum& weight = sums[1];
    for (std::size_t b = 0; b < state_.grid.size(); ++b)
    {
        std::vector<Node> force
        (
            state_.grid.nodesOf(b),
            state_.grid.nodesOf(b) + BlockGrid<Dim>::nNodes
        );
        for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
        {
            Node& f = force[i];
            if (!state_.grid.isOwn(state_.grid[b], i))
            {
                f = Node{};
            }
            for (int d = 0; d < Dim; ++d)
            {
                const double w = f[massOf]*state_.gravity[d];
                weight.add(w*w);
                f[d] += w;
            }
        }
        // Walls take what they carry from a force as from a velocity
        for (const auto& w : state_.grid[b].wallNodes)
        {
            state_.walls[w.wall].act(w.normal, force[w.node]);
        }
        for (const Node& f : force)
        {
            for (int d = 0; d < Dim; ++d)
            {
                unbalanced.add(f[d]*f[d]);
            }
        }
    }

    std::vector<double> nothing;
    reduceExact(*state_.communicator, nothing, sums);
    return
        weight.value() > 0
      ? std::sqrt(unbalanced.value()/weight.value())
      : 0;
}


template<int Dim>
void mpm::Simulation<Dim>::measureExcess(StartReport& report) const
{
    const PointCloud<Dim>& cloud = state_.cloud;
    std::vector<double> maxExcess(1, 0.0);
    std::vector<std::int64_t> outside(1, 0);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const LawTable::Law& law = state_.laws[cloud.law[i]];
        if (law.elastic)
        {
            continue;
        }
        const PrincipalStress<Dim, double> s(tensor(cloud.sigma[i]));
        const double excess =
            law.model == LawTable::Model::DruckerPrager
          ? law.cone.excess(tensor(cloud.sigma[i]), cloud.cohesion[i])
          : law.soil.excess(s.first, s.third, cloud.cohesion[i]);

        // Round-off of a returned stress is not outside
        const double scale = std::fabs(s.first) + std::fabs(s.third);
        if (excess > 1e-9*scale)
        {
            ++outside[0];
            maxExcess[0] = std::max(maxExcess[0], excess);
        }
    }
    state_.communicator->reduce(maxExcess, outside);
    report.maxExcess = maxExcess[0];
    report.outsideFraction = double(outside[0])/double(nPoints_);
}


template<int Dim>
mpm::StartReport mpm::Simulation<Dim>::comeToRest
(
    const StartSettings& settings
)
{
    StartReport report;
    PointCloud<Dim>& cloud = state_.cloud;
    state_.starting = true;
    wakeAll(state_);

    // Strength of the stable soil
    cloud.hold();
    if (!settings.stableCohesionIntercept.empty())
    {
        setField("cohesionIntercept", settings.stableCohesionIntercept);
    }
    for (double& c : cloud.cohesion)
    {
        c += settings.addedCohesion;
    }
    if (!settings.stableFrictionAngle.empty())
    {
        setField("frictionAngle", settings.stableFrictionAngle);
    }

    halt();
    std::fill
    (
        cloud.displacement.begin(), cloud.displacement.end(), Vector<Dim>{}
    );
    if (settings.type == "columnK0")
    {
        setColumnStress(settings);
    }
    else if (settings.type == "elasticGravity")
    {
        state_.elastic = true;
        checkDuration("elasticTime", settings.elasticTime);
        relax(settings.elasticTime, settings.restVelocity, report);
        state_.elastic = false;
        halt();
        report.atRest = false;
    }
    cloud.forgetPlasticStrain();
    checkDuration("relaxationTime", settings.relaxationTime);
    relax(settings.relaxationTime, settings.restVelocity, report);

    // What the soil did on its way to rest
    const Vector<Dim> upward = up(state_.settings);
    enum { settlement, moved, nMaxima };
    std::vector<double> maxima(nMaxima, 0.0);
    std::vector<std::int64_t> yielded(1, 0);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        double height = 0, square = 0;
        for (int d = 0; d < Dim; ++d)
        {
            height += cloud.displacement[i][d]*upward[d];
            square += cloud.displacement[i][d]*cloud.displacement[i][d];
        }
        maxima[settlement] = std::max(maxima[settlement], -height);
        maxima[moved] = std::max(maxima[moved], std::sqrt(square));
        yielded[0] += cloud.plasticStrain[i] > 0;
    }
    state_.communicator->reduce(maxima, yielded);
    report.settlement = maxima[settlement];
    report.maxDisplacement = maxima[moved];
    report.yieldedFraction = double(yielded[0])/double(nPoints_);

    halt();
    cloud.forgetPlasticStrain();
    cloud.release();
    state_.starting = false;
    begin(report);

    return report;
}


template<int Dim>
mpm::StartReport mpm::Simulation<Dim>::goOnAsGiven
(
    const StartSettings& settings
)
{
    StartReport report;
    wakeAll(state_);
    begin(report);

    const PointCloud<Dim>& cloud = state_.cloud;
    std::vector<ExactSum> energy(1);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        for (const double v : cloud.v[i])
        {
            energy[0].add(0.5*cloud.mass[i]*v*v);
        }
    }
    std::vector<double> nothing;
    reduceExact(*state_.communicator, nothing, energy);
    report.rmsVelocity = std::sqrt(2*energy[0].value()/totalMass_);
    report.atRest = report.rmsVelocity < settings.restVelocity;

    return report;
}


template<int Dim>
void mpm::Simulation<Dim>::begin(StartReport& report)
{
    PointCloud<Dim>& cloud = state_.cloud;
    std::fill
    (
        cloud.displacement.begin(), cloud.displacement.end(), Vector<Dim>{}
    );
    std::fill(cloud.yielding.begin(), cloud.yielding.end(), 0);
    std::fill(cloud.dilation.begin(), cloud.dilation.end(), 0.0);

    clock_ = Clock();
    clearLoads();
    findSpeeds();
    sort();
    measureSides();
    startAccount();
    measureExcess(report);

    const std::vector<Vector<Dim>> v(cloud.v);
    const std::vector<Tensor<Dim>> C(cloud.C);
    std::fill(cloud.v.begin(), cloud.v.end(), Vector<Dim>{});
    std::fill(cloud.C.begin(), cloud.C.end(), Tensor<Dim>{});
    report.outOfBalance = outOfBalance();
    cloud.v = v;
    cloud.C = C;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
mpm::StartReport mpm::Simulation<Dim>::establishStart
(
    const StartSettings& settings
)
{
    settings.validate(nPoints());

    const Good good(keep());
    try
    {
        return
            settings.type == "given"
          ? goOnAsGiven(settings)
          : comeToRest(settings);
    }
    catch (const std::exception&)
    {
        state_.elastic = state_.starting = false;
        goBack(good);
        throw;
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::Simulation<Dim>::setColumnStress(const StartSettings&); \
    template void mpm::Simulation<Dim>::relax(double, double, StartReport&);   \
    template double mpm::Simulation<Dim>::outOfBalance();                      \
    template void mpm::Simulation<Dim>::measureExcess(StartReport&) const;     \
    template mpm::StartReport mpm::Simulation<Dim>::comeToRest                 \
    (                                                                          \
        const StartSettings&                                                   \
    );                                                                         \
    template mpm::StartReport mpm::Simulation<Dim>::goOnAsGiven                \
    (                                                                          \
        const StartSettings&                                                   \
    );                                                                         \
    template void mpm::Simulation<Dim>::begin(StartReport&);                   \
    template mpm::StartReport mpm::Simulation<Dim>::establishStart             \
    (                                                                          \
        const StartSettings&                                                   \
    );

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
