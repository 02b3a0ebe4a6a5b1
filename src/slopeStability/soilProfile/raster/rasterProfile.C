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

#include "rasterProfile.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

slopeStability::rasterProfile::place slopeStability::rasterProfile::find
(
    const point& p
) const
{
    place result;

    result.column = ground_.segment(p.x());
    const double left = ground_.points()[result.column].x();
    const double right = ground_.points()[result.column + 1].x();
    result.columnWeight =
        std::clamp((p.x() - left)/(right - left), 0.0, 1.0);

    const double bottom = base_.y(p.x());
    const double height = ground_.y(p.x()) - bottom;
    const double row =
        std::clamp((p.y() - bottom)/height, 0.0, 1.0)*double(nNodes_ - 1);
    result.node = std::min(std::size_t(row), nNodes_ - 2);
    result.nodeWeight = row - double(result.node);

    return result;
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::rasterProfile::rasterProfile
(
    const polyline& ground,
    const polyline& base,
    std::vector<soilState> states
)
:
    ground_(ground),
    base_(base),
    nNodes_(states.size()/ground.points().size()),
    states_(std::move(states)),
    weights_(states_.size(), 0.0)
{
    const std::size_t nColumns = ground_.points().size();

    if
    (
        base_.points().size() != nColumns
     || nNodes_ < 2
     || states_.size() != nColumns*nNodes_
    )
    {
        throw std::invalid_argument
        (
            "A raster of soil needs as many columns at the base ("
          + std::to_string(base_.points().size()) + ") as at the ground ("
          + std::to_string(nColumns) + ") and the same number of nodes, 2 or "
            "more, in each; there are " + std::to_string(states_.size())
          + " nodes"
        );
    }

    for (std::size_t i = 0; i < nColumns; ++i)
    {
        const point& top = ground_.points()[i];
        const point& bottom = base_.points()[i];

        if (top.x() != bottom.x() || top.y() <= bottom.y())
        {
            throw std::invalid_argument
            (
                "Column " + std::to_string(i) + " of the raster of soil at "
                "x = " + std::to_string(top.x()) + " has its base at ("
              + std::to_string(bottom.x()) + ", "
              + std::to_string(bottom.y()) + "), which is not under its "
                "ground at y = " + std::to_string(top.y())
            );
        }

        const double step = (top.y() - bottom.y())/double(nNodes_ - 1);
        for (std::size_t j = nNodes_ - 1; j-- > 0;)
        {
            const std::size_t k = i*nNodes_ + j;
            weights_[k] =
                weights_[k + 1]
              + 0.5*step*(states_[k].unitWeight + states_[k + 1].unitWeight);
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

std::vector<double> slopeStability::rasterProfile::columns
(
    const polyline& ground,
    const polyline& base,
    const double spacing
)
{
    if (!(spacing > 0))
    {
        throw std::invalid_argument
        (
            "The columns of a raster of soil need a spacing > 0, not "
          + std::to_string(spacing)
        );
    }

    std::vector<double> x;
    for (const polyline* line : {&ground, &base})
    {
        for (const point& p : line->points())
        {
            if (p.x() >= ground.xMin() && p.x() <= ground.xMax())
            {
                x.push_back(p.x());
            }
        }
    }
    std::sort(x.begin(), x.end());

    // Points closer than this share a column
    const double closest = 1e-6*spacing;

    std::vector<double> filled(1, x.front());
    for (const double next : x)
    {
        const double previous = filled.back();
        const double gap = next - previous;
        if (gap <= closest)
        {
            continue;
        }

        const int n = int(std::ceil(gap/spacing - 1e-9));
        for (int i = 1; i < n; ++i)
        {
            filled.push_back(previous + i*gap/n);
        }
        filled.push_back(next);
    }

    return filled;
}


std::vector<slopeStability::point> slopeStability::rasterProfile::nodes
(
    const polyline& ground,
    const polyline& base,
    const std::size_t nNodes
)
{
    std::vector<point> result;
    result.reserve(nNodes*ground.points().size());

    for (std::size_t i = 0; i < ground.points().size(); ++i)
    {
        const double top = ground.points()[i].y();
        const double bottom = base.points()[i].y();

        for (std::size_t j = 0; j < nNodes; ++j)
        {
            const double w = double(j)/double(nNodes - 1);
            result.emplace_back
            (
                ground.points()[i].x(),
                (1 - w)*bottom + w*top
            );
        }
    }

    return result;
}


slopeStability::polyline slopeStability::rasterProfile::resampled
(
    const polyline& line,
    const std::vector<double>& x
)
{
    std::vector<point> points;
    points.reserve(x.size());
    for (const double xi : x)
    {
        points.emplace_back(xi, line.y(xi));
    }

    return polyline(std::move(points), "resampled");
}


slopeStability::soilState slopeStability::rasterProfile::at
(
    const point& p
) const
{
    const place where = find(p);
    const std::size_t left = where.column*nNodes_ + where.node;
    const std::size_t right = left + nNodes_;

    const double wx = where.columnWeight;
    const double wy = where.nodeWeight;
    const double w[4] =
        {(1 - wx)*(1 - wy), (1 - wx)*wy, wx*(1 - wy), wx*wy};
    const soilState* s[4] =
    {
        &states_[left], &states_[left + 1],
        &states_[right], &states_[right + 1]
    };

    soilState result{0, 0, 0};
    for (int i = 0; i < 4; ++i)
    {
        result.unitWeight += w[i]*s[i]->unitWeight;
        result.cohesionIntercept += w[i]*s[i]->cohesionIntercept;
        result.tanPhi += w[i]*s[i]->tanPhi;
    }

    return result;
}


double slopeStability::rasterProfile::overburden
(
    const point& p,
    const double
) const
{
    const place where = find(p);
    const std::size_t left = where.column*nNodes_ + where.node;
    const std::size_t right = left + nNodes_;

    const double wx = where.columnWeight;
    const double wy = where.nodeWeight;

    return
        (1 - wx)*((1 - wy)*weights_[left] + wy*weights_[left + 1])
      + wx*((1 - wy)*weights_[right] + wy*weights_[right + 1]);
}


// ************************************************************************* //
