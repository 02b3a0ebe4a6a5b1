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

#include "mpmFusedCycle.H"
#include "mpmG2P.H"
#include "mpmGridUpdate.H"
#include "mpmP2G.H"
#include "mpmSleep.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::FusedCycle<Dim>::scatterPatches
(
    State<Dim>& state,
    const double deltaT,
    const double recordedShare
)
{
    state.forBlocks
    (
        [&state, deltaT, recordedShare](const std::size_t b)
        {
            const auto scatterFor = [&state, b](const double time)
            {
                scatterAPIC
                (
                    state.cloud,
                    state.grid,
                    state.grid[b],
                    time,
                    state.grid.patchOf(b)
                );
            };
            if (state.grid[b].rest.asleep)
            {
                scatterAsleep
                (
                    state.grid, b, true, deltaT, [&]() { scatterFor(1); }
                );
            }
            else if (!state.grid[b].points.empty())
            {
                scatterFor(deltaT);
            }
            else
            {
                return;
            }
            foldPatch(state, b, recordedShare, true);
        }
    );
    state.completePatches();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::FusedCycle<Dim>::step(State<Dim>& state, const double deltaT)
{
    for (BlockReport<Dim>& report : state.reports)
    {
        report.reset();
    }

    // Zhu2022 Eq. 13: points carry their mass. Eq. 14: their momentum and the
    // impulse of their stress to the nodes, then that of gravity
    scatterPatches(state, deltaT, 1);

    Vector<Dim> dv;
    for (int d = 0; d < Dim; ++d)
    {
        dv[d] = deltaT*state.gravity[d];
    }
    state.forBlocks
    (
        [&state, &dv, deltaT](const std::size_t b)
        {
            sumVelocities<Dim, reach>(state, b);
            accelerate<Dim>(state, b, dv);
            applyWalls(state, b, deltaT);
        }
    );

    if (average_)
    {
        std::vector<double>& rates = average_->rates(state);
        state.forBlocks
        (
            [&state, &rates](const std::size_t b)
            {
                findVolumetricRates(state, b, rates);
            }
        );
        average_->average(state, deltaT);
    }
    const StressUpdate<Dim> stress
    (
        state.laws,
        deltaT,
        state.elastic,
        false,
        average_ ? average_->changes() : nullptr
    );
    state.forBlocks
    (
        [&state, &stress, deltaT](const std::size_t b)
        {
            gatherAPIC(state, b, stress, deltaT);
            watch<Dim, reach>(state, b, deltaT);
        }
    );
}


template<int Dim>
void mpm::FusedCycle<Dim>::scatter(State<Dim>& state, const double deltaT)
{
    scatterPatches(state, deltaT, 0);
    state.forBlocks
    (
        [&state](const std::size_t b)
        {
            state.grid.template sum<reach>
            (
                state.grid.patches, state.grid[b], state.grid.nodesOf(b)
            );
        }
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::FusedCycle<2>;
template class mpm::FusedCycle<3>;


// ************************************************************************* //
