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
    Blocks at rest: when they sleep, what wakes them, and that a run with them
    can be stopped and goes on as if it had not been.

\*---------------------------------------------------------------------------*/

#include "engineCases.H"

#include <doctest/doctest.h>

#include <sstream>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double cellSize = 0.1;
constexpr int length = 24, depth = 4;
constexpr std::size_t nLayer = 4*length*depth;
constexpr std::size_t nPoints = nLayer + 16;

mpm::Settings sleepy(const double sleepVelocity, const mpm::Settings& others)
{
    mpm::Settings s(others);
    s.sleepVelocity = sleepVelocity;
    s.sleepDelay = 0.05;
    return s;
}


//- A layer between two walls at rest under its weight, and a lump that falls
//  onto its middle
std::unique_ptr<mpm::Simulation<2>> lumpOnLayer(const mpm::Settings& s)
{
    mpm::PointData data(box(2, cellSize, {{length, depth, 1}}));
    const std::size_t nLayer = data.size();
    const mpm::PointData lump(box(2, cellSize, {{2, 2, 1}}));
    for (std::size_t i = 0; i < lump.size(); ++i)
    {
        data.position.push_back(lump.position[i]);
        data.position.back()[0] += 11*cellSize;
        data.position.back()[1] += 12*cellSize;
        data.volume.push_back(lump.volume[i]);
        data.rho.push_back(lump.rho[i]);
        data.zone.push_back(0);
        data.cohesionIntercept.push_back(0);
        data.frictionAngle.push_back(30);
    }
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        // At rest: sigma_xx = nu/(1 - nu) sigma_yy
        const double vertical =
            i < nLayer
          ? -2000*9.81*(depth*cellSize - data.position[i][1])
          : 0;
        const double K0 = 0.3/0.7;
        data.sigma.push_back
        (
            {{K0*vertical, vertical, K0*vertical, 0, 0, 0}}
        );
        data.velocity.push_back({{0, i < nLayer ? 0.0 : -1.0, 0}});
    }

    std::vector<mpm::WallSettings> walls(baseAndSide(2));
    walls.push_back(walls.back());
    walls.back().name = "right";
    walls.back().point = {{length*cellSize, 0, 0}};
    walls.back().normal = {{-1, 0, 0}};
    return std::make_unique<mpm::Simulation<2>>
    (
        s, data, std::vector<mpm::Material>{soil()}, walls
    );
}


std::string saved(const mpm::Run& run)
{
    std::ostringstream os;
    run.save(os);
    return os.str();
}


//- Root of the sum of the squares of the displacements of the layer's points
double layerMoved(const mpm::Run& run)
{
    const std::vector<double> u = run.field("displacement");
    double sum = 0;
    for (std::size_t i = 0; i < 3*nLayer; ++i)
    {
        sum += u[i]*u[i];
    }
    return std::sqrt(sum);
}


mpm::Settings schemes(const int i)
{
    mpm::Settings s(settings(2, cellSize));
    if (i > 0)
    {
        s.shapeFunction = i == 1 ? "linear" : "quadraticBSpline";
        s.transferScheme = "FLIP";
        s.stressUpdate = i == 3 ? "MUSL" : "USF";
    }
    return s;
}

constexpr int nSchemes = 4;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("sleep: off by default, a layer at rest sleeps, an impact wakes it")
{
    for (int i = 0; i < nSchemes; ++i)
    {
        CAPTURE(i);
        auto awake = lumpOnLayer(schemes(i));
        auto run = lumpOnLayer(sleepy(0.05, schemes(i)));

        // The lump meets the layer after 0.31 s, the nodes of its blocks sooner
        awake->advance(0.1);
        run->advance(0.1);
        CHECK(awake->diagnostics().sleepingPoints == 0);
        CHECK(run->diagnostics().sleepingPoints == nLayer);
        CHECK(run->diagnostics().maxVelocity > 1.9);

        // What sleeps does not change
        const std::vector<double> before = run->field("sigma");
        run->advance(0.11);
        const std::vector<double> after = run->field("sigma");
        CHECK
        (
            std::equal
            (
                before.begin(), before.begin() + 6*nLayer, after.begin()
            )
        );

        awake->advance(0.5);
        run->advance(0.5);
        CHECK(run->diagnostics().sleepingPoints < nLayer);

        // The impact moves the layer as it does if nothing sleeps, but for what
        // the layer's own motion did to it, which was small
        const double moved = layerMoved(*run);
        const double expected = layerMoved(*awake);
        CHECK(expected > 0.1*cellSize);
        CHECK(std::fabs(moved/expected - 1) < 0.02);
    }
}


TEST_CASE("sleep: another cf' wakes, and the soil may sleep again")
{
    auto run = lumpOnLayer(sleepy(0.05, schemes(0)));
    run->advance(0.1);
    REQUIRE(run->diagnostics().sleepingPoints == nLayer);

    run->setField("cohesionIntercept", std::vector<double>(nPoints, 100));
    CHECK(run->diagnostics().sleepingPoints == 0);
    run->advance(0.16);
    CHECK(run->diagnostics().sleepingPoints > 0);
}


TEST_CASE("sleep: a restart gives the straight run, bit by bit")
{
    for (int i = 0; i < nSchemes; ++i)
    {
        CAPTURE(i);
        auto straight = lumpOnLayer(sleepy(0.05, schemes(i)));
        straight->advance(0.1);
        std::istringstream state(saved(*straight));

        auto restarted = lumpOnLayer(sleepy(0.05, schemes(i)));
        restarted->restore(state);
        CHECK(restarted->diagnostics().sleepingPoints == nLayer);
        straight->advance(0.5);
        restarted->advance(0.5);
        const bool same = saved(*straight) == saved(*restarted);
        CHECK(same);
    }
}

// ************************************************************************* //
