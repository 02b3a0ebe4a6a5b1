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

Description
    mpmStability [largest number of cells]
    mpmAntiLocking [smallest cell, m]

    The validation slope with each average against locking over cells of 2 m
    and less (0.5 m): safety factor by strength reduction at the displacement
    gamma H^2/E of the crest and at that of any point, without dilation and
    with associated flow, and what the slope does in 15 s at its own strength.
    Table on the standard output.

\*---------------------------------------------------------------------------*/

#include "slopeStates.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Displacements after a run [m]
struct Moved
{
    double crest, largest;
};


Moved moved(const mpm::Run& run, const std::size_t crest)
{
    const std::vector<double> u = run.field("displacement");
    return
    {
        std::hypot(u[3*crest], u[3*crest + 1]),
        run.diagnostics().maxDisplacement
    };
}


//- The point next to the crest
std::size_t crestOf(const mpm::Run& run)
{
    const std::vector<double> x = run.field("position");
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < run.nPoints(); ++i)
    {
        const double distance = std::hypot
        (
            x[3*i] + 0.8*slopeStates::height,
            x[3*i + 1] - slopeStates::height
        );
        if (distance < least)
        {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}


//- F at which a displacement crosses the criterion, between the runs made; the
//  logarithm of displacement is linear there
double crossing
(
    const std::map<double, Moved>& runs,
    double Moved::*const displacement
)
{
    for (auto next = std::next(runs.begin()); next != runs.end(); ++next)
    {
        const auto last = std::prev(next);
        const double below = last->second.*displacement;
        const double above = next->second.*displacement;
        if (below < slopeStates::criterion && above >= slopeStates::criterion)
        {
            return
                last->first
              + (next->first - last->first)
               *std::log(slopeStates::criterion/below)/std::log(above/below);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}


double cpuTime()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}


void write(const double x)
{
    std::cout << ',';
    if (x == x)
    {
        std::cout << x;
    }
}


void study
(
    const char* name,
    const slopeStates::State& state,
    const bool associated,
    const std::string& antiLocking,
    const double cellSize
)
{
    using namespace slopeStates;

    const double startTime = cpuTime();
    mpm::Settings numerics;
    numerics.antiLocking = antiLocking;
    mpm::StartReport report;
    auto run = slope
    (
        state, cellSize, associated ? state.phi : 0, report, numerics
    );
    const std::size_t crest = crestOf(*run);
    const std::string rest = verification::saved(*run);
    run->advance(15);
    const Moved own = moved(*run, crest);
    const double velocity = run->diagnostics().maxVelocity;

    std::map<double, Moved> runs;
    verification::safetyFactor
    (
        [&](const double F)
        {
            if (associated)
            {
                auto reduced =
                    associatedSlope(state, cellSize, F, antiLocking);
                reduced->advance(10);
                runs[F] = moved(*reduced, crest);
            }
            else
            {
                verification::reducedStrength
                (
                    *run, rest, F, 10,
                    [&](const mpm::Run& r)
                    {
                        runs[F] = moved(r, crest);
                        return 0.0;
                    }
                );
            }
            return runs[F].crest;
        },
        criterion,
        0.8*state.bishop,
        1.2*state.bishop,
        4
    );

    std::cout
        << name << ',' << (associated ? "associated" : "none") << ','
        << antiLocking << ',' << cellSize;
    write(state.bishop);
    write(crossing(runs, &Moved::crest));
    write(crossing(runs, &Moved::largest));
    write(own.crest);
    write(own.largest);
    write(velocity);
    write(cpuTime() - startTime);
    std::cout << std::endl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    const double smallest = argc > 1 ? std::atof(argv[1]) : 0.5;

    std::cout
        << "state,dilation,antiLocking,cellSize_m,bishop,safetyFactorCrest,"
           "safetyFactorAny,crestMoved_m,anyMoved_m,velocity_mps,cpu_s\n";
    for (double cellSize = 2; cellSize >= smallest; cellSize /= 2)
    {
        for (const bool associated : {false, true})
        {
            for (const std::string& average : mpm::Settings::antiLockings())
            {
                study("a", slopeStates::stateA, associated, average, cellSize);
                study("b", slopeStates::stateB, associated, average, cellSize);
            }
        }
    }
    return 0;
}

// ************************************************************************* //
