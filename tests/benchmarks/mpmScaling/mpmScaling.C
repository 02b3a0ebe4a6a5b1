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
    What it costs to share a slide among ranks: a column that collapses, as in
    mpmSpeed, on the ranks that mpirun has started (or on one without it).

    Prints one line for a table: sizes, seconds, and what the ranks said to each
    other. The processor time in messages is kept apart from that of the work,
    because a rank that waits keeps its processor busy.

Usage
    mpmScaling <dimension> <cells> <width> <steps> <threads> [parallel]

    The column is \c cells high and \c width times as wide.

\*---------------------------------------------------------------------------*/

#include "mpmSimulation.H"
#include "parRun.H"
#include "pstreamCommunicator.H"
#include "sandColumn.H"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double wallTime()
{
    return std::chrono::duration<double>
    (
        std::chrono::steady_clock::now().time_since_epoch()
    ).count();
}


//- Processor time of this process, all its threads together
double cpuTime()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9*double(t.tv_nsec);
}


//- Passes all on and keeps the account
class CountingCommunicator final
:
    public mpm::Communicator
{
    Foam::pstreamCommunicator ranks_;

    template<class Call>
    void timed(const Call& call)
    {
        const double wall = wallTime();
        const double cpu = cpuTime();
        call();
        count.wall += wallTime() - wall;
        count.cpu += cpuTime() - cpu;
    }


public:

    struct Count
    {
        double wall = 0;
        double cpu = 0;

        //- To neighbours, and to all
        long messages = 0;
        double bytes = 0;
        double bytesToAll = 0;
        long toAll = 0;
        long reductions = 0;
    } count;

    int rank() const override
    {
        return ranks_.rank();
    }

    int size() const override
    {
        return ranks_.size();
    }

    void reduce
    (
        std::vector<double>& maxima,
        std::vector<std::int64_t>& sums
    ) override
    {
        ++count.reductions;
        timed([&]() { ranks_.reduce(maxima, sums); });
    }

    void exchange
    (
        const std::vector<int>& ranks,
        const std::vector<mpm::Buffer>& sent,
        std::vector<mpm::Buffer>& received
    ) override
    {
        for (const mpm::Buffer& buffer : sent)
        {
            count.messages += !buffer.empty();
            count.bytes += double(buffer.size());
        }
        timed([&]() { ranks_.exchange(ranks, sent, received); });
    }

    std::vector<mpm::Buffer> allToAll
    (
        const std::vector<mpm::Buffer>& sent
    ) override
    {
        ++count.toAll;
        for (const mpm::Buffer& buffer : sent)
        {
            count.bytesToAll += double(buffer.size());
        }
        std::vector<mpm::Buffer> received;
        timed([&]() { received = ranks_.allToAll(sent); });
        return received;
    }
};


//- Faces between a block of this rank and one of another
template<int Dim>
long sharedFaces(const mpm::State<Dim>& state)
{
    long n = 0;
    for (std::size_t b = 0; b < state.grid.size(); ++b)
    {
        for (int d = 0; d < Dim && !state.grid[b].points.empty(); ++d)
        {
            for (const int side : {-1, 1})
            {
                auto at = state.grid[b].at;
                at[d] += side;
                const std::int32_t other = state.grid.lookUp(at);
                n += other >= 0 && state.grid[other].ghost;
            }
        }
    }
    return n;
}


template<int Dim>
void measure
(
    const int cells,
    const int width,
    const long steps,
    const int threads
)
{
    const mpm::PointData data = sandColumn::points(Dim, cells, width);
    const std::size_t n = data.position.size();

    const auto ranks = std::make_shared<CountingCommunicator>();
    const double wallAtSetUp = wallTime();
    const double cpuAtSetUp = cpuTime();
    mpm::Simulation<Dim> run
    (
        sandColumn::settings(Dim, cells, threads),
        data,
        {sandColumn::soil()},
        sandColumn::walls(Dim),
        ranks
    );
    const double setUpWall = wallTime() - wallAtSetUp;
    const double setUpCpu = cpuTime() - cpuAtSetUp;

    // In the middle of the collapse
    run.advance(0.15);
    const long rebalances = run.diagnostics().rebalances;
    ranks->count = {};
    const double wallAtStart = wallTime();
    const double cpuAtStart = cpuTime();
    for (long i = 0; i < steps; ++i)
    {
        run.step(1);
    }
    const double wallUsed = wallTime() - wallAtStart;
    const double cpuUsed = cpuTime() - cpuAtStart;
    const CountingCommunicator::Count c = ranks->count;
    const mpm::Diagnostics d = run.diagnostics();

    // Of all ranks: largest work, sums of the rest
    const double micro = 1e6;
    std::vector<double> largest{cpuUsed - c.cpu, setUpCpu, wallUsed};
    std::vector<std::int64_t> sums
    {
        std::int64_t(micro*(cpuUsed - c.cpu)),
        std::int64_t(micro*c.cpu),
        std::int64_t(micro*c.wall),
        std::int64_t(c.bytes),
        std::int64_t(c.bytesToAll),
        c.messages,
        sharedFaces(run.state())
    };
    ranks->reduce(largest, sums);
    if (!ranks->master())
    {
        return;
    }

    const double nRanks = ranks->size();
    const double perStep = 1.0/(double(steps)*nRanks);
    std::cout
        << Dim << ',' << n << ',' << nRanks << ',' << threads << ',' << steps
        << ',' << largest[2] << ',' << largest[0] << ','
        << double(sums[0])/micro << ',' << double(sums[1])/micro << ','
        << double(sums[2])/micro/nRanks/largest[2] << ','
        << double(sums[3])*perStep << ',' << double(sums[5])*perStep << ','
        << double(c.reductions)/double(steps) << ','
        << double(c.toAll)/double(steps) << ','
        << double(sums[4])*perStep << ',' << double(sums[6])/nRanks << ','
        << d.imbalance << ',' << d.rebalances - rebalances << ','
        << d.bytesPerPoint << ',' << setUpWall << ',' << largest[1]
        << std::endl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc < 6)
    {
        std::cerr
            << "Usage: mpmScaling <dimension> <cells> <width> <steps> "
            << "<threads> [parallel]" << std::endl;
        return 1;
    }
    const int dim = std::atoi(argv[1]);
    const int cells = std::atoi(argv[2]);
    const int width = std::atoi(argv[3]);
    const long steps = std::atol(argv[4]);
    const int threads = std::atoi(argv[5]);

    Foam::ParRunControl parallel;
    if (argc > 6)
    {
        parallel.runPar(argc, argv, false);
    }

    if (dim == 2)
    {
        measure<2>(cells, width, steps, threads);
    }
    else
    {
        measure<3>(cells, width, steps, threads);
    }
    return 0;
}


// ************************************************************************* //
