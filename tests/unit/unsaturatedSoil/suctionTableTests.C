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
    Curves through measured points: values, slopes and integrals, files, and
    what is refused.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "logSuctionCurve.H"
#include "soilDictionary.H"
#include "soilMessages.H"
#include "OSspecific.H"

#include <cmath>
#include <fstream>

using doctest::Approx;
using Foam::logSuctionCurve;
using Foam::scalar;
using Foam::scalarList;
using Foam::soilHydraulics;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("a table that is linear over the logarithm of suction")
{
    const soilHydraulics soil
    (
        "table",
        tabulatedSoil
        (
            "values ((0.1 0.4 1) (1 0.24 1e-2) (10 0.08 1e-5));"
            " interpolation linear;"
        )
    );
    const auto& retention = soil.retention();

    CHECK(retention.thetaS() == 0.4);
    CHECK(retention.thetaR() == 0);
    CHECK(soil.saturationHead() == -0.1);
    CHECK(soil.maxSuction() == 10);

    CHECK(soil.theta(-0.05) == 0.4);
    CHECK(soil.theta(-1) == Approx(0.24));
    CHECK(soil.K(-std::sqrt(10)) == Approx(1e-5*std::sqrt(1e-7)));

    // 1 - 0.4 log10(s/0.1) and 0.6 - 0.4 log10(s), with mpmath, 40 digits
    const scalar tolerance = 1e-14;
    CHECK(retention.Se(-3) == Approx(0.409151498112135025).epsilon(tolerance));
    CHECK
    (
        retention.dSedh(-3) == Approx(0.057905930920433577).epsilon(tolerance)
    );
    CHECK
    (
        -retention.SeIntegral(-3)
     == Approx(1.7312360933441772).epsilon(tolerance)
    );

    // d(kr)/dh = -kr dln(kr)/ds, -3 decades of kr a decade of s
    CHECK
    (
        soil.permeability().dkrdh(-3)
     == Approx(soil.permeability().kr(-3)).epsilon(tolerance)
    );

    // Beyond the last row it stays what it was
    CHECK(soil.theta(-100) == Approx(0.08));
    CHECK(retention.dSedh(-100) == 0);
}


TEST_CASE("a table that begins at zero suction")
{
    const soilHydraulics soil
    (
        "table",
        tabulatedSoil("values ((0 0.4 1) (0.1 0.3 1e-2) (1 0.1 1e-4));")
    );

    // Linear in the suction up to the second row
    CHECK(soil.saturationHead() == 0);
    CHECK(soil.theta(0) == 0.4);
    CHECK(soil.theta(-0.025) == Approx(0.375));
    CHECK(soil.retention().capacity(-0.025) == Approx(1));
    CHECK(soil.theta(-0.1) == Approx(0.3));
    CHECK(-soil.retention().SeIntegral(-0.1) == Approx(0.0875));
}


TEST_CASE("cubic interpolation neither overshoots nor turns")
{
    // A step between plains
    const scalarList s({0.1, 0.3, 1, 3, 10, 30});
    const scalarList y({0, 0.01, 0.02, 0.9, 0.91, 1});
    const logSuctionCurve curve(s, y, true);

    scalar last = -1;
    for (scalar u = std::log(0.101); u < std::log(30); u += 1e-3)
    {
        const scalar x = std::exp(u);

        CHECK(curve.value(x) >= last);
        last = curve.value(x);

        // The slope and the integral belong to the value
        const scalar d = 1e-6*x;
        CHECK
        (
            (curve.value(x + d) - curve.value(x - d))/(2*d)
         == Approx(curve.slope(x)).epsilon(1e-4).scale(1e-2)
        );
        CHECK
        (
            (curve.integral(x + d) - curve.integral(x - d))/(2*d)
         == Approx(curve.value(x)).epsilon(1e-6).scale(1)
        );
    }

    forAll(s, i)
    {
        CHECK(curve.value(s[i]) == Approx(y[i]));
    }
}


TEST_CASE("cubic interpolation converges to the curve behind the points")
{
    const soilHydraulics soil("embankment", embankment());

    const auto errorWith = [&](const Foam::label perDecade)
    {
        scalarList s(4*perDecade + 1);
        scalarList y(s.size());
        forAll(s, i)
        {
            s[i] = 0.01*std::pow(10, scalar(i)/perDecade);
            y[i] = soil.retention().desaturation(-s[i]);
        }

        const logSuctionCurve curve(s, y, true);

        scalar error = 0;
        for (scalar x = 0.1; x < 10; x *= 1.01)
        {
            error = std::max
            (
                error,
                std::abs(curve.value(x) - soil.retention().desaturation(-x))
            );
        }
        return error;
    };

    // The slopes of the harmonic mean are of second order, and so is the error
    // beside an inflection; third elsewhere
    const scalar coarse = errorWith(5);
    const scalar fine = errorWith(10);

    CHECK(fine < 1e-3);
    CHECK(fine < coarse/4);
}


TEST_CASE("a table from a file")
{
    {
        std::ofstream file("loam.csv");
        file<< "# measured\n"
            << "depth, theta , suction,kr\n"
            << "0.2, 0.4, 10, 1\n"
            << "\n"
            << "0.2, 0.24, 100, 1e-2\n"
            << "0.2,0.08,1000,1e-5\n";
    }
    const std::string path =
        std::string("file \"") + Foam::cwd() + "/loam.csv\";";

    const soilHydraulics soil
    (
        "file",
        tabulatedSoil(path + " headUnit 0.01; thetaR 0.04;")
    );

    CHECK(soil.saturationHead() == Approx(-0.1));
    CHECK(soil.maxSuction() == Approx(10));
    CHECK(soil.retention().thetaS() == 0.4);
    CHECK(soil.retention().Se(-1) == Approx(0.2/0.36));
    CHECK(soil.permeability().kr(-1) == Approx(1e-2));

    {
        std::ofstream file("loam.csv");
        file<< "suction,theta,kr\n1,0.4,1\n2,none,0.1\n";
    }
    checkNames
    (
        messageOf(tabulatedSoil(path)),
        {"loam.csv", "line 3", "none", "no number"}
    );

    {
        std::ofstream file("loam.csv");
        file<< "s,theta\n1,0.4\n";
    }
    checkNames
    (
        messageOf(tabulatedSoil(path)), {"first line of", "suction and theta"}
    );

    checkNames
    (
        messageOf(tabulatedSoil("file \"/no/such.csv\";")),
        {"Cannot open", "/no/such.csv"}
    );
}


TEST_CASE("tables that are no curve are refused with row and value")
{
    const auto message = [](const std::string& values)
    {
        return messageOf(tabulatedSoil("values (" + values + ");"));
    };

    checkNames
    (
        message("(1 0.4 1) (3 0.3 0.1) (2 0.2 0.01)"),
        {"Row 3", "suction is 2", "before has 3", "must rise"}
    );
    checkNames
    (
        message("(1 0.4 1) (3 0.3 0.1) (4 0.31 0.01)"),
        {"Row 3", "theta is 0.31", "before has 0.3", "must fall"}
    );
    checkNames
    (
        message("(1 0.4 1) (3 0.3 0.1) (4 0.2 0.2)"),
        {"Row 3", "kr is 0.2", "before has 0.1", "must not rise"}
    );
    checkNames
    (
        message("(1 0.4 0.9) (3 0.3 0.1)"), {"Row 1", "kr is 0.9", "is 1"}
    );
    checkNames
    (
        message("(1 0.4 1) (3 0.3 0)"), {"Row 2", "kr is 0", "0 < kr <= 1"}
    );
    checkNames(message("(1 1.4 1) (3 0.3 0.1)"), {"Row 1", "theta is 1.4"});
    checkNames(message("(-1 0.4 1) (3 0.3 0.1)"), {"Row 1", "suction is -1"});
    checkNames(message("(1 0.4 1)"), {"has 1 rows", "two or more"});
    checkNames(message("(1 0.4 1) (3 0.3)"), {"Row 2", "columns is 2"});
    checkNames(message("(1) (2)"), {"1 columns", "(suction theta)"});
    checkNames(message(""), {"0 columns"});
    checkNames
    (
        message("(1 0.4) (3 0.3)"), {"no column kr"}
    );
    checkNames
    (
        messageOf(tabulatedSoil("thetaR 0;")), {"'values' and 'file'", "neither"}
    );
    checkNames
    (
        messageOf
        (
            tabulatedSoil("values ((1 0.4 1) (3 0.3 0.1)); thetaR 0.3;")
        ),
        {"thetaR", "is 0.3", "0 <= thetaR < 0.3"}
    );
    checkNames
    (
        messageOf
        (
            tabulatedSoil
            (
                "values ((1 0.4 1) (3 0.3 0.1)); interpolation quintic;"
            )
        ),
        {"quintic", "monotoneCubic", "linear"}
    );
}

// ************************************************************************* //
