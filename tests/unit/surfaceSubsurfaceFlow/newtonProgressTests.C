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
    When Newton's method gets on, and when it is hopeless.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "newtonProgress.H"

#include <cmath>

using Foam::label;
using Foam::newtonProgress;
using Foam::scalar;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Residuals that no longer fall end the iteration after thirty more")
{
    newtonProgress progress(60, 1);

    for (label n = 0; n <= 5; ++n)
    {
        progress.begin(n, std::pow(0.5, n), 1);
    }

    // From now on a tenth is never gained again
    for (label n = 6; n <= 35; ++n)
    {
        progress.begin(n, 0.95*std::pow(0.5, 5), 0.95);
        CHECK(!progress.hopeless());
    }

    progress.begin(36, 0.95*std::pow(0.5, 5), 0.95);
    CHECK(progress.hopeless());
}


TEST_CASE("Either of the two residuals is enough to go on")
{
    newtonProgress byNorm(1000, 1);
    newtonProgress byImbalance(1000, 1);

    for (label n = 0; n < 100; ++n)
    {
        const scalar falling = std::pow(0.8, n);

        byNorm.begin(n, falling, 1);
        byImbalance.begin(n, 1, falling);
    }

    CHECK(!byNorm.hopeless());
    CHECK(!byImbalance.hopeless());
}


TEST_CASE("As many iterations again are allowed while the sum halves")
{
    newtonProgress worth(10, 1);
    newtonProgress notWorth(10, 1);

    for (label n = 0; n <= 10; ++n)
    {
        worth.begin(n, std::pow(0.8, n), n < 10 ? 1 : 0.49);
        notWorth.begin(n, std::pow(0.8, n), n < 10 ? 1 : 0.51);
    }

    CHECK(!worth.hopeless());
    CHECK(notWorth.hopeless());

    // The next ten are measured against the sum at which they were allowed
    for (label n = 11; n <= 20; ++n)
    {
        worth.begin(n, std::pow(0.8, n), 0.25);
    }
    CHECK(worth.hopeless());
}


TEST_CASE("A circle is twenty iterations without a smaller sum")
{
    newtonProgress progress(60, 1);

    progress.begin(3, 1, 1);
    CHECK(progress.record(0.9));
    CHECK(!progress.record(0.9));

    progress.begin(23, 1, 1);
    CHECK(!progress.record(0.95));
    CHECK(!progress.circles());

    progress.begin(24, 1, 1);
    CHECK(progress.circles());
    CHECK(progress.record(0.8));
    CHECK(!progress.circles());
}

// ************************************************************************* //
