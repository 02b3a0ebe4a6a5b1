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

#include "nelderMead.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// * * * * * * * * * * * * * * Local Helpers  * * * * * * * * * * * * * * //

namespace
{

using slopeStability::minimum;

//- One descent
minimum descend
(
    const std::function<double(const Eigen::VectorXd&)>& f,
    const minimum& start,
    const double step,
    const double tolerance
)
{
    // Halves the simplex some 20 times in 3 variables; more is stagnation
    const int maxIterations = 200;

    const Eigen::Index n = start.place.size();
    const auto evaluate = [&f](const Eigen::VectorXd& x)
    {
        return minimum{x, f(x)};
    };
    const auto better = [](const minimum& a, const minimum& b)
    {
        return a.value < b.value;
    };

    std::vector<minimum> simplex(1, start);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        Eigen::VectorXd x = start.place;
        x[i] += step;
        simplex.push_back(evaluate(x));
        if (simplex.back().value == std::numeric_limits<double>::infinity())
        {
            x[i] -= 2*step;
            simplex.back() = evaluate(x);
        }
    }

    for (int iteration = 0; iteration < maxIterations; ++iteration)
    {
        std::stable_sort(simplex.begin(), simplex.end(), better);

        double size = 0;
        Eigen::VectorXd middle = Eigen::VectorXd::Zero(n);
        for (Eigen::Index i = 0; i < n; ++i)
        {
            middle += simplex[i].place/double(n);
            size = std::max
            (
                size,
                (simplex[i + 1].place - simplex[0].place)
                    .cwiseAbs().maxCoeff()
            );
        }
        if (size < tolerance)
        {
            break;
        }

        minimum& worst = simplex.back();
        const Eigen::VectorXd away = middle - worst.place;
        const minimum reflected = evaluate(middle + away);

        if (reflected.value < simplex[0].value)
        {
            const minimum expanded = evaluate(middle + 2*away);
            worst = better(expanded, reflected) ? expanded : reflected;
            continue;
        }
        if (reflected.value < simplex[n - 1].value)
        {
            worst = reflected;
            continue;
        }

        const bool outside = reflected.value < worst.value;
        const minimum contracted =
            evaluate(middle + (outside ? 0.5 : -0.5)*away);
        if (contracted.value < std::min(worst.value, reflected.value))
        {
            worst = contracted;
            continue;
        }

        for (Eigen::Index i = 1; i <= n; ++i)
        {
            simplex[i] = evaluate
            (
                0.5*(simplex[i].place + simplex[0].place)
            );
        }
    }

    return *std::min_element(simplex.begin(), simplex.end(), better);
}

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

slopeStability::minimum slopeStability::nelderMead
(
    const std::function<double(const Eigen::VectorXd&)>& f,
    const minimum& start,
    const double step,
    const double tolerance
)
{
    const int maxRestarts = 6;

    minimum best = start;
    double size = step;

    for (int i = 0; i <= maxRestarts; ++i)
    {
        const minimum next = descend(f, best, size, tolerance);
        const bool improved =
            best.value - next.value > 1e-8*std::abs(best.value);
        if (next.value < best.value)
        {
            best = next;
        }
        if (!improved && i > 0)
        {
            break;
        }
        size *= 0.5;
    }

    return best;
}


// ************************************************************************* //
