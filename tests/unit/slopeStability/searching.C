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
#include "rasterProfile.H"

#include <doctest/doctest.h>

using namespace testSections;

// The simplex stops when it is 1e-7 of the grid's step large
const double same = 1e-6;

TEST_CASE("Mirrored and shifted slopes have the same factor of safety")
{
    for (const char* method : {"bishop", "spencer"})
    {
        CAPTURE(method);
        const double cohesion = method == std::string("bishop") ? 0 : 10e3;
        const slopeSection section = validationSlope(cohesion, 30);

        const slipResult here = critical(section, method);
        const slipResult there = critical(section.mirrored(), method);
        const slipResult far =
            critical(validationSlope(cohesion, 30, 1234.5), method);

        CHECK(there.FOS == doctest::Approx(here.FOS).epsilon(same));
        CHECK(there.centre.x() == doctest::Approx(-here.centre.x()));
        CHECK(there.entry.x() == doctest::Approx(-here.entry.x()));
        CHECK(far.FOS == doctest::Approx(here.FOS).epsilon(same));
    }
}

TEST_CASE("Minimum depth is measured normal to the ground and binds")
{
    // Without cohesion the shallowest circle is the worst
    const polyline ground({{-20, 20}, {0, 20}, {40, 0}, {60, 0}}, "ground");
    const slopeSection section(ground, level(ground, -10), uniform(18e3, 0, 30));

    double previous = 0;
    for (const double depth : {0.5, 1.0, 2.0, 4.0})
    {
        searchSettings settings;
        settings.minDepth = depth;
        const slipResult found = critical(section, "bishop", settings);

        // Looked at on 32 points of the surface
        CHECK(found.depth == doctest::Approx(depth).epsilon(1e-3));
        CHECK(found.FOS > previous);
        previous = found.FOS;
    }
}

TEST_CASE("Entry and exit stay within their limits")
{
    const slopeSection section = validationSlope(10e3, 30);
    const double free = critical(section, "bishop").FOS;

    searchSettings settings;
    settings.entryMax = -25;
    settings.exitMin = 2;
    const slipResult found = critical(section, "bishop", settings);

    CHECK(found.entry.x() <= -25);
    CHECK(found.exit.x() >= 2);
    CHECK(found.FOS > free);
    CHECK(found.entryAtLimit);
    CHECK(found.exitAtLimit);
}

TEST_CASE("No circle crosses the base")
{
    const polyline ground({{0, 35}, {18, 35}, {48, 15}, {66, 15}}, "ground");
    const slopeSection section
    (
        ground, level(ground, 14.6), uniform(18.82e3, 41.65e3, 15)
    );

    const slipResult found = critical(section, "bishop");
    CHECK(found.centre.y() - found.radius > 14.6 - 1e-6);
    // Without this base 1.404 with a circle down to y = 14.2
    CHECK(found.FOS > 1.405);
}

TEST_CASE("Slopes to both sides: the worse one is found")
{
    // An embankment whose right face is steeper
    const polyline ground
    (
        {{-40, 0}, {-25, 0}, {-5, 10}, {5, 10}, {15, 0}, {40, 0}}, "ground"
    );
    const slopeSection section
    (
        ground, level(ground, -8), uniform(19e3, 8e3, 28)
    );

    const slipResult found = critical(section, "spencer");
    CHECK(found.entry.x() < found.exit.x());

    const slipResult turned = critical(section.mirrored(), "spencer");
    CHECK(turned.entry.x() > turned.exit.x());
    CHECK(turned.FOS == doctest::Approx(found.FOS).epsilon(same));
}

TEST_CASE("A weak layer draws the circle down")
{
    const polyline ground({{0, 12}, {25, 12}, {45, 0}, {70, 0}}, "ground");
    const auto layered = [](const point& p)
    {
        return p.y() > -3 || p.y() < -5
          ? soilState{19e3, 20e3, tanDeg(30)}
          : soilState{19e3, 5e3, tanDeg(8)};
    };
    const slopeSection section
    (
        ground, level(ground, -10), std::make_shared<functionProfile>(layered, 24)
    );
    const slopeSection strong
    (
        ground, level(ground, -10), uniform(19e3, 20e3, 30)
    );

    const slipResult found = critical(section, "bishop");
    CHECK(found.FOS < 0.8*critical(strong, "bishop").FOS);
    CHECK(found.centre.y() - found.radius < -3);
}

TEST_CASE("A raster of samples gives what the function gives")
{
    const slopeSection exact = validationSlope(0, 30);
    const std::vector<double> x =
        rasterProfile::columns(exact.ground(), exact.base(), 0.5);
    const polyline top = rasterProfile::resampled(exact.ground(), x);
    const polyline bottom = rasterProfile::resampled(exact.base(), x);

    std::vector<soilState> states;
    for (const point& p : rasterProfile::nodes(top, bottom, 61))
    {
        states.push_back(exact.soil().at(p));
    }
    const slopeSection sampled
    (
        exact.ground(),
        exact.base(),
        std::make_shared<rasterProfile>(top, bottom, states)
    );

    // cf' is curved between samples 0.5 m apart
    CHECK(critical(sampled, "bishop").FOS
        == doctest::Approx(critical(exact, "bishop").FOS).epsilon(1e-3));

    // Where all is linear the raster is exact
    const double W = sampled.soil().overburden({-20, 3}, 20);
    CHECK(W == doctest::Approx(exact.soil().overburden({-20, 3}, 20))
        .epsilon(1e-4));
}

TEST_CASE("Level ground has no slip surface and says why not")
{
    const polyline ground({{0, 0}, {50, 0}}, "ground");
    const slopeSection section
    (
        ground, level(ground, -10), uniform(19e3, 5e3, 30)
    );

    CHECK_FALSE(critical(section, "bishop").found);
    CHECK_FALSE(critical(section, "spencer").found);
}

TEST_CASE("Rough ground of many points is searched")
{
    // The validation slope with a ripple of 5 cm, as a mesh would cut it
    std::vector<point> points;
    const slopeSection smooth = validationSlope(10e3, 30);
    for (int i = 0; i <= 140; ++i)
    {
        const double x = -46 + 0.5*i;
        points.emplace_back
        (
            x, smooth.ground().y(x) + (i % 2 == 0 ? 0.0 : 0.05)
        );
    }
    const slopeSection rough
    (
        polyline(points, "ground"),
        smooth.base(),
        std::make_shared<functionProfile>
        (
            [&](const point& p) { return smooth.soil().at(p); }
        )
    );

    // 5 cm of 5.7 m of depth
    CHECK(critical(rough, "bishop").FOS
        == doctest::Approx(critical(smooth, "bishop").FOS).epsilon(0.01));
}

TEST_CASE("Wrong input is named")
{
    CHECK_THROWS_WITH_AS
    (
        stabilityMethod::New("janbu"),
        "Unknown method of slope stability \"janbu\". Valid methods: bishop "
        "morgensternPrice spencer",
        std::invalid_argument
    );
    CHECK_THROWS_AS(polyline({{0, 0}}, "ground"), std::invalid_argument);
    CHECK_THROWS_AS
    (
        polyline({{0, 0}, {0, 5}}, "ground"),
        std::invalid_argument
    );

    const polyline ground({{0, 10}, {20, 0}}, "ground");
    CHECK_THROWS_AS
    (
        slopeSection(ground, level(ground, 5), uniform(19e3, 0, 30)),
        std::invalid_argument
    );

    searchSettings settings;
    settings.minDepth = -1;
    CHECK_THROWS_AS(settings.check(), std::invalid_argument);
    settings = searchSettings();
    settings.entryMin = 5;
    settings.entryMax = 4;
    CHECK_THROWS_AS(settings.check(), std::invalid_argument);
}

// ************************************************************************* //
