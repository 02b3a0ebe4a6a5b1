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
#include "mpmMovePoint.H"

#include <doctest/doctest.h>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::WallSettings plane(const char* condition, const double friction = 0)
{
    mpm::WallSettings wall;
    wall.condition = condition;
    wall.friction = friction;
    wall.normal = {{0, 2, 0}};
    return wall;
}


mpm::Vector<2> after
(
    const mpm::WallSettings& settings,
    const mpm::Vector<2>& before
)
{
    const mpm::Wall<2> wall(settings, {{0, 1}});
    mpm::Vector<2> v(before);
    wall.act({{0, 1}}, v);
    return v;
}

//- Of a step that ends so far behind the wall
mpm::Vector<2> change
(
    const mpm::WallSettings& settings,
    const double behind,
    const mpm::Vector<2>& step
)
{
    const mpm::Wall<2> wall(settings, {{0, 1}});
    return mpm::changeOfStep<2>(wall, {{0, 1}}, -behind, step);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("what walls leave of a velocity")
{
    typedef mpm::Vector<2> V;

    CHECK(after(plane("rough"), {{3, 4}}) == V{{0, 0}});
    CHECK(after(plane("roller"), {{3, 4}}) == V{{3, 0}});
    CHECK(after(plane("roller"), {{3, -4}}) == V{{3, 0}});
    CHECK(after(plane("slip"), {{3, 4}}) == V{{3, 4}});
    CHECK(after(plane("slip"), {{3, -4}}) == V{{3, 0}});

    // Friction takes mu times the impulse across: 3 - 0.5 x 4; exact numbers
    CHECK(after(plane("coulomb", 0.5), {{3, -4}}) == V{{1, 0}});
    CHECK(after(plane("coulomb", 0.5), {{-3, -4}}) == V{{-1, 0}});
    CHECK(after(plane("coulomb", 0.8), {{3, -4}}) == V{{0, 0}});
    CHECK(after(plane("coulomb", 0.5), {{3, 4}}) == V{{3, 4}});
}


TEST_CASE("what walls change of a step that ends behind them")
{
    typedef mpm::Vector<2> V;

    // Half of it is behind: half of what the wall takes; exact numbers
    CHECK(change(plane("rough"), 2, {{3, -4}}) == V{{-1.5, 2}});
    CHECK(change(plane("slip"), 2, {{3, -4}}) == V{{0, 2}});
    CHECK(change(plane("coulomb", 0.5), 2, {{3, -4}}) == V{{-1, 2}});
    CHECK(change(plane("coulomb", 0.8), 2, {{3, -4}}) == V{{-1.5, 2}});

    // From behind: all of what the wall takes, and out on its normal
    CHECK(change(plane("rough"), 3, {{3, -1}}) == V{{-3, 3}});
    CHECK(change(plane("slip"), 3, {{3, -1}}) == V{{0, 3}});

    // On its way out
    CHECK(change(plane("rough"), 1, {{3, 1}}) == V{{0, 1}});

    mpm::WallSettings floor;
    floor.condition = "rough";
    floor.normal = {{0, 0, 1}};
    const mpm::Wall<3> wall(floor, {{0, 0, 1}});
    const mpm::Vector<3> expected{{-0.25, -0.5, 1}};
    CHECK
    (
        mpm::changeOfStep<3>(wall, {{0, 0, 1}}, -1, {{1, 2, -4}}) == expected
    );
}


TEST_CASE("distance to a plane")
{
    mpm::WallSettings settings;
    settings.point = {{1, 1, 1}};
    settings.normal = {{3, 0, 4}};
    const mpm::Wall<3> wall(settings, {{0, 0, 1}});

    mpm::Vector<3> n;
    CHECK(std::fabs(wall.distance({{4, 7, 5}}, n) - 5) <= 1e-14);
    CHECK(std::fabs(n[0] - 0.6) <= 1e-15);
    CHECK(std::fabs(n[2] - 0.8) <= 1e-15);
}


TEST_CASE("distance to a terrain line")
{
    mpm::WallSettings settings;
    settings.type = "terrain";
    settings.vertices = {{{0, 0, 0}}, {{4, 3, 0}}, {{8, 0, 0}}};
    const mpm::Wall<2> hill(settings, {{0, 1}});

    // Rising from the other end makes no difference
    std::reverse(settings.vertices.begin(), settings.vertices.end());
    const mpm::Wall<2> same(settings, {{0, 1}});

    for (const mpm::Wall<2>& wall : {hill, same})
    {
        mpm::Vector<2> n;

        // Above and below the middle of the first piece, normal (-.6, .8)
        CHECK(std::fabs(wall.distance({{1.4, 2.3}}, n) - 1) <= 1e-14);
        CHECK(std::fabs(n[0] + 0.6) <= 1e-14);
        CHECK(std::fabs(wall.distance({{2.6, 0.7}}, n) + 1) <= 1e-14);
        CHECK(std::fabs(n[0] + 0.6) <= 1e-14);

        // Over the top the corner is nearest
        CHECK(std::fabs(wall.distance({{4, 5}}, n) - 2) <= 1e-14);
        CHECK(std::fabs(n[1] - 1) <= 1e-14);

        // The pieces go on beyond their ends: (-4, -3) is on the line
        CHECK(std::fabs(wall.distance({{-4, -3}}, n)) <= 1e-14);
        CHECK(std::fabs(wall.distance({{-4 - 0.6, -3 + 0.8}}, n) - 1) <= 1e-14);

        // On the line itself
        CHECK(std::fabs(wall.distance({{2, 1.5}}, n)) <= 1e-14);
        CHECK(std::fabs(n[1] - 0.8) <= 1e-14);
    }
}


TEST_CASE("distance to a terrain surface")
{
    // A roof along y, of several triangles on either side: beside its rim it
    // is the line of the section
    mpm::WallSettings line;
    line.type = "terrain";
    line.vertices = {{{0, 0, 0}}, {{4, 3, 0}}, {{8, 0, 0}}};
    const mpm::Wall<2> section(line, {{0, 1}});

    mpm::WallSettings roof;
    roof.type = "terrain";
    constexpr int n = 5;
    for (int j = 0; j < n; ++j)
    {
        roof.vertices.push_back({{0, 2.0*j, 0}});
        roof.vertices.push_back({{4, 2.0*j, 3}});
        roof.vertices.push_back({{8, 2.0*j, 0}});
    }
    for (int j = 0; j + 1 < n; ++j)
    {
        for (int side = 0; side < 2; ++side)
        {
            // Either sense of rotation
            const int a = 3*j + side;
            roof.triangles.push_back({{a, a + 1, a + 3}});
            roof.triangles.push_back({{a + 1, a + 3, a + 4}});
        }
    }
    const mpm::Wall<3> surface(roof, {{0, 0, 1}});

    for (double x = 0.55; x < 8; x += 0.7)
    {
        for (double z = 0.35; z < 6; z += 0.45)
        {
            mpm::Vector<2> n2;
            mpm::Vector<3> n3;
            const double expected = section.distance({{x, z}}, n2);
            const double found = surface.distance({{x, 4.3, z}}, n3);
            CAPTURE(x);
            CAPTURE(z);

            // Nearest places within the rim of the surface
            if (std::fabs(expected) < 1.4 && x > 2 && x < 6)
            {
                CHECK(std::fabs(found - expected) <= 1e-13);
                CHECK(std::fabs(n3[0] - n2[0]) <= 1e-12);
                CHECK(std::fabs(n3[2] - n2[1]) <= 1e-12);
                CHECK(std::fabs(n3[1]) <= 1e-12);
            }
        }
    }

    // Beyond the rim the last triangle's plane goes on
    mpm::Vector<3> normal;
    CHECK(std::fabs(surface.distance({{-4, 4, -3}}, normal)) <= 1e-13);
    CHECK(std::fabs(surface.distance({{-4.6, 4, -2.2}}, normal) - 1) <= 1e-13);
}


TEST_CASE("a roller on the grid's nodes is a plane of symmetry")
{
    // A body that swings at a roller is half of one that swings alone, to the
    // round-off of other orders of summation over some steps
    const auto check = [](auto dimension, const mpm::Settings& names)
    {
        constexpr int Dim = decltype(dimension)::value;
        CAPTURE(Dim);
        CAPTURE(names.shapeFunction);
        CAPTURE(names.transferScheme);

        mpm::PointData half = box(Dim, 0.1, {{4, 3, 2}});
        for (const mpm::Point3& x : half.position)
        {
            half.velocity.push_back
            (
                {{5*x[0]*(x[1] - 0.1), x[0] - 2*x[1], Dim == 3 ? x[1] : 0}}
            );
        }
        mpm::PointData whole(half);
        for (std::size_t i = 0; i < half.size(); ++i)
        {
            mpm::Point3 x = half.position[i];
            mpm::Point3 v = half.velocity[i];
            x[0] *= -1;
            v[0] *= -1;
            whole.position.push_back(x);
            whole.velocity.push_back(v);
            whole.volume.push_back(half.volume[i]);
            whole.rho.push_back(half.rho[i]);
            whole.zone.push_back(0);
            whole.cohesionIntercept.push_back(0);
            whole.frictionAngle.push_back(0);
        }

        mpm::WallSettings side;
        side.normal = {{1, 0, 0}};
        side.condition = "roller";
        mpm::Settings s(names);
        s.cellSize = 0.1;
        mpm::Simulation<Dim> atWall(s, half, {elastic()}, {side});
        mpm::Simulation<Dim> alone(s, whole, {elastic()}, {});
        for (int i = 0; i < 20; ++i)
        {
            atWall.step(1);
            alone.step(1);
        }
        for (const std::string name : {"displacement", "sigma"})
        {
            CAPTURE(name);
            const std::vector<double> a = atWall.field(name);
            const std::vector<double> b = alone.field(name);
            double difference = 0, largest = 0;
            for (std::size_t i = 0; i < a.size(); ++i)
            {
                difference = std::max(difference, std::fabs(a[i] - b[i]));
                largest = std::max(largest, std::fabs(a[i]));
            }
            CHECK(largest > 0);
            CHECK(difference <= 1e-11*largest);
        }
    };

    mpm::Settings names;
    for (const char* update : {"USL", "MUSL"})
    {
        names.stressUpdate = update;
        check(std::integral_constant<int, 2>(), names);
        check(std::integral_constant<int, 3>(), names);
    }
    names.transferScheme = "XPIC";
    for (const std::string& shape : mpm::Settings::shapeFunctions())
    {
        names.shapeFunction = shape;
        check(std::integral_constant<int, 2>(), names);
        check(std::integral_constant<int, 3>(), names);
    }
}


TEST_CASE("behind a rough wall on the grid's nodes velocities are odd")
{
    mpm::PointData data = box(2, 0.1, {{8, 6, 0}});
    data.velocity.assign(data.size(), {{1, 0, 0}});
    mpm::WallSettings base;
    base.normal = {{0, 1, 0}};
    mpm::Settings s = settings(2, 0.1, 0);
    s.transferScheme = "PIC";
    mpm::Simulation<2> run(s, data, {elastic()}, {base});
    run.step(1e-12);

    // Points at 1/4, 3/4, ... of a cell over the wall. The node above the wall
    // gets 9/32 + 22/32 + 22/32 + 9/32 + 1/32 of them, and 1/32 of the lowest
    // one's image, of mass 1 and velocity -1; the lowest one takes 9/32 of
    // this node and 1/32 of its image
    const double node = 62.0/64;
    const std::vector<double> v = run.field("velocity");
    int n = 0;
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        const mpm::Point3& x = data.position[i];
        if (x[0] > 0.2 && x[0] < 0.6 && x[1] < 0.05)
        {
            CHECK(std::fabs(v[3*i] - node*8/32) <= 1e-9);
            ++n;
        }
    }
    CHECK(n == 8);
}


TEST_CASE("points thrown at walls stay inside, counted")
{
    // 30 m/s into a corner of a terrain and a plane, waves at 26 m/s: the
    // worst a slide could do, ten times over
    mpm::WallSettings ground;
    ground.type = "terrain";
    ground.condition = "coulomb";
    ground.friction = 0.2;
    ground.vertices = {{{-5, 3, 0}}, {{0, 0, 0}}, {{5, 1, 0}}};
    mpm::WallSettings stop;
    stop.normal = {{-1, 0, 0}};
    stop.point = {{2, 0, 0}};
    stop.condition = "slip";

    mpm::PointData data = box(2, 0.1, {{8, 8, 0}});
    for (mpm::Point3& x : data.position)
    {
        x[1] += 0.5;
        data.velocity.push_back({{20, -22, 0}});
    }
    mpm::Simulation<2> run(settings(2, 0.1), data, {soil()}, {ground, stop});
    run.advance(1);

    const mpm::Wall<2> line(ground, {{0, 1}});
    const std::vector<double> x = run.field("position");
    REQUIRE(x.size() == 3*data.size());
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        mpm::Vector<2> normal;
        CHECK(line.distance({{x[3*i], x[3*i + 1]}}, normal) >= -1e-12);
        CHECK(x[3*i] <= 2 + 1e-12);
    }
    CHECK(run.diagnostics().clampedByWalls > 0);
}


TEST_CASE("points that leave the largest grid are held and counted")
{
    // A cell's length before the last block, outwards
    constexpr double h = 0.125;
    constexpr double rim =
        h*mpm::BlockGrid<2>::edge*mpm::BlockGrid<2>::maxBlock;
    mpm::PointData data = box(2, h, {{1, 1, 0}});
    for (mpm::Point3& x : data.position)
    {
        x[0] += rim - 2*h;
        data.velocity.push_back({{10, 0, 0}});
    }
    mpm::Simulation<2> run(settings(2, h, 0), data, {elastic()}, {});
    run.advance(0.1);

    const std::vector<double> x = run.field("position");
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        CHECK(x[3*i] < rim);
        CHECK(x[3*i] > rim - 25*h);
    }
    CHECK(run.diagnostics().clampedByGrid >= data.size());
}


// ************************************************************************* //
