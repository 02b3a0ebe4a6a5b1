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

#include "slopeStates.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace slopeStates
{
namespace
{

//- Height of the ground
double ground(const double x)
{
    return std::fmin(height, std::fmax(0, -x/0.8));
}


//- Effective saturation by van Genuchten, Zhu2022 Eq. 10
double saturation(const double psi)
{
    const double alpha = 0.538, m = 0.468;
    return
        psi >= 0
      ? 1
      : std::pow(1 + std::pow(-alpha*psi, 1/(1 - m)), -m);
}


//- Pressure p_w = chi u_w above a table at y = -5
double porePressure(const double y)
{
    const double psi = -5 - y;
    return saturation(psi)*1000*verification::gravity*psi;
}


double intercept(const State& state, const double y)
{
    return
        state.cohesion
      - porePressure(y)*std::tan(verification::degree*state.phi);
}

} // End anonymous namespace
} // End namespace slopeStates


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::unique_ptr<mpm::Run> slopeStates::slope
(
    const State& state,
    const double cellSize,
    const double dilationAngle,
    mpm::StartReport& report,
    const mpm::Settings& numerics
)
{
    using namespace verification;

    mpm::Settings settings = numerics;
    settings.cellSize = cellSize;
    settings.gravity = {{0, -gravity, 0}};

    const double left = -46, right = 24, base = -10;
    mpm::PointData points = seed
    (
        2,
        cellSize,
        2,
        {{left, base, 0}},
        {{right, height, 0}},
        [](const mpm::Point3& x) { return x[1] < ground(x[0]); },
        1
    );

    // No less than the state's own, where that has been raised (F < 1)
    const State stable
    {
        stateA.cohesion, std::fmax(stateA.phi, state.phi), stateA.bishop
    };
    mpm::StartSettings start;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double y = points.position[i][1];
        const double rhoDry = 1695, thetaS = 0.36, thetaR = 0.035;
        points.rho[i] =
            rhoDry + 1000*(thetaR + saturation(-5 - y)*(thetaS - thetaR));
        points.porePressure.push_back(porePressure(y));
        points.cohesionIntercept.push_back(intercept(state, y));
        points.frictionAngle.push_back(state.phi);
        start.stableCohesionIntercept.push_back(intercept(stable, y));
        start.stableFrictionAngle.push_back(stable.phi);
    }

    mpm::Material soil;
    soil.E = E;
    soil.nu = 0.3;
    soil.dilationAngle = dilationAngle;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {soil},
        {
            plane("base", "rough", {{0, base, 0}}, {{0, 1, 0}}),
            plane("left", "roller", {{left, 0, 0}}, {{1, 0, 0}}),
            plane("right", "roller", {{right, 0, 0}}, {{-1, 0, 0}})
        }
    );
    report = run->establishStart(start);
    return run;
}


std::unique_ptr<mpm::Run> slopeStates::associatedSlope
(
    const State& state,
    const double cellSize,
    const double F,
    const std::string& antiLocking
)
{
    const double phi =
        std::atan(std::tan(verification::degree*state.phi)/F)
       /verification::degree;

    mpm::Settings numerics;
    numerics.antiLocking = antiLocking;
    mpm::StartReport report;
    return slope({state.cohesion/F, phi, 1}, cellSize, phi, report, numerics);
}

// ************************************************************************* //
