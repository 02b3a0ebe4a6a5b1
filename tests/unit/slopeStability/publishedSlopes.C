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

// Expected values: an independent limit-equilibrium calculator, which met the
// published ones as said at each case; 0.5 % is what such programs differ by
// among each other.
const double programs = 0.005;

TEST_CASE("Griffiths and Lane 1999, example 1: slope 2:1 on a firm base")
{
    // Chart of Bishop and Morgenstern 1.380, finite elements 1.4
    const polyline ground({{0, 10}, {24, 10}, {44, 0}, {56, 0}}, "ground");
    const slopeSection section
    (
        ground, level(ground, 0), uniform(20e3, 0.05*20e3*10, 20)
    );

    CHECK(critical(section, "bishop").FOS
        == doctest::Approx(1.377).epsilon(programs));
    CHECK(critical(section, "spencer").FOS
        == doctest::Approx(1.375).epsilon(programs));
}

TEST_CASE("ACADS 1(a): homogeneous slope")
{
    // Referee 1.00
    const polyline ground({{20, 35}, {40, 35}, {60, 25}, {70, 25}}, "ground");
    const slopeSection section
    (
        ground, level(ground, 10), uniform(20e3, 3e3, 19.6)
    );

    const slipResult bishop = critical(section, "bishop");
    CHECK(bishop.FOS == doctest::Approx(0.985).epsilon(programs));
    CHECK(critical(section, "spencer").FOS
        == doctest::Approx(0.984).epsilon(programs));

    // The slope is cut at its toe
    CHECK(std::abs(bishop.exit.x() - 60) < 1);
    CHECK(bishop.found);
    CHECK(bishop.depth > 1);
    CHECK((bishop.centre - bishop.entry).norm()
        == doctest::Approx(bishop.radius).epsilon(1e-9));
}

TEST_CASE("Arai and Tagyo 1985, example 1: homogeneous slope")
{
    // Published 1.404 and 1.401 (Bishop, by several searches)
    const polyline ground({{0, 35}, {18, 35}, {48, 15}, {66, 15}}, "ground");
    const slopeSection section
    (
        ground, level(ground, 0), uniform(18.82e3, 41.65e3, 15)
    );

    CHECK(critical(section, "bishop").FOS
        == doctest::Approx(1.404).epsilon(programs));
    CHECK(critical(section, "spencer").FOS
        == doctest::Approx(1.402).epsilon(programs));

    // Methods of both equilibria differ by the interslice function only
    CHECK(critical(section, "morgensternPrice").FOS
        == doctest::Approx(critical(section, "spencer").FOS).epsilon(0.005));
}

TEST_CASE("Zhu2022 section 4, reconstructed: states a, b, c")
{
    // Independent calculator; 1 % is the gate of the reconstruction
    const double gate = 0.01;
    const slopeSection a = validationSlope(10e3, 30);
    const slopeSection b = validationSlope(0, 30);
    const slopeSection c = validationSlope(0, 20);

    const slipResult bishopA = critical(a, "bishop");
    const slipResult bishopB = critical(b, "bishop");
    const slipResult bishopC = critical(c, "bishop");

    CHECK(bishopA.FOS == doctest::Approx(1.184).epsilon(gate));
    CHECK(bishopB.FOS == doctest::Approx(0.952).epsilon(gate));
    CHECK(bishopC.FOS == doctest::Approx(0.600).epsilon(gate));
    CHECK(critical(a, "spencer").FOS == doctest::Approx(1.182).epsilon(gate));
    CHECK(critical(b, "spencer").FOS == doctest::Approx(0.949).epsilon(gate));
    CHECK(critical(c, "spencer").FOS == doctest::Approx(0.598).epsilon(gate));

    // With c' = 0 all strength is proportional to tan(phi'); the search may
    // stop 1e-7 apart on the two
    CHECK(bishopB.FOS/bishopC.FOS
        == doctest::Approx(tanDeg(30)/tanDeg(20)).epsilon(1e-6));

    // The calculator's critical circle of b; circles near the minimum differ
    // by metres at the same factor of safety
    CHECK((bishopB.centre - point(11.21, 30.10)).norm() < 3);
    CHECK(bishopB.exit.x() == doctest::Approx(0).epsilon(0.01));
}

// ************************************************************************* //
