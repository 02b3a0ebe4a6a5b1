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

#include "functionProfile.H"

#include <cmath>
#include <stdexcept>
#include <string>

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::functionProfile::functionProfile
(
    std::function<soilState(const point&)> state,
    const int panels
)
:
    state_(std::move(state)),
    panels_(panels)
{
    if (!state_)
    {
        throw std::invalid_argument("A soil profile needs a function");
    }
    if (panels_ < 1)
    {
        throw std::invalid_argument
        (
            "A soil profile needs at least 1 panel to integrate its weight, "
            "not " + std::to_string(panels_)
        );
    }
}


slopeStability::functionProfile::functionProfile(const soilState& uniform)
:
    functionProfile([uniform](const point&) { return uniform; }, 1)
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

slopeStability::soilState slopeStability::functionProfile::at
(
    const point& p
) const
{
    return state_(p);
}


double slopeStability::functionProfile::overburden
(
    const point& p,
    const double ground
) const
{
    // Nodes of the two-point Gauss rule in a panel of unit height
    static const double node = 0.5 - std::sqrt(1.0/12.0);

    const double panel = (ground - p.y())/panels_;

    double sum = 0;
    for (int i = 0; i < panels_; ++i)
    {
        const double bottom = p.y() + i*panel;
        sum += state_({p.x(), bottom + node*panel}).unitWeight;
        sum += state_({p.x(), bottom + (1 - node)*panel}).unitWeight;
    }

    return 0.5*panel*sum;
}


// ************************************************************************* //
