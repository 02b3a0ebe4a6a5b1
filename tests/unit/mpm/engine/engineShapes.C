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

#include "mpmShapeFunctions.H"

#include <doctest/doctest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Round-off of a handful of additions of numbers of order one
constexpr double roundOff = 1e-15;

//- Half the length of a point of which nothing is a multiple, in cells
constexpr double halfSize = 0.17;

template<class Shape, class Check>
void everywhere(const Check& check)
{
    for (double xi = -3.05; xi < 3; xi += 0.1)
    {
        const double base = Shape::base(xi);
        double w[Shape::width], g[Shape::width];
        mpm::evaluate<Shape>(xi - base, halfSize, w, g);
        check(xi, base, w, g);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE_TEMPLATE
(
    "shape functions: unity, linear completeness, gradients",
    Shape,
    mpm::QuadraticBSpline,
    mpm::CubicBSpline,
    mpm::GIMPShape,
    mpm::LinearShape
)
{
    everywhere<Shape>
    (
        [](const double xi, const double base, const double* w, const double* g)
        {
            double sum = 0, first = 0, slope = 0, unit = 0;
            for (int i = 0; i < Shape::width; ++i)
            {
                CHECK(w[i] >= 0);
                sum += w[i];
                first += w[i]*(base + i - xi);
                slope += g[i];
                unit += g[i]*(base + i - xi);
            }
            CHECK(std::fabs(sum - 1) <= 4*roundOff);
            CHECK(std::fabs(first) <= 8*roundOff);
            CHECK(std::fabs(slope) <= 8*roundOff);
            CHECK(std::fabs(unit - 1) <= 8*roundOff);

            // Central difference of a polynomial of degree two: exact but for
            // round-off over the step; of degree three, whose third derivative
            // is 3 at most, to half the square of the step more
            const double step = 1e-4;
            const double bound =
                1e-11 + (Shape::width > 3 ? 0.5*step*step : 0);
            double below[Shape::width], above[Shape::width], unused[4];
            mpm::evaluate<Shape>(xi - base - step, halfSize, below, unused);
            mpm::evaluate<Shape>(xi - base + step, halfSize, above, unused);
            for (int i = 0; i < Shape::width; ++i)
            {
                const double slopeOfWeight = (above[i] - below[i])/(2*step);
                CHECK(std::fabs(slopeOfWeight - g[i]) <= bound);
            }
        }
    );
}


TEST_CASE_TEMPLATE
(
    "shape functions: second moments",
    Shape,
    mpm::QuadraticBSpline,
    mpm::CubicBSpline,
    mpm::LinearShape
)
{
    everywhere<Shape>
    (
        [](const double xi, const double base, const double* w, const double*)
        {
            double second = 0;
            for (int i = 0; i < Shape::width; ++i)
            {
                second += w[i]*(base + i - xi)*(base + i - xi);
            }
            const double f = xi - base;
            const double expected =
                Shape::secondMoment > 0 ? Shape::secondMoment : f*(1 - f);
            CHECK(std::fabs(second - expected) <= 8*roundOff);
        }
    );
}


TEST_CASE("GIMP lies between the linear shape and the quadratic B-spline")
{
    for (double f = 0.55; f < 1.5; f += 0.1)
    {
        double w[3], g[3], expected[3], slope[3];

        // A point as long as a cell
        mpm::evaluate<mpm::GIMPShape>(f, 0.5, w, g);
        mpm::evaluate<mpm::QuadraticBSpline>(f, 0, expected, slope);
        for (int i = 0; i < 3; ++i)
        {
            CHECK(std::fabs(w[i] - expected[i]) <= 2*roundOff);
            CHECK(std::fabs(g[i] - slope[i]) <= 2*roundOff);
        }

        // A point without length: the hat
        mpm::evaluate<mpm::GIMPShape>(f, 1e-9, w, g);
        for (int i = 0; i < 3; ++i)
        {
            const double hat = std::max(0.0, 1 - std::fabs(f - i));
            CHECK(std::fabs(w[i] - hat) <= 2*roundOff);
        }
    }
}


TEST_CASE("shape functions: supports meet where points change cells")
{
    // A quarter of the way across, the B-spline touches the nodes 0, 1, 2 of
    // 0.75 and the nodes -1, 0, 1 of 0.25
    CHECK(mpm::QuadraticBSpline::base(0.75) == 0);
    CHECK(mpm::QuadraticBSpline::base(0.25) == -1);
    CHECK(mpm::LinearShape::base(0.25) == 0);
    CHECK(mpm::LinearShape::base(-0.25) == -1);
}


// ************************************************************************* //
