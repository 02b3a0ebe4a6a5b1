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

#include "dictionaryOf.H"
#include "overlandFlowModel.H"
#include "surfaceOutlet.H"

#include <cmath>
#include <string>

using doctest::Approx;
using Foam::dictionary;
using Foam::frictionModel;
using Foam::overlandFlowModel;
using Foam::planGeometry;
using Foam::scalar;
using Foam::surfaceOutlet;
using Foam::vector2D;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- An edge of 3 m between two faces 2 m apart in x, whose bed falls
    //  towards it on the first side
    planGeometry::edgePlan straightEdge(const scalar fall = 0)
    {
        planGeometry::edgePlan edge;
        edge.length = 3;
        edge.normal = vector2D(1, 0);
        edge.delta = vector2D(2, 0);
        edge.inverseDistance = 0.5;
        edge.rest = vector2D(0, 0);
        edge.position = 0.5;
        edge.fallFirst = fall;
        edge.fallSecond = -fall;
        return edge;
    }

    Foam::autoPtr<overlandFlowModel> model
    (
        const std::string& name,
        const std::string& law = "manning"
    )
    {
        return overlandFlowModel::New
        (
            dictionaryOf
            (
                "overlandFlowModel " + name + "; slopeFloor 1e-6;"
                "frictionModel " + law + ";"
            )
        );
    }

    //- Surroundings with a gradient
    overlandFlowModel::surroundings around(const vector2D& gradient)
    {
        overlandFlowModel::surroundings result;
        result.gradient = gradient;
        return result;
    }

    const std::string waves[] =
        {"diffusionWave", "bedSlopeDiffusionWave", "kinematicWave"};

    //- Discharge over a metre of width in uniform flow, from the laws as
    //  textbooks have them; n = 0.05, C = 30 m^(1/2)/s, f = 0.4
    scalar uniformFlow
    (
        const std::string& law,
        const scalar depth,
        const scalar slope
    )
    {
        if (law == "manning")
        {
            return std::pow(depth, 5.0/3.0)*std::sqrt(slope)/0.05;
        }
        if (law == "chezy")
        {
            return 30*depth*std::sqrt(depth*slope);
        }

        // h_f/L = S = f V^2/(2 g D), with the hydraulic diameter D = 4 h
        return depth*std::sqrt(2*9.80665*4*depth*slope/0.4);
    }

    scalar coefficient(const std::string& law)
    {
        return law == "manning" ? 0.05 : law == "chezy" ? 30 : 0.4;
    }

    const std::string laws[] = {"manning", "chezy", "darcyWeisbach"};

    const scalar conveyance = 1/0.05;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Uniform flow down a plane is the law's, with any model")
{
    const scalar slope = 0.04;
    const scalar depth = 0.02;

    for (const std::string& law : laws)
    {
        for (const std::string& wave : waves)
        {
            CAPTURE(law);
            CAPTURE(wave);

            const auto m = model(wave, law);
            const scalar k = m->friction().conveyance(coefficient(law));
            const auto f = m->edgeFlux
            (
                straightEdge(slope),
                {depth, 2*slope, k, slope},
                {depth, 0, k, slope},
                around(vector2D(-slope, 0))
            );

            // The floor of the slope is 1e-6
            CHECK
            (
                f.value == Approx(3*uniformFlow(law, depth, slope))
                   .epsilon(1e-8)
            );
        }
    }
}


TEST_CASE("The friction slope is the full gradient, or that of the bed")
{
    // Surface that falls by 0.03 across the edge and 0.04 along it
    const scalar depth = 0.02;
    const scalar bedSlope = 0.09;

    for (const std::string wave : {"diffusionWave", "bedSlopeDiffusionWave"})
    {
        const auto f = model(wave)->edgeFlux
        (
            straightEdge(),
            {depth, 0.06, conveyance, bedSlope},
            {depth, 0, conveyance, bedSlope},
            around(vector2D(-0.03, -0.04))
        );

        const scalar slope = (wave == "diffusionWave" ? 0.05 : bedSlope);
        const scalar exact =
            3*std::pow(depth, 5.0/3.0)*0.03*conveyance/std::sqrt(slope);

        CHECK(f.value == Approx(exact).epsilon(1e-8));
    }

    // A slope of its own in place of the bed's
    const auto given = overlandFlowModel::New
    (
        dictionaryOf
        (
            "overlandFlowModel bedSlopeDiffusionWave; slope 0.01;"
            "slopeFloor 1e-6;"
        )
    );
    CHECK
    (
        given->edgeFlux
        (
            straightEdge(),
            {depth, 0.06, conveyance, bedSlope},
            {depth, 0, conveyance, bedSlope},
            around(vector2D(0, 0))
        ).value
     == Approx(3*std::pow(depth, 5.0/3.0)*0.03*conveyance/0.1).epsilon(1e-7)
    );
}


TEST_CASE("Still water over uneven ground does not move")
{
    for (const std::string wave : {"diffusionWave", "bedSlopeDiffusionWave"})
    {
        const auto diffusive = model(wave);

        for (const scalar step : {0.0, 0.1, 0.5})
        {
            const auto f = diffusive->edgeFlux
            (
                straightEdge(),
                {0.5, 1, conveyance, 0.1},
                {0.5 - step, 1 + step, conveyance, 0.1},
                around(vector2D(0, 0))
            );

            CHECK(std::abs(f.value) < 1e-14);
        }

        // Dry ground above the water is a wall, also for water below it
        const auto shore = diffusive->edgeFlux
        (
            straightEdge(),
            {0.5, 1, conveyance, 0.1},
            {0, 2, conveyance, 0.1},
            around(vector2D(0, 0))
        );
        CHECK(shore.value == 0);
    }
}


TEST_CASE("A drop behind an edge does not pull at the water before it")
{
    // The bed falls by 0.05 to the edge, and by 5 m behind it
    const scalar depth = 0.02;
    const scalar fall = 0.05;

    for (const std::string wave : {"diffusionWave", "kinematicWave"})
    {
        const auto m = model(wave);
        const auto dropTo = [&](const scalar below)
        {
            return m->edgeFlux
            (
                straightEdge(fall),
                {depth, 5, conveyance, fall},
                {depth, 5 - below, conveyance, 1},
                around(vector2D(0, 0))
            ).value;
        };

        // Down to the bed at the edge, 1 m away
        const scalar slope = fall + depth/1;
        const scalar exact =
            3*std::pow(depth, 5.0/3.0)*std::sqrt(slope)*conveyance;

        CHECK(dropTo(5) == Approx(exact).epsilon(1e-8));
        CHECK(dropTo(1) == Approx(exact).epsilon(1e-8));
        CHECK(dropTo(0.12) < exact);
    }
}


TEST_CASE("Downhill the depth at the edge passes, uphill that above the bed")
{
    overlandFlowModel::surroundings rising = around(vector2D(0, 0));
    rising.ratioFirst = 1.2;
    rising.ratioSecond = 0.9;

    const scalar depth = 0.02;
    const auto flux = [&](const scalar z1, const scalar z2)
    {
        return model("diffusionWave")->edgeFlux
        (
            straightEdge(),
            {depth, z1, conveyance, 0},
            {depth, z2, conveyance, 0},
            rising
        ).value;
    };
    const auto exact = [&](const scalar h)
    {
        return 3*std::pow(h, 5.0/3.0)*std::sqrt(0.04)*conveyance;
    };

    CHECK(flux(0.08, 0) == Approx(exact(1.2*depth)).epsilon(1e-8));
    CHECK(flux(0, 0.08) == Approx(-exact(0.9*depth)).epsilon(1e-8));

    // Water that stands 0.3 m deep against a rising bed
    const auto f = model("diffusionWave")->edgeFlux
    (
        straightEdge(),
        {0.3, 0, conveyance, 0},
        {0.12, 0.1, conveyance, 0},
        rising
    );
    CHECK(f.value == Approx(exact(0.2)).epsilon(1e-8));
}


TEST_CASE("Derivatives of the flux over an edge are its own")
{
    const scalar step = 1e-7;

    overlandFlowModel::surroundings some = around(vector2D(-0.02, 0.03));
    some.ratioFirst = 1.3;
    some.ratioSecond = 0.8;

    for (const std::string& law : laws)
    {
        for (const std::string& name : waves)
        {
            const auto wave = model(name, law);

            // On even ground, and before a drop
            for (const scalar drop : {0.05, 2.0})
            {
                for (const scalar h1 : {0.01, 0.2, 0.6})
                {
                    for (const scalar h2 : {0.01, 0.35})
                    {
                        const auto flux = [&](const scalar a, const scalar b)
                        {
                            return wave->edgeFlux
                            (
                                straightEdge(0.02),
                                {a, 0.1, 20, 0.02},
                                {b, 0.1 - drop, 10, 0.03},
                                some
                            );
                        };

                        const auto f = flux(h1, h2);
                        const scalar first =
                            (
                                flux(h1 + step, h2).value
                              - flux(h1 - step, h2).value
                            )/(2*step);
                        const scalar second =
                            (
                                flux(h1, h2 + step).value
                              - flux(h1, h2 - step).value
                            )/(2*step);

                        CHECK(f.dFirst >= 0);
                        CHECK(f.dSecond <= 0);
                        CHECK(f.dFirst == Approx(first).epsilon(1e-5));
                        CHECK(f.dSecond == Approx(second).epsilon(1e-5));
                    }
                }
            }
        }
    }
}


TEST_CASE("An unknown friction law is answered by the list of laws")
{
    CHECK_THROWS_AS(model("diffusionWave", "strickler"), Foam::IOerror);
}


TEST_CASE("Outlets: normal and critical depth")
{
    surfaceOutlet::edgeWater water;
    water.depth = 0.3;
    water.bedSlope = 0.02;
    scalar derivative;

    for (const std::string& law : laws)
    {
        const auto friction =
            frictionModel::New(dictionaryOf("frictionModel " + law + ";"));
        const scalar k = friction->conveyance(coefficient(law));

        water.discharge =
            friction->discharge(water.depth, k, water.dDischarge);

        const auto bed =
            surfaceOutlet::New("mouth", 1, dictionaryOf("type normalDepth;"));
        const auto given = surfaceOutlet::New
        (
            "mouth",
            1,
            dictionaryOf("type normalDepth; slope 0.0049;")
        );

        CHECK
        (
            bed->outflow(water, derivative)
         == Approx(uniformFlow(law, 0.3, 0.02))
        );
        CHECK
        (
            given->outflow(water, derivative)
         == Approx(uniformFlow(law, 0.3, 0.0049))
        );

        const scalar step = 1e-6;
        CHECK
        (
            derivative
         == Approx
            (
                (
                    uniformFlow(law, 0.3 + step, 0.0049)
                  - uniformFlow(law, 0.3 - step, 0.0049)
                )/(2*step)
            ).epsilon(1e-6)
        );

        CHECK_THROWS_AS
        (
            bed->checkEdge(0, Foam::vector::zero),
            Foam::IOerror
        );
        given->checkEdge(-0.1, Foam::vector::zero);
    }

    const auto critical =
        surfaceOutlet::New("weir", 1, dictionaryOf("type criticalDepth;"));
    CHECK
    (
        critical->outflow(water, derivative)
     == Approx(std::sqrt(9.80665)*std::pow(0.3, 1.5))
    );
    CHECK(derivative == Approx(1.5*std::sqrt(9.80665*0.3)));

    CHECK_THROWS_AS
    (
        surfaceOutlet::New("mouth", 1, dictionaryOf("type open;")),
        Foam::IOerror
    );
}


TEST_CASE("Outlets: rating curve")
{
    const auto outflow = [](const std::string& entries, const scalar depth)
    {
        surfaceOutlet::edgeWater water;
        water.depth = depth;
        scalar derivative;

        // A patch of 4 m
        return surfaceOutlet::New
        (
            "gauge",
            4,
            dictionaryOf("type ratingCurve;" + entries)
        )->outflow(water, derivative);
    };

    const std::string curve = "curve ((0.1 0) (0.2 0.4) (0.5 2.8));";

    CHECK(outflow(curve + "discharge perWidth;", 0.1) == 0);
    CHECK(outflow(curve + "discharge perWidth;", 0.05) == 0);
    CHECK(outflow(curve + "discharge perWidth;", 0.15) == Approx(0.2));
    CHECK(outflow(curve + "discharge perWidth;", 0.2) == Approx(0.4));
    CHECK(outflow(curve + "discharge total;", 0.35) == Approx(1.6/4));
    CHECK(outflow(curve + "discharge total;", 0.6) == Approx(3.6/4));

    for
    (
        const std::string bad :
        {
            "curve ((0 0) (0.2 0.4) (0.1 0.5)); discharge total;",
            "curve ((0 0) (0.2 0.4) (0.3 0.3)); discharge total;",
            "curve ((0 0.1) (0.2 0.4)); discharge total;",
            "curve ((0 0)); discharge total;",
            "curve ((0 0) (0.2 0.4)); discharge each;",
            "curve ((0 0) (0.2 0.4));",
            "file \"noSuchFile\"; discharge total;",
            "discharge total;"
        }
    )
    {
        CAPTURE(bad);
        CHECK_THROWS_AS(outflow(bad, 0.1), Foam::IOerror);
    }
}

// ************************************************************************* //
