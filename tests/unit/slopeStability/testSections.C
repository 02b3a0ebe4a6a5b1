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

#include "testSections.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

slopeStability::slopeSection testSections::validationSlope
(
    const double cohesion,
    const double phi,
    const double shift
)
{
    // Zhu2022 Table 1
    const double rhoDry = 1695;
    const double thetaS = 0.36;
    const double thetaR = 0.035;
    const double alpha = 0.538;
    const double m = 0.468;

    const double g = 9.81;
    const double table = -5;
    const double tanPhi = tanDeg(phi);

    const auto state = [=](const point& p)
    {
        const double head = table - p.y();
        const double Se =
            head < 0
          ? std::pow(1 + std::pow(-alpha*head, 1/(1 - m)), -m)
          : 1.0;
        const double theta = thetaR + Se*(thetaS - thetaR);

        // Zhu2022 Eq. 6
        return soilState
        {
            g*(rhoDry + 1000*theta),
            cohesion - Se*gammaWater*head*tanPhi,
            tanPhi
        };
    };

    const polyline ground
    (
        {{shift - 46, 20}, {shift - 16, 20}, {shift, 0}, {shift + 24, 0}},
        "ground"
    );

    return slopeSection
    (
        ground,
        level(ground, -10),
        std::make_shared<functionProfile>(state)
    );
}


// ************************************************************************* //
