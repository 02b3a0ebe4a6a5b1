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

#include "slopeSection.H"

#include <algorithm>
#include <stdexcept>

// * * * * * * * * * * * * * * Local Helpers  * * * * * * * * * * * * * * //

namespace
{

//- Soil seen with x reversed
class mirroredProfile
:
    public slopeStability::soilProfile
{
    std::shared_ptr<const slopeStability::soilProfile> soil_;

public:

    explicit mirroredProfile
    (
        std::shared_ptr<const slopeStability::soilProfile> soil
    )
    :
        soil_(std::move(soil))
    {}

    slopeStability::soilState at
    (
        const slopeStability::point& p
    ) const override
    {
        return soil_->at({-p.x(), p.y()});
    }

    double overburden
    (
        const slopeStability::point& p,
        const double ground
    ) const override
    {
        return soil_->overburden({-p.x(), p.y()}, ground);
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::slopeSection::slopeSection
(
    const polyline& ground,
    const polyline& base,
    std::shared_ptr<const soilProfile> soil
)
:
    ground_(ground),
    base_(base),
    soil_(std::move(soil)),
    pondPressure_()
{
    if (!soil_)
    {
        throw std::invalid_argument("The section has no soil");
    }

    // Heights that differ by less are the same point of a polyline
    const double tolerance =
        1e-9*std::max(1.0, ground_.xMax() - ground_.xMin());

    for (const polyline* line : {&ground_, &base_})
    {
        for (const point& p : line->points())
        {
            const double top = ground_.y(p.x());
            const double bottom = base_.y(p.x());
            if (bottom > top + tolerance)
            {
                throw std::invalid_argument
                (
                    "The base of the section at x = "
                  + std::to_string(p.x()) + " has y = "
                  + std::to_string(bottom) + ", above the ground at y = "
                  + std::to_string(top)
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void slopeStability::slopeSection::setPond
(
    const polyline& depth,
    const double unitWeight
)
{
    std::vector<point> pressure = depth.points();
    bool wet = false;

    for (point& p : pressure)
    {
        if (p.y() < 0)
        {
            throw std::invalid_argument
            (
                "The depth of water on the ground at x = "
              + std::to_string(p.x()) + " is "
              + std::to_string(p.y()) + " m; it must be >= 0"
            );
        }
        wet = wet || p.y() > 0;
        p.y() *= unitWeight;
    }

    pondPressure_ =
        wet
      ? std::make_shared<const polyline>(std::move(pressure), "pond")
      : nullptr;
}


slopeStability::slopeSection slopeStability::slopeSection::mirrored() const
{
    slopeSection result
    (
        ground_.mirrored(),
        base_.mirrored(),
        std::make_shared<const mirroredProfile>(soil_)
    );

    if (pondPressure_)
    {
        result.pondPressure_ =
            std::make_shared<const polyline>(pondPressure_->mirrored());
    }

    return result;
}


// ************************************************************************* //
