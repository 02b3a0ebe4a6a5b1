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

Application
    mpmSpeed

Description
    Particle-steps a second of the material point engine on a column that
    collapses: 1 m x 1 m (x 1 m), E 1 MPa, nu 0.3, rho 2000 kg/m3, phi 30
    degrees, 4 points a cell in a section and 8 in three dimensions, rough
    base, roller behind. Measured in the middle of the collapse (0.15 s after
    the start, when about a third of the points yields) over whole steps: sorts,
    checks and all.

    Writes a table with one row for each dimension, number of points and
    number of threads. Each number is the best of several windows, which are the
    same steps for each number of threads: for one thread by the processor time
    it used, for more by the wall clock, which other work on the machine lowers.
    The load is noted.

    A second table says where the time of a step goes on one core, what shares
    of this core's measured limits are reached (operations and bytes of a point
    by count), and how long the points took to set up.

Usage
    mpmSpeed <file.csv> <stages.csv>
        [<largest number of points> [<seconds a window>]]

\*---------------------------------------------------------------------------*/

#include "machineLimits.H"
#include "sandColumn.H"
#include "stages.H"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr int windows = 5;
constexpr double startOfWindows = 0.15;

//- Seconds of processor time for one thread, else by the wall clock
double now(const int threads)
{
    if (threads == 1)
    {
        return double(std::clock())/CLOCKS_PER_SEC;
    }
    return std::chrono::duration<double>
    (
        std::chrono::steady_clock::now().time_since_epoch()
    ).count();
}


template<int dim>
std::unique_ptr<mpm::Simulation<dim>> column
(
    const int cells,
    const int threads,
    double& setUp
)
{
    const mpm::PointData points = sandColumn::points(dim, cells);
    const double start = now(1);
    auto run = std::make_unique<mpm::Simulation<dim>>
    (
        sandColumn::settings(dim, cells, threads),
        points,
        std::vector<mpm::Material>{sandColumn::soil()},
        sandColumn::walls(dim)
    );
    setUp = now(1) - start;
    return run;
}


//- Windows of a number of steps; of as many as take so many seconds, if it is
//  still zero
template<int dim>
void measure
(
    std::ostream& table,
    std::ostream& stageTable,
    const machineLimits& limits,
    const int cells,
    const int threads,
    const double seconds,
    long& steps
)
{
    double setUp = 0;
    const auto run = column<dim>(cells, threads, setUp);
    run->advance(startOfWindows);

    // Each window repeats the same steps from the same state
    std::stringstream saved;
    run->save(saved);
    const long sortsBefore = run->diagnostics().sorts;

    double best = 0;
    for (int window = 0; window < windows; ++window)
    {
        saved.clear();
        saved.seekg(0);
        run->restore(saved);

        const double start = now(threads);
        double elapsed = 0;
        if (steps == 0)
        {
            while (elapsed < seconds)
            {
                run->step(1);
                ++steps;
                elapsed = now(threads) - start;
            }
        }
        else
        {
            for (long i = 0; i < steps; ++i)
            {
                run->step(1);
            }
            elapsed = now(threads) - start;
        }
        best = std::max
        (
            best, double(run->nPoints())*double(steps)/elapsed/1e6
        );
    }

    const mpm::Diagnostics end = run->diagnostics();
    const long sorts = end.sorts - sortsBefore;
    const double yielding =
        double(end.yieldingPoints)/double(run->nPoints());

    const auto row = [&](std::ostream& os)
    {
        os  << dim << ',' << run->nPoints() << ',' << (dim == 2 ? 4 : 8)
            << ',' << threads << ',' << best << ',' << yielding << ','
            << sorts << ',' << end.bytesPerPoint << std::endl;
    };
    row(table);
    row(std::cout);

    if (threads == 1)
    {
        saved.clear();
        saved.seekg(0);
        run->restore(saved);
        run->step(1);
        const stages s = stages::measure(*run, sandColumn::soil(), seconds);

        // Nanoseconds a point and step
        const double n = double(run->nPoints());
        const double whole = 1e3/best;
        const double ns = 1e9/n;
        const double known = s.P2G + s.grid + s.G2P + s.stress + s.sort;
        stageTable
            << dim << ',' << run->nPoints() << ',' << yielding << ','
            << whole << ',' << ns*s.P2G << ',' << ns*s.grid << ','
            << ns*s.G2P << ',' << ns*s.stress << ',' << ns*s.sort << ','
            << whole - ns*known << ','
            << 1e6*best*stages::flopsOfPoint(dim, yielding)/limits.flops << ','
            << 1e6*best*stages::bytesOfPoint(dim)/limits.bytes << ','
            << setUp << std::endl;
    }
}


//- Columns of about 10^3 to 10^6 points
template<int dim>
void measureAll
(
    std::ostream& table,
    std::ostream& stageTable,
    const machineLimits& limits,
    const std::vector<int>& cells,
    const double mostPoints,
    const int mostThreads,
    const double seconds
)
{
    for (const int n : cells)
    {
        if (std::pow(2.0*n, dim) > mostPoints)
        {
            continue;
        }
        // The same part of the slide for each number of threads
        long steps = 0;
        for (int threads = 1; threads <= mostThreads; threads *= 2)
        {
            measure<dim>
            (
                table, stageTable, limits, n, threads, seconds, steps
            );
        }
    }
}


//- Programs that wanted to run in the last minute, where the system tells it
std::string load()
{
    std::ifstream info("/proc/loadavg");
    std::string perMinute("unknown");
    info >> perMinute;
    return perMinute;
}


//- Processor's name, where the system tells it
std::string machine()
{
    std::ifstream info("/proc/cpuinfo");
    std::string line;
    while (std::getline(info, line))
    {
        const std::size_t colon = line.find(':');
        if (line.compare(0, 10, "model name") == 0 && colon < line.size() - 2)
        {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc < 3)
    {
        std::cerr
            << "Usage: mpmSpeed <file.csv> <stages.csv> "
            << "[<largest number of points> [<seconds a window>]]"
            << std::endl;
        return 1;
    }
    const double mostPoints = argc > 3 ? std::atof(argv[3]) : 1.1e6;
    const double seconds = argc > 4 ? std::atof(argv[4]) : 1;
    const int mostThreads =
        std::max(1, int(std::thread::hardware_concurrency()));

    std::ofstream table(argv[1]), stageTable(argv[2]);
    if (!table || !stageTable)
    {
        std::cerr
            << "mpmSpeed: cannot write " << argv[table ? 2 : 1] << std::endl;
        return 1;
    }
    const machineLimits limits;

    const std::time_t today = std::time(nullptr);
    char date[32];
    std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&today));
    std::ostringstream where;
    where
        << "# " << machine() << ", " << mostThreads << " processors\n"
        << "# " << date << ", load at the start " << load();
    table
        << where.str() << "; one thread by processor time, more by the wall "
        << "clock\n"
        << "dim,points,pointsPerCell,threads,Mps,yieldingFraction,sorts,"
        << "bytesPerPoint" << std::endl;
    stageTable
        << where.str() << "\n# limits of one core: " << 1e-9*limits.flops
        << " GF/s, " << 1e-9*limits.bytes << " GB/s\n"
        << "dim,points,yieldingFraction,step_ns,P2G_ns,grid_ns,G2P_ns,"
        << "stress_ns,sort_ns,rest_ns,shareOfFlops,shareOfBandwidth,setUp_s"
        << std::endl;

    try
    {
        measureAll<2>
        (
            table, stageTable, limits, {16, 50, 158, 500}, mostPoints,
            mostThreads, seconds
        );
        measureAll<3>
        (
            table, stageTable, limits, {5, 11, 24, 50}, mostPoints,
            mostThreads, seconds
        );
    }
    catch (const std::exception& e)
    {
        std::cerr << "mpmSpeed: " << e.what() << std::endl;
        return 1;
    }
    return table && stageTable ? 0 : 1;
}


// ************************************************************************* //
