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

#include <doctest/doctest.h>

using namespace testSections;

// Sums of the slices of a plane are exact but for round-off and the 1e-11 of
// the iteration
const double exact = 1e-9;

TEST_CASE("Infinite slope, c = 0, dry: tan(phi)/tan(beta)")
{
    const double fall = tanDeg(25);
    const polyline ground({{0, 100*fall}, {100, 0}}, "ground");
    const slopeSection section(ground, level(ground, -50), uniform(18e3, 0, 32));

    // A plane 2 m under the ground between two verticals
    const slipArc plane({20, ground.y(20) - 2}, {80, ground.y(80) - 2}, 0);

    for (const std::string& method : stabilityMethod::names())
    {
        CAPTURE(method);
        CHECK(onSurface(section, method, plane)
            == doctest::Approx(tanDeg(32)/fall).epsilon(exact));
    }

    // The search finds nothing steeper than the ground: its shallowest circle
    // is a little stronger because its ends rise
    const slipResult found = critical(section, "bishop");
    CHECK(found.FOS > tanDeg(32)/fall);
    CHECK(found.FOS < 1.05*tanDeg(32)/fall);
    CHECK(found.depth == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("Infinite slope with cf' of either sign")
{
    // F = (cf' + gamma d cos^2(beta) tan(phi))/(gamma d sin(beta) cos(beta))
    const double beta = 20*M_PI/180;
    const double depth = 3;
    const double gamma = 20e3;
    const polyline ground({{0, 100*std::tan(beta)}, {100, 0}}, "ground");
    const slipArc plane
    (
        {20, ground.y(20) - depth}, {80, ground.y(80) - depth}, 0
    );

    for (const double cohesion : {12e3, -9e3})
    {
        const slopeSection section
        (
            ground, level(ground, -50), uniform(gamma, cohesion, 35)
        );
        const double sigma = gamma*depth*std::pow(std::cos(beta), 2);
        const double expected =
            (cohesion + sigma*tanDeg(35))/(sigma*std::tan(beta));

        for (const std::string& method : stabilityMethod::names())
        {
            CAPTURE(method);
            CAPTURE(cohesion);
            CHECK(onSurface(section, method, plane)
                == doctest::Approx(expected).epsilon(exact));
        }
    }
}

TEST_CASE("Plane slide at 45 deg under a 60 deg face")
{
    // A wedge between a 60 deg face and the plane at 45 deg through its toe:
    // F = (c L + W cos(45) tan(phi))/(W sin(45))
    const double height = 10;
    const double foot = height/tanDeg(60);
    const polyline ground
    (
        {{-30, height}, {-foot, height}, {0, 0}, {20, 0}}, "ground"
    );
    const double gamma = 19e3;
    const double cohesion = 15e3;
    const slopeSection section
    (
        ground, level(ground, -20), uniform(gamma, cohesion, 28)
    );

    const double weight = gamma*0.5*height*(height - foot);
    const double expected =
        cohesion*height*std::sqrt(2)/(weight*std::sqrt(0.5)) + tanDeg(28);

    // The midpoint weights of slices with the crest in them are off by O(1/n^2)
    const slipArc plane({-height, height}, {0, 0}, 0);
    for (const std::string& method : stabilityMethod::names())
    {
        CAPTURE(method);
        CHECK(onSurface(section, method, plane, 2000)
            == doctest::Approx(expected).epsilon(1e-5));
    }
}

TEST_CASE("phi = 0: Bishop and Spencer are c R^2 angle / moment of the weight")
{
    const polyline ground({{-30, 10}, {-10, 10}, {10, 0}, {30, 0}}, "ground");
    const double gamma = 18e3;
    const double cohesion = 40e3;
    const slopeSection section
    (
        ground, level(ground, -20), uniform(gamma, cohesion, 0)
    );
    const slipArc arc({-14, 10}, {10, 0}, 40*M_PI/180);

    // Moment of the area between arc and ground about the centre, by a fine
    // sum of its own
    const double radius = 1/arc.curvature();
    const point centre = arc.centre();
    const int n = 200000;
    double moment = 0;
    for (int i = 0; i < n; ++i)
    {
        const double x = -14 + 24*(i + 0.5)/n;
        const double y = centre.y()
          - std::sqrt(radius*radius - std::pow(x - centre.x(), 2));
        moment += gamma*(ground.y(x) - y)*(centre.x() - x)*24/n;
    }
    const double expected =
        cohesion*radius*radius*2*arc.halfAngle()/moment;

    // Slices: 2000 leave O(1/n^2)
    for (const std::string& method : stabilityMethod::names())
    {
        CAPTURE(method);
        CHECK(onSurface(section, method, arc, 2000)
            == doctest::Approx(expected).epsilon(1e-5));
    }
}

// ************************************************************************* //
