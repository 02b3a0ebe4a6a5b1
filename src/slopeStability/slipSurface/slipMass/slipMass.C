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

#include "slipMass.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

slopeStability::slipMass::slipMass
(
    const slopeSection& section,
    const slipArc& arc,
    const int nSlices
)
:
    slices_(),
    driving_(0),
    weight_(0)
{
    slices_.reserve(nSlices);

    const double length = arc.exit().x() - arc.entry().x();
    double xUpper = arc.entry().x();
    double groundUpper = section.ground().y(xUpper);

    for (int i = 0; i < nSlices; ++i)
    {
        const double middle = (i + 0.5)/nSlices;
        const double xLower = arc.at((i + 1.0)/nSlices).x();
        const double groundLower = section.ground().y(xLower);
        const double width = xLower - xUpper;

        const point base = arc.at(middle);
        const double alpha = arc.inclination(middle);
        const double ground = section.ground().y(base.x());
        const double depth = std::max(0.0, ground - base.y());

        const soilState soil = section.soil().at(base);
        const double pressure = section.pondPressure(base.x());

        slice s;
        s.sinAlpha = std::sin(alpha);
        s.cosAlpha = std::cos(alpha);
        s.weight =
            width
           *(section.soil().overburden(base, base.y() + depth) + pressure);
        s.thrust = pressure*(groundLower - groundUpper);
        s.thrustLever = s.cosAlpha - depth*arc.curvature();
        s.cohesion = soil.cohesionIntercept*width/s.cosAlpha;
        s.tanPhi = soil.tanPhi;
        s.lowerSide = (xLower - arc.entry().x())/length;
        slices_.push_back(s);

        driving_ += s.weight*s.sinAlpha + s.thrust*s.thrustLever;
        weight_ += s.weight;

        xUpper = xLower;
        groundUpper = groundLower;
    }
}


// ************************************************************************* //
