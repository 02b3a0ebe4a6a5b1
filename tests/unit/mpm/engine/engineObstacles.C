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
#include "mpmContactArea.H"

#include <doctest/doctest.h>

#include <random>
#include <sstream>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::WallSettings obstacle(const int dimension)
{
    mpm::WallSettings wall;
    wall.name = "barrier";
    wall.type = "box";
    wall.condition = "coulomb";
    wall.lower = {{1, -1, dimension == 3 ? -1.0 : 0}};
    wall.upper = {{3, 0.5, dimension == 3 ? 2.0 : 0}};
    return wall;
}


//- A sphere or circle about (0.3 0.2 0.1)
double ball(const mpm::Point3& x)
{
    return std::hypot(x[0] - 0.3, x[1] - 0.2, x[2] - 0.1) - 1;
}


mpm::WallSettings levelSet
(
    const std::function<double(const mpm::Point3&)>& distance,
    const double spacing
)
{
    mpm::WallSettings wall;
    wall.type = "levelSet";
    wall.condition = "coulomb";
    wall.signedDistance = distance;
    wall.spacing = spacing;
    wall.lower = {{-0.7, -0.8, -0.9}};
    wall.upper = {{1.3, 1.2, 1.1}};
    return wall;
}


//- Largest error of the distance within a spacing of the ball
double errorAtBall(const double spacing)
{
    const mpm::Wall<3> wall(levelSet(ball, spacing), {{0, 0, 1}});
    std::mt19937 generator(11);
    std::normal_distribution<double> number(0, 1);
    double worst = 0;
    for (int i = 0; i < 2000; ++i)
    {
        mpm::Vector<3> e{{number(generator), number(generator), number(generator)}};
        const double length = std::hypot(e[0], e[1], e[2]);
        const double radius = 1 + spacing*(i % 21 - 10)/10.0;
        const mpm::Vector<3> x
        {{
            0.3 + radius*e[0]/length,
            0.2 + radius*e[1]/length,
            0.1 + radius*e[2]/length
        }};
        mpm::Vector<3> normal;
        worst = std::max
        (
            worst,
            std::fabs(wall.distance(x, normal) - (radius - 1))
        );
    }
    return worst;
}


//- The plane through a place with this normal, of any dimension
mpm::WallSettings plane
(
    const mpm::Point3& point,
    const mpm::Point3& normal,
    const double adhesion = 0
)
{
    mpm::WallSettings wall;
    wall.condition = "coulomb";
    wall.point = point;
    wall.normal = normal;
    wall.adhesion = adhesion;
    return wall;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("distance to a box")
{
    const mpm::Wall<2> box(obstacle(2), {{0, 1}});
    mpm::Vector<2> n;

    // In front of a face, beyond a corner (3 4 5), inside, on the corner
    CHECK(std::fabs(box.distance({{0.4, 0}}, n) - 0.6) <= 1e-15);
    CHECK(n == mpm::Vector<2>{{-1, 0}});
    CHECK(std::fabs(box.distance({{6, 4.5}}, n) - 5) <= 1e-14);
    CHECK(std::fabs(n[0] - 0.6) <= 1e-15);
    CHECK(std::fabs(box.distance({{1.1, 0}}, n) + 0.1) <= 1e-15);
    CHECK(n == mpm::Vector<2>{{-1, 0}});
    CHECK(std::fabs(box.distance({{3, 0.5}}, n)) <= 1e-15);
    CHECK(std::fabs(n[0] - n[1]) <= 1e-15);
    CHECK(n[0] > 0);

    // An edge in space
    const mpm::Wall<3> body(obstacle(3), {{0, 0, 1}});
    mpm::Vector<3> n3;
    CHECK(std::fabs(body.distance({{6, 0, 6}}, n3) - 5) <= 1e-14);
    CHECK(n3[1] == 0);
}


TEST_CASE("distance to a sampled level set")
{
    // A plane is exact, near and far
    const auto incline = [](const mpm::Point3& x)
    {
        return 0.6*x[0] + 0.8*x[2] - 0.1;
    };
    const mpm::Wall<3> wall(levelSet(incline, 0.1), {{0, 0, 1}});
    mpm::Vector<3> n;
    for (double x = -1; x < 1.5; x += 0.13)
    {
        CAPTURE(x);
        const double expected = incline({{x, 0.1, 0.4}});
        CHECK
        (
            std::fabs(wall.distance({{x, 0.1, 0.4}}, n) - expected) <= 1e-13
        );
        CHECK(std::fabs(n[0] - 0.6) <= 1e-12);
        CHECK(std::fabs(n[2] - 0.8) <= 1e-12);
    }

    // A ball to second order: the sagitta of a spacing, and 4 times less with
    // half of it
    const double coarse = errorAtBall(0.1);
    CHECK(coarse <= 3*0.1*0.1/8 + 1e-3);
    CHECK(coarse/errorAtBall(0.05) > 3.5);

    // Beyond the samples not more than the true distance, and positive
    const mpm::Wall<3> sphere(levelSet(ball, 0.05), {{0, 0, 1}});
    const double far = sphere.distance({{20, 0, 0}}, n);
    CHECK(far > 18);
    CHECK(far <= ball({{20, 0, 0}}));
    CHECK(sphere.distance({{0.3, 0.2, 0.1}}, n) < -0.5);

    // Bricks far from the surface have no samples
    const mpm::LevelSet<3> sparse
    (
        "ball", ball, {{-0.7, -0.8, -0.9}}, {{1.3, 1.2, 1.1}}, 0.02
    );
    CHECK(double(sparse.nSamples()) < 0.85*std::pow(2.64/0.02, 3));
}


TEST_CASE("area of contact of the nodes at a wall")
{
    // A patch of a plane inside of a block, whatever its place and slope: the
    // nodes of 3 x 3 blocks around it have all of it
    const double h = 0.5;
    constexpr int edge = 8;
    for (const double angle : {0.0, 0.2, 0.785398, 1.1})
    {
        for (const double offset : {0.0, 0.11, 0.25, 0.4})
        {
            CAPTURE(angle);
            CAPTURE(offset);
            const mpm::Wall<2> wall
            (
                plane
                (
                    {{0, offset, 0}}, {{std::sin(angle), std::cos(angle), 0}}
                ),
                {{0, 1}}
            );
            double area = 0;
            for (int i = -2; i < 2; ++i)
            {
                for (int j = -4; j < 4; ++j)
                {
                    const mpm::ContactArea<2> contact
                    (
                        wall,
                        {{edge*h*i, edge*h*j}},
                        h,
                        edge,
                        1e-9*h
                    );
                    for (int n = 0; n < edge*edge; ++n)
                    {
                        area += contact.area(n);
                    }
                }
            }

            // At each end a quarter of a cell may fall to the nodes beyond, of
            // 32 in all
            const double exact = 4*edge*h/std::cos(angle);
            CHECK(std::fabs(area/exact - 1) <= 0.02);
        }
    }

    // On the nodes: h for each pair of a node and that below it, half of whose
    // cell is free
    const mpm::ContactArea<2> level
    (
        mpm::Wall<2>(plane({{0, 1, 0}}, {{0, 1, 0}}), {{0, 1}}),
        {{0, 0}},
        h,
        edge,
        1e-9*h
    );
    CHECK(std::fabs(level.area(3 + edge*2) + level.area(3 + edge) - h) <= 1e-12);
    CHECK(std::fabs(level.area(3 + edge*2)/h - 6.0/7) <= 0.02);
    CHECK(std::fabs(level.volume(3 + edge*2) - 0.5*h*h) <= 1e-12);
}


TEST_CASE("what a block knows to be clear of walls is in front of them")
{
    // A level set, a box beside it, and a plane, which alone needs no list
    const double h = 0.13;
    const std::vector<mpm::Wall<3>> walls
    {
        mpm::Wall<3>(levelSet(ball, 0.1), {{0, 0, 1}}),
        mpm::Wall<3>(obstacle(3), {{0, 0, 1}}),
        mpm::Wall<3>(plane({{0, 0, -0.7}}, {{0, 0, 1}}), {{0, 0, 1}})
    };
    mpm::BlockGrid<3> grid(h, {{0.02, 0, 0}}, 2, walls);

    std::mt19937 random(1);
    int far = 0, clear = 0, behind = 0;
    for (int i = 0; i < 20000; ++i)
    {
        mpm::BlockGrid<3>::Coordinates at;
        mpm::Vector<3> x;
        for (int d = 0; d < 3; ++d)
        {
            const double cells =
                std::uniform_real_distribution<double>(-12, 20)(random);
            at[d] = std::int32_t(std::floor(cells/grid.edge));

            // Or beyond the upper end, as points are that leave
            x[d] = grid.origin()[d] + h*(cells + (i % 2));
        }
        const auto& block = grid[grid.find(at)];
        double distance = 1e300;
        for (const mpm::Wall<3>& wall : walls)
        {
            mpm::Vector<3> normal;
            distance = std::min(distance, wall.distance(x, normal));
        }
        const bool isClear = grid.isClear(block, x);
        far += !block.clear.empty() && i % 2 == 0 && distance > 3*h;
        clear += isClear && distance > 3*h && i % 2 == 0;
        behind += isClear && distance < 0;
    }
    CHECK(behind == 0);

    // Half the diagonal, twice, and that times sqrt(3) at most: all of these
    CHECK(far > 1000);
    CHECK(clear == far);
}


TEST_CASE("adhesion holds a block by its area")
{
    // Thrown along a plane without weight: it decelerates by a/(rho height),
    // on the nodes, between them and across the cells
    const double height = 1, adhesion = 2000, speed = 4, time = 0.4;
    for (const double offset : {0.0, 0.03, 0.06})
    {
        for (const double angle : {0.0, 0.5})
        {
            CAPTURE(offset);
            CAPTURE(angle);
            const double c = std::cos(angle), s = std::sin(angle);
            mpm::PointData data = box(2, 0.1, {{20, 10, 0}});
            for (mpm::Point3& x : data.position)
            {
                const double along = x[0];
                const double above = x[1] + offset;
                x = {{c*along - s*above, s*along + c*above, 0}};
                data.velocity.push_back({{speed*c, speed*s, 0}});
            }
            mpm::Settings names = settings(2, 0.1);
            names.gravity = {{9.81*s, -9.81*c, 0}};
            mpm::Simulation<2> run
            (
                names,
                data,
                {elastic()},
                {plane({{-s*offset, c*offset, 0}}, {{-s, c, 0}}, adhesion)}
            );
            run.advance(time);
            const mpm::Diagnostics d = run.diagnostics();
            const double left =
                (c*d.momentum[0] + s*d.momentum[1])/d.mass;
            const double lost = adhesion*time/(2000*height);

            // Nodes at both ends of the block count to half a cell too much,
            // of 20
            CHECK(std::fabs((speed - left)/lost - 1) <= 0.05);
        }
    }

    mpm::WallSettings wall = plane({{0, 0, 0}}, {{0, 1, 0}}, 100);
    wall.condition = "slip";
    CHECK_THROWS_WITH
    (
        wall.validate(2), doctest::Contains("0 unless the condition is coulomb")
    );
    wall = plane({{0, 0, 0}}, {{0, 1, 0}}, -1);
    CHECK_THROWS_WITH(wall.validate(2), doctest::Contains(">= 0 [Pa]"));
}


TEST_CASE("a plane as a level set is a plane")
{
    // The block on an incline of both, to the round-off of the samples
    const auto slide = [](const bool sampled)
    {
        mpm::PointData data = box(2, 0.1, {{10, 5, 0}});
        mpm::WallSettings wall = plane({{0, 0, 0}}, {{0, 1, 0}});
        wall.friction = 0.1;
        if (sampled)
        {
            wall.type = "levelSet";
            wall.signedDistance = [](const mpm::Point3& x) { return x[1]; };
            wall.spacing = 0.05;
            wall.lower = {{-1, -1, 0}};
            wall.upper = {{4, 1, 0}};
        }
        mpm::Settings names = settings(2, 0.1);
        names.gravity = {{5, -8, 0}};
        mpm::Simulation<2> run(names, data, {elastic()}, {wall});
        run.advance(0.5);
        return run.field("displacement");
    };
    const std::vector<double> exact = slide(false);
    const std::vector<double> found = slide(true);
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        worst = std::max(worst, std::fabs(exact[i] - found[i]));
    }
    CHECK(worst <= 1e-9);
}


TEST_CASE("points thrown at obstacles stay outside, counted")
{
    for (const bool sampled : {false, true})
    {
        CAPTURE(sampled);
        mpm::WallSettings wall = obstacle(2);
        if (sampled)
        {
            const mpm::Wall<2> exact(wall, {{0, 1}});
            wall.type = "levelSet";
            wall.spacing = 0.05;
            wall.signedDistance = [exact](const mpm::Point3& x)
            {
                mpm::Vector<2> normal;
                return exact.distance({{x[0], x[1]}}, normal);
            };
        }
        mpm::PointData data = box(2, 0.1, {{8, 8, 0}});
        for (std::size_t i = 0; i < data.size(); ++i)
        {
            data.velocity.push_back({{20, -5, 0}});
        }
        mpm::Simulation<2> run(settings(2, 0.1), data, {soil()}, {wall});
        run.advance(0.5);

        const mpm::Wall<2> body(wall, {{0, 1}});
        const std::vector<double> x = run.field("position");
        REQUIRE(x.size() == 3*data.size());
        double deepest = 0;
        for (std::size_t i = 0; i < data.size(); ++i)
        {
            mpm::Vector<2> normal;
            deepest = std::min
            (
                deepest, body.distance({{x[3*i], x[3*i + 1]}}, normal)
            );
        }

        // At a corner of the samples a point is put back along a mean normal,
        // at most a spacing off
        CHECK(deepest >= (sampled ? -0.01 : -1e-12));
        CHECK(run.diagnostics().clampedByWalls > 0);
    }
}


TEST_CASE("loads go on after a restart and go back with a run that breaks")
{
    mpm::PointData data = box(2, 0.1, {{8, 8, 0}});
    data.velocity.assign(data.size(), {{5, 0, 0}});
    mpm::WallSettings wall = obstacle(2);
    wall.recordsLoad = true;
    const auto make = [&]()
    {
        return std::make_unique<mpm::Simulation<2>>
        (
            settings(2, 0.1), data, std::vector<mpm::Material>{soil()},
            std::vector<mpm::WallSettings>{wall}
        );
    };

    auto straight = make();
    straight->advance(0.1);
    std::stringstream state;
    straight->save(state);
    straight->advance(0.2);

    auto onward = make();
    onward->restore(state);
    onward->advance(0.2);
    const mpm::WallLoad& a = straight->wallLoads().at(0);
    const mpm::WallLoad& b = onward->wallLoads().at(0);
    CHECK(a.wall == "barrier");
    CHECK(a.impulse[0] > 0);
    CHECK(a.maxForce > 0);
    CHECK(a.impulse == b.impulse);
    CHECK(a.force == b.force);
    CHECK(a.maxForce == b.maxForce);
    CHECK(a.maxForceTime == b.maxForceTime);

    wall.recordsLoad = false;
    auto other = make();
    state.clear();
    state.seekg(0);
    CHECK_THROWS_WITH
    (
        other->restore(state), doctest::Contains("load is recorded")
    );
}

// ************************************************************************* //
