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
    The flux over an edge of the ground, and over outlets: Manning's formula,
    water at rest, derivatives.

\*---------------------------------------------------------------------------*/

#include <doctest/doctest.h>

#include "IStringStream.H"
#include "overlandFlowModel.H"
#include "surfaceOutlet.H"

#include <cmath>
#include <string>

using doctest::Approx;
using Foam::dictionary;
using Foam::overlandFlowModel;
using Foam::planGeometry;
using Foam::scalar;
using Foam::surfaceOutlet;
using Foam::vector2D;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    dictionary dictionaryOf(const std::string& text)
    {
        return dictionary(Foam::IStringStream(text)());
    }

    //- An edge of 3 m between two faces 2 m apart in x
    planGeometry::edgePlan straightEdge()
    {
        planGeometry::edgePlan edge;
        edge.length = 3;
        edge.normal = vector2D(1, 0);
        edge.delta = vector2D(2, 0);
        edge.inverseDistance = 0.5;
        edge.rest = vector2D(0, 0);
        edge.elevation = 0;
        return edge;
    }

    Foam::autoPtr<overlandFlowModel> model(const std::string& name)
    {
        return overlandFlowModel::New
        (
            dictionaryOf("overlandFlowModel " + name + "; slopeFloor 1e-6;")
        );
    }

    const scalar manning = 0.05;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Uniform flow down a plane is Manning's, with either model")
{
    const scalar slope = 0.04;
    const scalar depth = 0.02;
    const scalar exact =
        3*std::pow(depth, 5.0/3.0)*std::sqrt(slope)/manning;

    for (const std::string name : {"diffusionWave", "kinematicWave"})
    {
        const auto f = model(name)->edgeFlux
        (
            straightEdge(),
            {depth, 2*slope, manning},
            {depth, 0, manning},
            vector2D(-slope, 0)
        );

        // The floor of the slope is 1e-6
        CHECK(f.value == Approx(exact).epsilon(1e-8));
    }
}


TEST_CASE("The friction slope is the full gradient, not its normal part")
{
    // Surface that falls by 0.03 across the edge and 0.04 along it
    const scalar depth = 0.02;
    const auto f = model("diffusionWave")->edgeFlux
    (
        straightEdge(),
        {depth, 0.06, manning},
        {depth, 0, manning},
        vector2D(-0.03, -0.04)
    );

    const scalar exact =
        3*std::pow(depth, 5.0/3.0)*0.03/(manning*std::sqrt(0.05));

    CHECK(f.value == Approx(exact).epsilon(1e-8));
}


TEST_CASE("Still water over uneven ground does not move")
{
    const auto diffusionWave = model("diffusionWave");

    for (const scalar step : {0.0, 0.1, 0.5})
    {
        const auto f = diffusionWave->edgeFlux
        (
            straightEdge(),
            {0.5, 1, manning},
            {0.5 - step, 1 + step, manning},
            vector2D(0, 0)
        );

        CHECK(std::abs(f.value) < 1e-14);
    }

    // Dry ground above the water is a wall, also for water below it
    const auto shore = diffusionWave->edgeFlux
    (
        straightEdge(),
        {0.5, 1, manning},
        {0, 2, manning},
        vector2D(0, 0)
    );
    CHECK(shore.value == 0);
}


TEST_CASE("Derivatives of the flux over an edge are its own")
{
    const scalar step = 1e-7;
    const vector2D gradient(-0.02, 0.03);

    for (const std::string name : {"diffusionWave", "kinematicWave"})
    {
        const auto wave = model(name);

        for (const scalar h1 : {0.01, 0.2, 0.6})
        {
            for (const scalar h2 : {0.01, 0.35})
            {
                const auto flux = [&](const scalar a, const scalar b)
                {
                    return wave->edgeFlux
                    (
                        straightEdge(),
                        {a, 0.1, manning},
                        {b, 0.05, 2*manning},
                        gradient
                    );
                };

                const auto f = flux(h1, h2);
                const scalar first =
                    (flux(h1 + step, h2).value - flux(h1 - step, h2).value)
                   /(2*step);
                const scalar second =
                    (flux(h1, h2 + step).value - flux(h1, h2 - step).value)
                   /(2*step);

                CHECK(f.dFirst >= 0);
                CHECK(f.dSecond <= 0);
                CHECK(f.dFirst == Approx(first).epsilon(1e-5));
                CHECK(f.dSecond == Approx(second).epsilon(1e-5));
            }
        }
    }
}


TEST_CASE("Outlets: normal and critical depth")
{
    const scalar depth = 0.3;
    const scalar bedSlope = 0.02;
    scalar derivative;

    const auto bed =
        surfaceOutlet::New("mouth", dictionaryOf("type normalDepth;"));
    CHECK
    (
        bed->outflow(depth, bedSlope, manning, derivative)
     == Approx(std::pow(depth, 5.0/3.0)*std::sqrt(bedSlope)/manning)
    );
    CHECK
    (
        derivative
     == Approx
        (
            5.0/3.0*std::pow(depth, 2.0/3.0)*std::sqrt(bedSlope)/manning
        )
    );
    CHECK_THROWS_AS
    (
        bed->checkEdge(0, Foam::vector::zero),
        Foam::IOerror
    );

    const auto given = surfaceOutlet::New
    (
        "mouth",
        dictionaryOf("type normalDepth; slope 0.0049;")
    );
    given->checkEdge(-0.1, Foam::vector::zero);
    CHECK
    (
        given->outflow(depth, -0.1, manning, derivative)
     == Approx(std::pow(depth, 5.0/3.0)*0.07/manning)
    );

    const auto critical =
        surfaceOutlet::New("weir", dictionaryOf("type criticalDepth;"));
    CHECK
    (
        critical->outflow(depth, bedSlope, manning, derivative)
     == Approx(std::sqrt(9.80665)*std::pow(depth, 1.5))
    );
    CHECK(derivative == Approx(1.5*std::sqrt(9.80665*depth)));

    CHECK_THROWS_AS
    (
        surfaceOutlet::New("mouth", dictionaryOf("type open;")),
        Foam::IOerror
    );
}

// ************************************************************************* //
