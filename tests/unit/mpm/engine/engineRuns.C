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

#include <doctest/doctest.h>

#include <sstream>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Equal to the last bit
void checkSame(const mpm::Run& a, const mpm::Run& b)
{
    CHECK(a.time() == b.time());
    CHECK(a.stepNumber() == b.stepNumber());
    for (const std::string& name : mpm::Run::fields())
    {
        CAPTURE(name);
        const bool same = a.field(name) == b.field(name);
        CHECK(same);
    }
}


template<int Dim>
void checkRestart(mpm::Settings s, const double dilationAngle = 0)
{
    CAPTURE(Dim);
    CAPTURE(s.transferScheme);

    // Orderings fall before, on and after the restart
    s.sortInterval = 17;
    const int cells = Dim == 2 ? 8 : 4;
    auto straight = column<Dim>(s, cells, dilationAngle);
    auto first = column<Dim>(s, cells, dilationAngle);
    for (int i = 0; i < 120; ++i)
    {
        straight->step(1);
    }
    for (int i = 0; i < 47; ++i)
    {
        first->step(1);
    }
    std::stringstream saved;
    first->save(saved);

    auto second = column<Dim>(s, cells, dilationAngle);
    second->restore(saved);
    checkSame(*first, *second);
    for (int i = 47; i < 120; ++i)
    {
        second->step(1);
    }
    checkSame(*straight, *second);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("restart repeats the unbroken run to the last bit")
{
    checkRestart<2>(settings(2, 0.1));
    checkRestart<3>(settings(3, 0.1));

    mpm::Settings s = settings(2, 0.1);
    s.shapeFunction = "linear";
    s.transferScheme = "FLIP";
    s.stressUpdate = "USF";
    checkRestart<2>(s);

    s.shapeFunction = "cpGIMP";
    s.transferScheme = "XPIC";
    s.stressUpdate = "MUSL";
    checkRestart<2>(s);

    // Soil that dilates, whose last dilation is state
    for (const char* antiLocking : {"node", "cell"})
    {
        s = settings(2, 0.1);
        s.antiLocking = antiLocking;
        checkRestart<2>(s, 20);
        mpm::Settings s3 = settings(3, 0.1);
        s3.antiLocking = antiLocking;
        checkRestart<3>(s3, 20);
    }
}


TEST_CASE("the energy account looks on, and restarts with the run")
{
    mpm::Settings s = settings(2, 0.1);
    auto without = column<2>(s, 8);
    s.energyAccount = true;
    auto with = column<2>(s, 8);
    for (int i = 0; i < 60; ++i)
    {
        without->step(1);
        with->step(1);
    }
    checkSame(*without, *with);
    CHECK(!without->diagnostics().energyAccount);
    CHECK(with->diagnostics().plasticEnergy > 0);
    CHECK(with->diagnostics().transferEnergy > 0);

    checkRestart<2>(s);
    std::stringstream saved;
    with->save(saved);
    auto second = column<2>(s, 8);
    second->restore(saved);
    const mpm::Diagnostics a = with->diagnostics();
    const mpm::Diagnostics b = second->diagnostics();
    CHECK(a.lostEnergy() == b.lostEnergy());
    CHECK(a.energyRemainder == b.energyRemainder);
}


TEST_CASE("a run of several threads repeats that of one to the last bit")
{
    const auto check = [](const auto& make, const int dimension)
    {
        mpm::Settings s = settings(dimension, 0.05);
        auto one = make(s);
        s.threads = 3;
        auto three = make(s);
        one->advance(0.15);
        three->advance(0.15);
        checkSame(*one, *three);
    };
    check([](const mpm::Settings& s) { return column<2>(s, 20); }, 2);
    check([](const mpm::Settings& s) { return column<3>(s, 6); }, 3);
    check
    (
        [](mpm::Settings s)
        {
            s.antiLocking = "node";
            return column<2>(s, 20, 20);
        },
        2
    );
}


TEST_CASE("runs beside each other do not know of each other")
{
    auto alone = column<2>(settings(2, 0.1), 8);
    auto a = column<2>(settings(2, 0.1), 8);
    auto b = column<2>(settings(2, 0.2), 3);
    for (int i = 0; i < 60; ++i)
    {
        alone->step(1);
    }
    for (int i = 0; i < 60; ++i)
    {
        a->step(1);
        b->step(1);
    }
    checkSame(*alone, *a);
}


TEST_CASE("advance ends on time, in steps that are never tiny")
{
    auto run = column<2>(settings(2, 0.1), 5);
    for (const double end : {0.1, 0.1001, 0.25})
    {
        run->advance(end);
        CHECK(run->time() == end);
    }
    CHECK(run->diagnostics().deltaT > 1e-5);
}


TEST_CASE("memory follows the blocks in use, not the space between")
{
    mpm::PointData near = box(2, 0.1, {{8, 8, 0}});
    mpm::PointData far(near);
    for (std::size_t i = 0; i < far.size()/2; ++i)
    {
        far.position[i][0] += 1000;
        far.position[i][1] -= 500;
    }
    mpm::Simulation<2> together(settings(2, 0.1), near, {soil()}, {});
    mpm::Simulation<2> apart(settings(2, 0.1), far, {soil()}, {});

    // Two clusters have at most twice the rims of one
    CHECK
    (
        apart.diagnostics().activeBlocks
     <= 2*together.diagnostics().activeBlocks
    );

    // 10,000 points of a section in 400 bytes each
    auto large = column<2>(settings(2, 0.02), 50);
    large->advance(0.05);
    CHECK(large->diagnostics().bytesPerPoint < 400);
}


TEST_CASE("fields come in the order in which the points were given")
{
    auto run = column<2>(settings(2, 0.1), 6);
    const mpm::PointData data = box(2, 0.1, {{6, 6, 6}});
    run->advance(0.02);

    const std::vector<double> x = run->field("position");
    const std::vector<double> u = run->field("displacement");
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        for (int d = 0; d < 2; ++d)
        {
            // Round-off of a few steps of addition
            CHECK
            (
                std::fabs(x[3*i + d] - u[3*i + d] - data.position[i][d])
             <= 1e-14
            );
        }
    }

    std::vector<double> cohesion(data.size());
    for (std::size_t i = 0; i < cohesion.size(); ++i)
    {
        cohesion[i] = -100.0*double(i);
    }
    run->setField("cohesionIntercept", cohesion);
    CHECK(run->field("cohesionIntercept") == cohesion);

    std::vector<double> angle(data.size(), 25);
    angle[3] = 35;
    run->setField("frictionAngle", angle);
    CHECK(run->field("frictionAngle") == angle);
}


TEST_CASE("a point that breaks stops the run, which keeps its last good state")
{
    mpm::Settings s = settings(2, 0.1);
    mpm::Simulation<2> run
    (
        s, box(2, 0.1, {{4, 4, 0}}), {elastic()}, baseAndSide(2)
    );
    run.advance(0.01);
    const std::vector<double> x = run.field("position");

    // Towards each other so fast that cells collapse within a step
    std::vector<double> v(3*run.nPoints(), 0);
    for (std::size_t i = 0; i < run.nPoints(); ++i)
    {
        v[3*i + 1] = 1e4*(i < run.nPoints()/2 ? 1 : -1);
    }
    run.setField("velocity", v);

    std::string message;
    try
    {
        run.advance(0.1);
    }
    catch (const std::runtime_error& e)
    {
        message = e.what();
    }
    for (const char* part : {"point ", " at (", "material sand", "step "})
    {
        CAPTURE(part);
        CHECK(message.find(part) != std::string::npos);
    }
    CHECK(run.time() == 0.01);
    CHECK(run.field("position") == x);
}


// ************************************************************************* //
