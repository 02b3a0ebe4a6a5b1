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

template<class Shape, class Check>
void everywhere(const Check& check)
{
    for (double xi = -3.05; xi < 3; xi += 0.1)
    {
        const double base = Shape::base(xi);
        double w[Shape::width], g[Shape::width];
        Shape::weights(xi - base, w);
        Shape::gradients(xi - base, g);
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
            // round-off over the step
            const double step = 1e-4;
            double below[Shape::width], above[Shape::width];
            Shape::weights(xi - base - step, below);
            Shape::weights(xi - base + step, above);
            for (int i = 0; i < Shape::width; ++i)
            {
                const double slopeOfWeight = (above[i] - below[i])/(2*step);
                CHECK(std::fabs(slopeOfWeight - g[i]) <= 1e-11);
            }
        }
    );
}


TEST_CASE("shape functions: second moments")
{
    everywhere<mpm::QuadraticBSpline>
    (
        [](const double xi, const double base, const double* w, const double*)
        {
            double second = 0;
            for (int i = 0; i < 3; ++i)
            {
                second += w[i]*(base + i - xi)*(base + i - xi);
            }
            CHECK
            (
                std::fabs(second - mpm::QuadraticBSpline::secondMoment)
             <= 4*roundOff
            );
        }
    );

    everywhere<mpm::LinearShape>
    (
        [](const double xi, const double base, const double* w, const double*)
        {
            const double f = xi - base;
            const double second = w[0]*f*f + w[1]*(1 - f)*(1 - f);
            CHECK(std::fabs(second - f*(1 - f)) <= 4*roundOff);
        }
    );
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
