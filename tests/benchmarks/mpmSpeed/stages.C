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

#include "stages.H"
#include "mpmG2P.H"
#include "mpmGridUpdate.H"
#include "mpmMigration.H"
#include "mpmP2G.H"
#include "mpmSort.H"
#include "mpmStressUpdate.H"

#include <ctime>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double processorTime()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}


//- Call f() and add the time it takes
template<class Function>
void timed(double& sum, const Function& f)
{
    const double start = processorTime();
    f();
    sum += processorTime() - start;
}


template<int Dim>
void changeBlocks(mpm::State<Dim>& state)
{
    mpm::Migration<Dim> migration(state);
    for (const auto& report : state.reports)
    {
        for (const auto& leaving : report.leaving)
        {
            migration.add(leaving.point, leaving.to);
        }
    }
    migration.settle();
}


//- Time of the stress update of all points with their present gradients
template<int Dim>
double stressOnce(mpm::State<Dim>& state, const double deltaT)
{
    using mpm::laneCount;
    typedef mpm::Lanes Lanes;

    std::vector<std::int32_t> points;
    for (std::size_t b = 0; b < state.grid.size(); ++b)
    {
        const auto& list = state.grid[b].points;
        points.insert(points.end(), list.begin(), list.end());
    }
    points.resize(points.size()/laneCount*laneCount);

    constexpr int n = Dim*Dim;
    std::vector<Lanes> gradients(points.size()/laneCount*n);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        for (int k = 0; k < n; ++k)
        {
            gradients[i/laneCount*n + k].v[i % laneCount] =
                state.cloud.C[points[i]][k];
        }
    }

    const mpm::StressUpdate<Dim> update(state.laws, deltaT, false);
    double seconds = 0;
    timed
    (
        seconds,
        [&]()
        {
            for (std::size_t i = 0; i < points.size(); i += laneCount)
            {
                update.update
                (
                    state.cloud,
                    points.data() + i,
                    laneCount,
                    gradients.data() + i/laneCount*n
                );
            }
        }
    );
    return seconds;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
stages stages::measure
(
    const mpm::Simulation<Dim>& run,
    const mpm::Material& material,
    const double seconds
)
{
    typedef const std::size_t Index;
    constexpr int reach = 2;

    const mpm::State<Dim>& from = run.state();
    const double deltaT = run.diagnostics().deltaT;
    mpm::State<Dim> state
    (
        from.settings, from.gravity, from.grid.origin(), from.walls, {material}
    );
    std::stringstream blocks;
    from.grid.write(blocks);
    const auto restart = [&]()
    {
        blocks.clear();
        blocks.seekg(0);
        state.grid.read(blocks);
        state.cloud = from.cloud;
        state.laws = from.laws;
        state.maxMass = from.maxMass;
        state.connect();
    };
    const auto cycle = mpm::Cycle<Dim>::New(from.settings);

    mpm::Vector<Dim> dv;
    for (int d = 0; d < Dim; ++d)
    {
        dv[d] = deltaT*from.gravity[d];
    }
    const mpm::StressUpdate<Dim> stressUpdate(from.laws, deltaT, false);

    // So few steps that the points keep most of their order
    constexpr int steps = 20;
    stages sum;
    int nSteps = 0, nSorts = 0;
    while (sum.P2G + sum.grid + sum.G2P < seconds)
    {
        restart();
        for (int i = 0; i < steps; ++i, ++nSteps)
        {
            timed
            (
                sum.P2G,
                [&]()
                {
                    state.forBlocks
                    (
                        [&](Index b)
                        {
                            if (!state.grid[b].points.empty())
                            {
                                mpm::scatterAPIC
                                (
                                    state.cloud, state.grid, state.grid[b],
                                    deltaT, state.grid.patchOf(b)
                                );
                                mpm::foldPatch(state, b, 0, true);
                            }
                        }
                    );
                }
            );
            timed
            (
                sum.grid,
                [&]()
                {
                    state.forBlocks
                    (
                        [&](Index b)
                        {
                            mpm::sumVelocities<Dim, reach>(state, b);
                            mpm::accelerate<Dim>(state, b, dv);
                            mpm::applyWalls(state, b, deltaT);
                        }
                    );
                }
            );
            timed
            (
                sum.G2P,
                [&]()
                {
                    state.forBlocks
                    (
                        [&](Index b)
                        {
                            state.reports[b].reset();
                            mpm::gatherAPIC(state, b, stressUpdate, deltaT);
                        }
                    );
                }
            );
            changeBlocks(state);
        }
        sum.stress += steps*stressOnce(state, deltaT);
        timed(sum.sort, [&]() { mpm::sortPoints(state, *cycle); });
        ++nSorts;
    }

    const double perStep = 1.0/nSteps;
    sum.P2G *= perStep;
    sum.grid *= perStep;
    sum.stress *= perStep;
    sum.G2P = sum.G2P*perStep - sum.stress;
    sum.sort /= double(nSorts)*from.settings.sortInterval;
    return sum;
}


double stages::flopsOfPoint(const int dim, const double yieldingFraction)
{
    // Weights, twice; what a point sends; the nodes: a vector of four numbers
    // each, 11 operations for a row of them that is sent to, 6 for one that is
    // read; strain, rotation, elasticity and the look at the surface; the move
    const bool plane = dim == 2;
    const double weights = 2*dim*11;
    const double sent = plane ? 24 : 40;
    const double toNodes = 4*(plane ? 4 + 3*11 : 6 + 3*4 + 9*11);
    const double fromNodes =
        4*(plane ? 3*6 + 6 + 5 + 2*3 : 9*6 + 3*(6 + 5) + 6 + 2*5 + 3*3);
    const double elastic = plane ? 75 : 165;
    const double yields = plane ? 105 : 215;
    const double move = plane ? 16 : 24;
    return
        weights + sent + toNodes + fromNodes + elastic
      + yieldingFraction*yields + move;
}


double stages::bytesOfPoint(const int dim)
{
    // Position, velocity, displacement: dim numbers; C: dim^2; sigma: 4 or 6
    const int vector = 8*dim, C = 8*dim*dim, sigma = dim == 2 ? 32 : 48;
    const int sent = 2*vector + C + sigma + 2*8 + 4;
    const int read = 2*vector + sigma + 4*8 + 2*4;
    const int written = 3*vector + C + sigma + 2*8 + 1 + 4;
    return sent + read + written;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template stages stages::measure
(
    const mpm::Simulation<2>&,
    const mpm::Material&,
    double
);
template stages stages::measure
(
    const mpm::Simulation<3>&,
    const mpm::Material&,
    double
);

// ************************************************************************* //
