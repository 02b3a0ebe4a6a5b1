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

#include "engineCases.H"
#include "mpmOverburden.H"

#include <doctest/doctest.h>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double g = 9.81;
constexpr double rho = 2000;

//- Level ground 2 m wide and 4 m deep between rollers
struct Ground
{
    mpm::PointData data;
    std::vector<mpm::WallSettings> walls;

    explicit Ground(const double tableHeight)
    :
        data(box(2, 0.25, {{8, 16, 0}})),
        walls(baseAndSide(2))
    {
        mpm::WallSettings right = walls.back();
        right.name = "right";
        right.point = {{2, 0, 0}};
        right.normal = {{-1, 0, 0}};
        walls.push_back(right);

        for (std::size_t i = 0; i < data.size(); ++i)
        {
            const double head = tableHeight - data.position[i][1];
            data.porePressure.push_back(1000*g*head);
            // Below and above the table alike (Zhu2022 Eq. 6), c' = 0
            data.cohesionIntercept[i] =
                -std::tan(std::acos(-1.0)/6)*data.porePressure[i];
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("overburden is the weight above, in a section and in a block")
{
    const auto check = [](auto dimension)
    {
        constexpr int Dim = decltype(dimension)::value;
        mpm::PointCloud<Dim> cloud;
        const mpm::PointData data(box(Dim, 0.25, {{4, 4, 4}}));
        cloud.assign(data, 0, data.size());
        mpm::SerialCommunicator one;
        mpm::Vector<Dim> up{};
        up[Dim - 1] = 1;
        const std::vector<double> stress =
            mpm::overburden<Dim>(one, cloud, up, g, 0.25, {});
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            // Round-off of sums of 16 masses
            CHECK
            (
                std::fabs(stress[i] - rho*g*(1 - cloud.x[i][Dim - 1]))
             <= 1e-12*rho*g
            );
        }
    };
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
}


TEST_CASE("column start: K0 of effective stress, with water inside the soil")
{
    const Ground ground(2.5);
    for (const char* symmetry : {"none", "axisymmetric"})
    {
        CAPTURE(symmetry);
        mpm::Settings s = settings(2, 0.25, g);
        s.symmetry = symmetry;
        mpm::Simulation<2> run(s, ground.data, {soil()}, ground.walls);
        mpm::StartSettings start;
        start.relaxationTime = 0;
        run.establishStart(start);

        const std::vector<double> sigma = run.field("sigma");
        const double K0 = 1 - 0.5;
        for (std::size_t i = 0; i < run.nPoints(); ++i)
        {
            const double v = rho*g*(4 - ground.data.position[i][1]);
            const double pw = ground.data.porePressure[i];
            const double h = K0*(v - pw) + pw;
            const double bound = 1e-11*rho*g;
            CHECK(std::fabs(sigma[6*i + 1] + v) <= bound);
            CHECK(std::fabs(sigma[6*i] + h) <= bound);
            CHECK(std::fabs(sigma[6*i + 2] + h) <= bound);
            CHECK(std::fabs(sigma[6*i + 3]) <= bound);
        }
    }
}


TEST_CASE("level ground comes to rest and stays there")
{
    const Ground ground(2.5);
    for (const char* symmetry : {"none", "axisymmetric"})
    {
        CAPTURE(symmetry);
        mpm::Settings s = settings(2, 0.25, g);
        s.symmetry = symmetry;
        mpm::Simulation<2> run(s, ground.data, {soil()}, ground.walls);
        const mpm::StartReport report =
            run.establishStart(mpm::StartSettings());

        CHECK(report.atRest);
        CHECK(report.resets > 0);
        CHECK(report.rmsVelocity < 1e-5);

        // The column stress balances the weight but for the ends, where the
        // grid spreads the surface over a cell: 1/16 of the height carries
        // some of rho g h/M = 2000 g 4/1.35e6 m of settlement
        CHECK(report.settlement < 5e-3);
        CHECK(report.outOfBalance < 1e-2);
        CHECK(run.time() == 0);
        CHECK(run.stepNumber() == 0);
        CHECK(run.diagnostics().maxPlasticStrain == 0);

        run.advance(2);
        CHECK(run.diagnostics().maxDisplacement < 1e-4);
    }
}


TEST_CASE("overburden from a function, elastic gravity and given stresses")
{
    const Ground ground(0);
    const mpm::Settings s = settings(2, 0.25, g);

    mpm::StartSettings start;
    start.overburden = [](const mpm::Point3& x) { return 100*x[0]; };
    start.K0 = 0.25;
    start.relaxationTime = 0;
    mpm::Simulation<2> given(s, ground.data, {soil()}, ground.walls);
    given.establishStart(start);
    const std::vector<double> sigma = given.field("sigma");
    for (std::size_t i = 0; i < given.nPoints(); ++i)
    {
        const double expected = -100*ground.data.position[i][0];
        CHECK(std::fabs(sigma[6*i + 1] - expected) <= 1e-10);
    }

    // Elastic ground between rollers: sigma_h = nu/(1 - nu) sigma_v, the
    // mean of the middle third against the weight above; 2 % for the
    // settled shape and the surface's cell
    mpm::Simulation<2> settled(s, ground.data, {elastic()}, ground.walls);
    start = mpm::StartSettings();
    start.type = "elasticGravity";
    const mpm::StartReport report = settled.establishStart(start);
    CHECK(report.settlement > 0);
    const std::vector<double> result = settled.field("sigma");
    double vertical = 0, side = 0, expected = 0;
    for (std::size_t i = 0; i < settled.nPoints(); ++i)
    {
        const double y = ground.data.position[i][1];
        if (y > 1.3 && y < 2.7)
        {
            vertical += result[6*i + 1];
            side += result[6*i];
            expected -= rho*g*(4 - y);
        }
    }
    CHECK(std::fabs(vertical/expected - 1) < 0.02);
    CHECK(std::fabs(side/vertical - 0.3/0.7) < 0.01);
}


TEST_CASE("the strength of the stable soil rules until the slide starts")
{
    // A cut that cannot stand in its own strength
    mpm::PointData data = box(2, 0.25, {{12, 8, 0}});
    mpm::Material clay = soil();
    const mpm::Settings s = settings(2, 0.25, g);
    mpm::Simulation<2> run(s, data, {clay}, baseAndSide(2));

    mpm::StartSettings start;
    start.addedCohesion = 30e3;
    const mpm::StartReport report = run.establishStart(start);
    CHECK(report.outsideFraction > 0);
    CHECK(report.maxExcess > 0);
    CHECK(run.field("cohesionIntercept") == data.cohesionIntercept);
    CHECK(run.field("frictionAngle") == data.frictionAngle);
    CHECK(run.diagnostics().maxDisplacement == 0);

    run.advance(1);
    CHECK(run.diagnostics().maxDisplacement > 0.25);

    // The same soil with that cohesion kept stands
    for (double& c : data.cohesionIntercept)
    {
        c = 30e3;
    }
    mpm::Simulation<2> stable(s, data, {clay}, baseAndSide(2));
    stable.establishStart(mpm::StartSettings());
    stable.advance(1);
    CHECK(stable.diagnostics().maxDisplacement < 5e-3);
}


// ************************************************************************* //
