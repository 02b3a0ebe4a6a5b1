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

#include "searchDirection.H"
#include "bishop.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Static Data  * * * * * * * * * * * * * * * //

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

//- Change of the ground's inclination that makes a bend
const double leastBend = 5*M_PI/180;

//- Bends looked at: on rough ground the sharpest ones
const std::size_t maxBends = 12;

//- Size of the last simplex in steps of the grid: of a first look at each
//  start, and of the result
const double coarse = 1e-3;
const double fine = 1e-7;

//- Results of first looks that are refined
const std::size_t nRefined = 3;

} // End anonymous namespace

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void slopeStability::searchDirection::findBends()
{
    const polyline& ground = section_.ground();

    std::vector<std::pair<double, double>> sharpness;
    for (std::size_t i = 1; i + 1 < ground.points().size(); ++i)
    {
        const double bend = std::abs
        (
            std::atan(ground.slope(i)) - std::atan(ground.slope(i - 1))
        );
        if (bend > leastBend)
        {
            sharpness.emplace_back(-bend, ground.points()[i].x());
        }
    }
    std::stable_sort
    (
        sharpness.begin(),
        sharpness.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; }
    );

    for (std::size_t i = 0; i < std::min(maxBends, sharpness.size()); ++i)
    {
        bends_.push_back(sharpness[i].second);
    }
    std::sort(bends_.begin(), bends_.end());
}


std::vector<double> slopeStability::searchDirection::places
(
    const double low,
    const double high
) const
{
    std::vector<double> x;
    for (int i = 0; i < settings_.nPlaces; ++i)
    {
        x.push_back(low + i*(high - low)/(settings_.nPlaces - 1));
    }
    for (const double bend : bends_)
    {
        if (bend > low && bend < high)
        {
            x.push_back(bend);
        }
    }
    std::sort(x.begin(), x.end());

    return x;
}


double slopeStability::searchDirection::evaluate
(
    const slipArc& arc,
    const stabilityMethod& method,
    equilibrium& answer
) const
{
    answer = method.solve(slipMass(section_, arc, settings_.nSlices));
    ++counts_.evaluated;

    if (answer.outcome == verdict::converged)
    {
        return answer.FOS;
    }

    ++counts_.refused[verdictName(answer.outcome)];
    return infinity;
}


double slopeStability::searchDirection::evaluate
(
    const Eigen::Vector3d& place
) const
{
    const std::optional<slipArc> arc = arcAt(place);
    if (!arc)
    {
        return infinity;
    }

    equilibrium answer;
    return evaluate(*arc, method_, answer);
}


std::optional<slopeStability::slipArc> slopeStability::searchDirection::arcAt
(
    const Eigen::Vector3d& place
) const
{
    return family_.arc
    (
        std::clamp(entryMin_ + place[0]*step_, entryMin_, entryMax_),
        std::clamp(exitMin_ + place[1]*step_, exitMin_, exitMax_),
        std::clamp(place[2]/(settings_.nDeepness - 1), 0.0, 1.0)
    );
}


std::vector<slopeStability::minimum>
slopeStability::searchDirection::gridSearch() const
{
    const bishop gridMethod;
    std::vector<minimum> grid;
    const std::vector<double> exits = places(exitMin_, exitMax_);

    for (const double entryX : places(entryMin_, entryMax_))
    {
        const point entry(entryX, section_.ground().y(entryX));
        for (const double exitX : exits)
        {
            const auto halfAngles = family_.admitted(entryX, exitX);
            if (!halfAngles)
            {
                continue;
            }
            const point exit(exitX, section_.ground().y(exitX));

            for (int i = 0; i < settings_.nDeepness; ++i)
            {
                const double w = double(i)/(settings_.nDeepness - 1);
                const slipArc arc
                (
                    entry,
                    exit,
                    (1 - w)*halfAngles->min + w*halfAngles->max
                );
                equilibrium answer;
                const double FOS = evaluate(arc, gridMethod, answer);
                if (FOS < infinity)
                {
                    grid.push_back
                    ({
                        Eigen::Vector3d
                        (
                            (entryX - entryMin_)/step_,
                            (exitX - exitMin_)/step_,
                            i
                        ),
                        FOS
                    });
                }
            }
        }
    }

    std::stable_sort
    (
        grid.begin(),
        grid.end(),
        [](const minimum& a, const minimum& b) { return a.value < b.value; }
    );

    // Two starts closer than this many steps would go to the same minimum
    const double apart = 2;

    std::vector<minimum> starts;
    for (const minimum& m : grid)
    {
        const bool isApart = std::all_of
        (
            starts.begin(),
            starts.end(),
            [&](const minimum& s)
            {
                return (s.place - m.place).cwiseAbs().maxCoeff() >= apart;
            }
        );
        if (isApart)
        {
            starts.push_back({m.place, evaluate(Eigen::Vector3d(m.place))});
        }
        if (int(starts.size()) == settings_.nStarts)
        {
            break;
        }
    }

    return starts;
}


slopeStability::minimum slopeStability::searchDirection::localSearch
(
    const minimum& start,
    const std::vector<int>& free,
    const double size,
    const double tolerance
) const
{
    const auto whole = [&](const Eigen::VectorXd& part)
    {
        Eigen::Vector3d place = start.place;
        for (std::size_t i = 0; i < free.size(); ++i)
        {
            place[free[i]] = part[Eigen::Index(i)];
        }
        return place;
    };

    Eigen::VectorXd part(Eigen::Index(free.size()));
    for (std::size_t i = 0; i < free.size(); ++i)
    {
        part[Eigen::Index(i)] = start.place[free[i]];
    }

    const minimum found = nelderMead
    (
        [&](const Eigen::VectorXd& x) { return evaluate(whole(x)); },
        {part, start.value},
        size,
        tolerance
    );

    return {whole(found.place), found.value};
}


slopeStability::minimum slopeStability::searchDirection::searchAtBends
(
    const minimum& start
) const
{
    minimum best = start;

    for (const int end : {1, 0})
    {
        const double low = end == 0 ? entryMin_ : exitMin_;
        const double high = end == 0 ? entryMax_ : exitMax_;

        for (const double bend : bends_)
        {
            minimum held = best;
            held.place[end] = (bend - low)/step_;
            if
            (
                bend < low
             || bend > high
             || std::abs(held.place[end] - best.place[end]) > 1
            )
            {
                continue;
            }

            held.value = evaluate(Eigen::Vector3d(held.place));
            if (held.value == infinity)
            {
                continue;
            }
            held = localSearch(held, {1 - end, 2}, 0.3, fine);
            if (held.value < best.value)
            {
                best = held;
            }
        }
    }

    return best;
}


slopeStability::slipResult slopeStability::searchDirection::describe
(
    const minimum& best
) const
{
    const slipArc arc = *arcAt(best.place);
    equilibrium answer;
    evaluate(arc, method_, answer);

    slipResult result = counts_;
    result.found = true;
    result.FOS = answer.FOS;
    result.lambda = answer.lambda;
    result.entry = arc.entry();
    result.exit = arc.exit();
    result.depth = family_.depth(arc);
    result.nSlices = settings_.nSlices;

    const auto isAt = [this](const double x, const double limit)
    {
        return std::abs(x - limit) <= 1e-3*step_;
    };
    const double entryX = arc.entry().x();
    const double exitX = arc.exit().x();
    result.entryAtLimit = isAt(entryX, entryMin_) || isAt(entryX, entryMax_);
    result.exitAtLimit = isAt(exitX, exitMin_) || isAt(exitX, exitMax_);

    // A surface that turns by less is a plane to double precision
    const double plane = 1e-7;
    result.radius = arc.halfAngle() > plane ? 1/arc.curvature() : 0;
    if (result.radius > 0)
    {
        result.centre = arc.centre();
    }

    return result;
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::searchDirection::searchDirection
(
    const slopeSection& section,
    const searchSettings& settings,
    const stabilityMethod& method
)
:
    section_(section),
    settings_(settings),
    method_(method),
    family_(section_, settings.minDepth),
    entryMin_(std::max(settings.entryMin, section.ground().xMin())),
    entryMax_(std::min(settings.entryMax, section.ground().xMax())),
    exitMin_(std::max(settings.exitMin, section.ground().xMin())),
    exitMax_(std::min(settings.exitMax, section.ground().xMax())),
    step_
    (
        std::max(entryMax_ - entryMin_, exitMax_ - exitMin_)
       /(settings.nPlaces - 1)
    ),
    bends_(),
    counts_()
{
    counts_.method = method.name();
    findBends();
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

slopeStability::slipResult slopeStability::searchDirection::find() const
{
    if (entryMin_ >= entryMax_ || exitMin_ >= exitMax_)
    {
        return counts_;
    }

    std::vector<minimum> found = gridSearch();
    if (found.empty())
    {
        return counts_;
    }

    for (minimum& m : found)
    {
        if (m.value < infinity)
        {
            m = localSearch(m, {0, 1, 2}, 0.7, coarse);
        }
    }
    std::stable_sort
    (
        found.begin(),
        found.end(),
        [](const minimum& a, const minimum& b) { return a.value < b.value; }
    );
    found.resize(std::min(nRefined, found.size()));

    minimum best = found.front();
    if (best.value == infinity)
    {
        return counts_;
    }
    for (const minimum& m : found)
    {
        if (m.value == infinity)
        {
            continue;
        }
        const minimum refined =
            searchAtBends(localSearch(m, {0, 1, 2}, 0.1, fine));
        if (refined.value < best.value)
        {
            best = refined;
        }
    }

    return describe(best);
}


// ************************************************************************* //
