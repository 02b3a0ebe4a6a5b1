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

#include "mpmSleep.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim, int Reach>
void mpm::watch
(
    State<Dim>& state,
    const std::size_t b,
    const double deltaT
)
{
    auto& block = state.grid[b];
    if (!state.sleeps() || block.points.empty())
    {
        return;
    }

    // Lighter nodes are at the surface
    constexpr double leastMass = 0.5;

    constexpr int n = BlockGrid<Dim>::nPatchNodes(Reach);
    alignas(64) Node patch[n];
    state.grid.template collect<Reach>(state.grid.nodes, block, patch);
    double fastest = 0;
    for (int i = 0; i < n; ++i)
    {
        if (patch[i][massOf] > leastMass*state.maxMass)
        {
            double square = 0;
            for (int d = 0; d < Dim; ++d)
            {
                square += patch[i][d]*patch[i][d];
            }
            fastest = std::max(fastest, square);
        }
    }

    BlockReport<Dim>& report = state.reports[b];
    const Settings& settings = state.settings;
    const double limit = settings.sleepVelocity*settings.sleepVelocity;
    if (fastest > limit || !report.leaving.empty())
    {
        block.wake();
        return;
    }

    block.rest.time += deltaT;
    if (block.rest.asleep || block.rest.time < settings.sleepDelay)
    {
        return;
    }
    block.rest.asleep = true;
    block.rest.wave2 = report.wave2;
    for (const std::int32_t p : block.points)
    {
        state.cloud.v[p] = Vector<Dim>{};
        state.cloud.C[p] = Tensor<Dim>{};
    }
    report.speed2 = report.kineticEnergy = 0;
}


template<int Dim>
void mpm::wakeAll(State<Dim>& state)
{
    for (std::size_t b = 0; b < state.grid.size(); ++b)
    {
        state.grid[b].wake();
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::wakeAll(State<Dim>&);                                   \
    template void mpm::watch<Dim, 1>(State<Dim>&, std::size_t, double);        \
    template void mpm::watch<Dim, 2>(State<Dim>&, std::size_t, double);        \
    template void mpm::watch<Dim, 3>(State<Dim>&, std::size_t, double);

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
