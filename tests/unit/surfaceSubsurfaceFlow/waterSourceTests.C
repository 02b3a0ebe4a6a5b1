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

Description
    The stress of roots.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "feddesStress.H"
#include "IStringStream.H"

using doctest::Approx;
using Foam::scalar;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Feddes' stress is a trapezoid, and its slope belongs to it")
{
    const Foam::feddesStress stress
    (
        Foam::dictionary
        (
            Foam::IStringStream("stressHeads (-0.1 -0.3 -8 -160);")()
        )
    );

    CHECK(stress.value(1) == 0);
    CHECK(stress.value(-0.1) == 0);
    CHECK(stress.value(-0.2) == Approx(0.5));
    CHECK(stress.value(-0.3) == 1);
    CHECK(stress.value(-8) == 1);
    CHECK(stress.value(-84) == Approx(0.5));
    CHECK(stress.value(-160) == 0);
    CHECK(stress.value(-1e6) == 0);

    for (const scalar h : {-0.05, -0.2, -3.0, -20.0, -150.0, -200.0})
    {
        const scalar d = 1e-6;
        CHECK
        (
            (stress.value(h + d) - stress.value(h - d))/(2*d)
         == Approx(stress.slope(h)).epsilon(1e-6)
        );
    }
}


TEST_CASE("Roots that need no air take water from saturated soil")
{
    const Foam::feddesStress stress
    (
        Foam::dictionary(Foam::IStringStream("stressHeads (0 0 -8 -160);")())
    );

    CHECK(stress.value(0) == 1);
    CHECK(stress.value(7) == 1);
    CHECK(stress.slope(7) == 0);
}

// ************************************************************************* //
