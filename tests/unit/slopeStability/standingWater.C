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

namespace
{

const polyline ground({{0, 12}, {20, 12}, {40, 2}, {60, 2}}, "ground");
const double gammaSaturated = 20e3;
const double cohesion = 6e3;
const double phi = 30;

//- Saturated soil under a table at this height, dry strength above it
slopeSection withTable(const double table)
{
    const auto state = [table](const point& p)
    {
        const double uw = std::max(0.0, gammaWater*(table - p.y()));
        return soilState
        {
            gammaSaturated, cohesion - uw*tanDeg(phi), tanDeg(phi)
        };
    };

    slopeSection section
    (
        ground, level(ground, -10), std::make_shared<functionProfile>(state)
    );

    // Depth of the water on the ground, with its shore a point of the line
    std::vector<point> depth;
    const double shore = 20 + 2*(12 - table);
    for (const double x : {0.0, 20.0, shore, 40.0, 60.0})
    {
        if (depth.empty() || x > depth.back().x())
        {
            depth.emplace_back(x, std::max(0.0, table - ground.y(x)));
        }
    }
    section.setPond(polyline(depth, "pond"), gammaWater);

    return section;
}

const slipArc arc({14, 12}, {44, 2}, 36*M_PI/180);

} // End anonymous namespace

TEST_CASE("A slope under water is a dry slope of buoyant weight")
{
    // Level water above the crest: only the buoyant weight and c', phi' count,
    // exactly so for moments; slices leave O(1/n^2) at the bends
    const slopeSection wet = withTable(15);
    const slopeSection buoyant
    (
        ground,
        level(ground, -10),
        uniform(gammaSaturated - gammaWater, cohesion, phi)
    );

    for (const std::string& method : stabilityMethod::names())
    {
        CAPTURE(method);
        CHECK(onSurface(wet, method, arc, 2000)
            == doctest::Approx(onSurface(buoyant, method, arc, 2000))
               .epsilon(1e-3));
    }
    CHECK(critical(wet, "bishop").FOS
        == doctest::Approx(critical(buoyant, "bishop").FOS).epsilon(5e-3));
}

TEST_CASE("A table inside the slope: cf' < 0 is Bishop's effective stress")
{
    // Bishop's formula with u in it, on the same circle
    const double table = 8;
    const slopeSection section = withTable(table);
    const int n = 400;

    double F = 1;
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        double resisting = 0;
        double driving = 0;
        double xUpper = arc.entry().x();
        for (int i = 0; i < n; ++i)
        {
            const double f = (i + 0.5)/n;
            const point p = arc.at(f);
            const double xLower = arc.at((i + 1.0)/n).x();
            const double b = xLower - xUpper;
            const double alpha = arc.inclination(f);
            const double pond = std::max(0.0, table - ground.y(p.x()));
            const double u = std::max(0.0, gammaWater*(table - p.y()));
            const double W =
                (gammaSaturated*(ground.y(p.x()) - p.y()) + gammaWater*pond)*b;
            const double H =
                gammaWater*pond*(ground.y(xLower) - ground.y(xUpper));

            resisting += (cohesion*b + (W - u*b)*tanDeg(phi))
               /(std::cos(alpha) + std::sin(alpha)*tanDeg(phi)/F);
            driving += W*std::sin(alpha)
              + H*(arc.centre().y() - ground.y(p.x()))*arc.curvature();
            xUpper = xLower;
        }
        F = resisting/driving;
    }

    CHECK(onSurface(section, "bishop", arc, n)
        == doctest::Approx(F).epsilon(1e-9));

    // The wrong sign of cf' under water would be stronger than a dry slope
    CHECK(F < onSurface(withTable(-9), "bishop", arc, n));
}

TEST_CASE("Water at the toe holds, water inside the slope weakens")
{
    const slopeSection drained = withTable(-9);
    const slopeSection full = withTable(8);

    // The same ground water without the pool in front
    const slopeSection rapidDrawdown
    (
        ground,
        level(ground, -10),
        std::make_shared<functionProfile>
        (
            [&](const point& p) { return full.soil().at(p); }
        )
    );

    for (const char* method : {"bishop", "spencer"})
    {
        const double drawdown = critical(rapidDrawdown, method).FOS;
        CHECK(drawdown < 0.8*critical(full, method).FOS);
        CHECK(drawdown < 0.8*critical(drained, method).FOS);
    }
}

TEST_CASE("A depth of water below zero is refused")
{
    slopeSection section = withTable(0);
    CHECK_THROWS_AS
    (
        section.setPond(polyline({{0, 0}, {60, -1}}, "pond"), gammaWater),
        std::invalid_argument
    );
}

// ************************************************************************* //
