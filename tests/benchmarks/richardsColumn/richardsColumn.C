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
    richardsColumn

Description
    Water in a vertical column, by a program that shares nothing with the
    project: neither library nor table, neither flux nor time scheme. The
    references of the verification come from it.

    Method of lines on the mixed form d theta(h)/dt = -dq/dz: equal cells,
    arithmetic mean of K and central differences (second order), TR-BDF2 with
    the step set by its embedded estimate of third order, Newton's method for h
    with a tridiagonal matrix. Curves are evaluated as formulas. Between two
    soils the head on the face is an unknown of its own, of a node that holds no
    water. Needs a compiler and nothing else:

        g++ -O3 -std=c++17 -o richardsColumn richardsColumn.C

Usage
    richardsColumn key=value ... > profile

        soil=vanGenuchten thetaS= thetaR= Ks= alpha= n= [l=0.5]
        soil=haverkamp    thetaS= thetaR= Ks= hTheta= beta= hK= gamma=
        soil=gardner      thetaS= thetaR= Ks= alpha=
        [interface=<z> upper-soil= upper-thetaS= ...]   above this height
        length=  cells=         the column [m], z = 0 at its bottom
        initial=<psi>           or initial=table:<z>, with a water table there
        top=head:<psi>          or flux:<m/s, downwards>
        bottom=head:<psi>       or flux:<m/s, downwards>, or free
        end=<s>  [tolerance=1e-9]  mean error of theta a step
        [bins=400]              the profile: means over so many equal parts
        [front=<psi>]           report the depth of this head

    'z theta psi' a line for each bin, from the bottom to the top (theta is the
    mean, psi that of the same theta); lines with # before them say how the run
    went.

\*---------------------------------------------------------------------------*/

#include "soilColumn.H"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Find the heads with theta(h) - weight inflow(h)/dz = known; false without
//- success. The state is the start and the result
bool solve
(
    const Column& column,
    const std::vector<double>& known,
    const double weight,
    Column::State& state,
    long& iterations
)
{
    const int n = int(known.size());
    const double ratio = weight/column.dz();
    Column::Jacobian jacobian;
    std::vector<double> pivot(n), right(n), change(n);

    const auto norm = [&](const Column::State& s)
    {
        double sum = 0;
        for (int i = 0; i < n; ++i)
        {
            sum += std::abs(s.at[i].theta - ratio*s.inflow[i] - known[i]);
        }
        return sum;
    };

    for (int iteration = 0; iteration < 30; ++iteration)
    {
        column.evaluate(state, &jacobian);
        const double before = norm(state);

        // Thomas's algorithm
        for (int i = 0; i < n; ++i)
        {
            const double residual =
                state.at[i].theta - ratio*state.inflow[i] - known[i];
            pivot[i] = state.at[i].capacity - ratio*jacobian.here[i];
            right[i] = -residual;
            if (i > 0)
            {
                const double factor = -ratio*jacobian.below[i]/pivot[i - 1];
                pivot[i] += factor*ratio*jacobian.above[i - 1];
                right[i] -= factor*right[i - 1];
            }
        }
        double largest = 0;
        for (int i = n - 1; i >= 0; --i)
        {
            change[i] = right[i];
            if (i + 1 < n) change[i] += ratio*jacobian.above[i]*change[i + 1];
            change[i] /= pivot[i];
            largest = std::max
            (
                largest,
                std::abs(change[i])/(1e-3 + std::abs(state.h[i]))
            );
        }
        if (!std::isfinite(largest)) return false;
        ++iterations;

        // Where a cell fills, dK/dh has no bound: it stops there on its way, and
        // many halvings are allowed
        double part = 1;
        Column::State trial;
        for (int halving = 0; ; ++halving, part *= 0.5)
        {
            trial.h = state.h;
            for (int i = 0; i < n; ++i)
            {
                trial.h[i] += part*change[i];
                if (state.h[i] < 0) trial.h[i] = std::min(trial.h[i], 0.0);
            }
            column.evaluate(trial, nullptr);
            if (norm(trial) < before || largest < 1e-9) break;
            if (halving == 20) return false;
        }
        state = trial;
        if (part == 1 && largest < 1e-9) return true;
    }
    return false;
}


//- Mean of values over the part [from, to] of n equal cells (fractions)
double meanOver
(
    const std::vector<double>& values,
    const double from,
    const double to
)
{
    const int n = int(values.size());
    double sum = 0;
    for (int i = int(from*n); i < n && i < to*n; ++i)
    {
        const double part =
            std::min(i + 1.0, to*n) - std::max(double(i), from*n);
        sum += std::max(part, 0.0)*values[i];
    }
    return sum/((to - from)*n);
}


//- The head at which a soil holds this much water
double headOf(const Soil& soil, const double theta)
{
    double dry = -1e7, wet = 0;
    for (int i = 0; i < 200; ++i)
    {
        const double middle =
            wet - dry > 1 ? -std::sqrt((1e-12 - wet)*-dry) : 0.5*(wet + dry);
        (soil(middle).theta < theta ? dry : wet) = middle;
    }
    return 0.5*(wet + dry);
}


int run(Arguments& arguments)
{
    const Soil soil = readSoil(arguments);
    const double length = arguments.number("length");
    const int nCells = int(arguments.number("cells"));
    const double interface = arguments.number("interface", length);
    const int nLower = int(std::lround(interface/length*nCells));
    if (std::abs(nLower*length/nCells - interface) > 1e-9*length)
    {
        throw std::runtime_error("the interface lies within a cell");
    }
    const Soil upperSoil =
        nLower < nCells ? readSoil(arguments, "upper-") : soil;
    const End bottom(arguments.word("bottom"));
    const End top(arguments.word("top"));
    const std::string initial = arguments.word("initial");
    const double end = arguments.number("end");
    const double tolerance = arguments.number("tolerance", 1e-9);
    const int bins = int(arguments.number("bins", 400));
    const bool hasFront = arguments.has("front");
    const double front = arguments.number("front", 0);
    arguments.refuseTheRest();

    const Column column(soil, upperSoil, nCells, nLower, length, bottom, top);
    const int n = int(column.z().size());

    Column::State now;
    now.h.resize(n);
    for (int i = 0; i < n; ++i)
    {
        now.h[i] =
            initial.compare(0, 6, "table:") == 0
          ? std::stod(initial.substr(6)) - column.z()[i]
          : std::stod(initial);
    }
    column.evaluate(now, nullptr);

    const auto storage = [&]
    {
        double sum = 0;
        for (const Point& point : now.at) sum += column.dz()*point.theta;
        return sum;
    };
    const double first = storage();

    // TR-BDF2: the trapezoidal rule to the part g of the step, then BDF2
    const double g = 2 - std::sqrt(2.0);
    const double a = 1/(g*(2 - g));
    const double b = (1 - g)*(1 - g)*a;
    const double c = (1 - g)/(2 - g);
    const double k = (-3*g*g + 4*g - 2)/(12*(2 - g));

    double time = 0, dt = 1e-9*end, infiltration = 0, drainage = 0;
    long steps = 0, rejected = 0, iterations = 0;
    std::vector<double> known(n);

    while (time < end*(1 - 1e-12))
    {
        dt = std::min(dt, end - time);
        Column::State middle(now);
        for (int i = 0; i < n; ++i)
        {
            known[i] =
                now.at[i].theta + 0.5*g*dt*now.inflow[i]/column.dz();
        }
        bool good = solve(column, known, 0.5*g*dt, middle, iterations);

        Column::State next(middle);
        double error = 0;
        if (good)
        {
            for (int i = 0; i < n; ++i)
            {
                known[i] = a*middle.at[i].theta - b*now.at[i].theta;
            }
            good = solve(column, known, c*dt, next, iterations);
        }
        if (good)
        {
            for (int i = 0; i < n; ++i)
            {
                error += std::abs
                (
                    now.inflow[i]/g
                  - middle.inflow[i]/(g*(1 - g))
                  + next.inflow[i]/(1 - g)
                );
            }
            error *= 2*std::abs(k)*dt/(column.dz()*nCells);
        }
        if (!good || error > tolerance)
        {
            ++rejected;
            dt *= good ? 0.9*std::cbrt(tolerance/error) : 0.25;
            if (dt < 1e-13*end)
            {
                throw std::runtime_error
                (
                    "the step has collapsed at " + std::to_string(time) + " s"
                );
            }
            continue;
        }

        const auto passed = [&](double Column::State::* flux)
        {
            return
                0.5*a*g*dt*(now.*flux + middle.*flux) + c*dt*(next.*flux);
        };
        infiltration += passed(&Column::State::topFlux);
        drainage += passed(&Column::State::bottomFlux);

        now = next;
        time += dt;
        ++steps;
        dt *= std::min(2.0, 0.9*std::cbrt(tolerance/(error + 1e-300)));
    }

    std::printf
    (
        "# %d cells, tolerance %g: %ld steps, %ld rejected, %ld iterations\n"
        "# through the top %.8g m, through the bottom %.8g m,"
        " error of the balance %.2e m\n",
        nCells, tolerance, steps, rejected, iterations,
        infiltration, drainage, storage() - first - infiltration + drainage
    );
    if (hasFront)
    {
        for (int i = n - 1; i > 0; --i)
        {
            if ((now.h[i] - front)*(now.h[i - 1] - front) <= 0)
            {
                const double below =
                    (now.h[i] - front)/(now.h[i] - now.h[i - 1]);
                std::printf
                (
                    "# psi = %g m at a depth of %.6f m\n",
                    front,
                    length - column.z()[i]
                  + below*(column.z()[i] - column.z()[i - 1])
                );
                break;
            }
        }
    }

    std::vector<double> theta;
    for (int i = 0; i < n; ++i)
    {
        if (!column.isInterface(i)) theta.push_back(now.at[i].theta);
    }
    for (int bin = 0; bin < bins; ++bin)
    {
        const double mean =
            meanOver(theta, double(bin)/bins, (bin + 1.0)/bins);
        std::printf
        (
            "%.8g %.9g %.8g\n",
            (bin + 0.5)*length/bins, mean,
            headOf((bin + 0.5)*length/bins < interface ? soil : upperSoil, mean)
        );
    }
    return 0;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    try
    {
        Arguments arguments(argc, argv);
        return run(arguments);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "richardsColumn: %s\n", error.what());
        return 1;
    }
}

// ************************************************************************* //
