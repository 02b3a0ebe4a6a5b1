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

#include "machineLimits.H"
#include "lanes.H"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double processorTime()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}


//- Best of several tries of work(), which returns what it did
template<class Work>
double rate(const Work& work)
{
    double best = 0;
    for (int i = 0; i < 7; ++i)
    {
        const double start = processorTime();
        const double done = work();
        best = std::max(best, done/(processorTime() - start));
    }
    return best;
}


double multiplyAndAdd()
{
    // Enough of them to hide the time until a result is there, and no more than
    // there are registers
#ifdef __AVX512F__
    constexpr int nChains = 12;
#else
    constexpr int nChains = 6;
#endif
    constexpr long steps = 4000000;
    mpm::Lanes chain[nChains];
    for (int i = 0; i < nChains; ++i)
    {
        chain[i] = mpm::Lanes::each
        (
            [i](const int lane) { return 1.0 + i + 0.1*lane; }
        );
    }
    const mpm::Lanes a(0.999999), b(1e-6);
    for (long s = 0; s < steps; ++s)
    {
        for (mpm::Lanes& c : chain)
        {
            c = a*c + b;
        }
    }
    double sum = 0;
    for (const mpm::Lanes& c : chain)
    {
        for (int lane = 0; lane < mpm::laneCount; ++lane)
        {
            sum += c[lane];
        }
    }

    // Each lane is another one and is used: the compiler leaves nothing out
    return sum > 0 ? 2.0*mpm::laneCount*nChains*steps : 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

machineLimits::machineLimits()
:
    flops(rate(multiplyAndAdd))
{
    constexpr std::size_t n = 16000000;
    std::vector<double> a(n, 1), b(n, 2), c(n, 0);
    bytes = rate
    (
        [&]()
        {
            for (std::size_t i = 0; i < n; ++i)
            {
                c[i] = a[i] + 0.5*b[i];
            }
            return c[n/2] > 0 ? 3.0*sizeof(double)*n : 0;
        }
    );
}

// ************************************************************************* //
