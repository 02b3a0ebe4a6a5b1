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
#include "threadRanks.H"

#include <doctest/doctest.h>

#include <sstream>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::shared_ptr<mpm::Communicator> Ranks;

//- What a run has come to
struct Outcome
{
    std::string saved;
    std::map<std::string, std::vector<double>> fields;
    std::vector<double> figures;
    mpm::Diagnostics last;

    void take(const mpm::Run& run)
    {
        std::ostringstream os;
        run.save(os);
        last = run.diagnostics();
        for (const std::string& name : mpm::Run::fields())
        {
            fields[name] = run.field(name);
        }
        saved = os.str();

        const mpm::Diagnostics& d = last;
        figures =
        {
            d.time, d.deltaT, double(d.step), d.kineticEnergy,
            d.affineKineticEnergy, d.elasticEnergy, d.potentialEnergy, d.mass,
            d.volume, d.momentum[0], d.momentum[1], d.momentum[2],
            d.angularMomentum[0], d.angularMomentum[2], d.maxDisplacement,
            d.maxVelocity, d.rmsVelocity, d.maxPlasticStrain, d.front,
            d.front99, d.crest, double(d.activePoints), double(d.movedPoints),
            double(d.yieldingPoints), double(d.clampedByWalls),
            double(d.sorts), double(d.sleepingPoints),
            d.plasticEnergy, d.frictionEnergy,
            d.impactEnergy, d.transferEnergy, d.integrationEnergy,
            d.energyRemainder
        };
    }
};


//- Equal to the last bit, the bytes of save() included
void checkSame(const Outcome& a, const Outcome& b)
{
    CHECK(a.figures.size() > 0);
    for (std::size_t i = 0; i < a.figures.size(); ++i)
    {
        CAPTURE(i);
        CHECK(a.figures[i] == b.figures[i]);
    }
    for (const auto& field : a.fields)
    {
        CAPTURE(field.first);
        const bool same = field.second == b.fields.at(field.first);
        CHECK(same);
    }
    const bool sameBytes = a.saved == b.saved;
    CHECK(sameBytes);
}


//- f(communicator, outcome) on so many ranks: the master's outcome
template<class Function>
Outcome on(const int nRanks, const Function& f)
{
    Outcome result;
    if (nRanks == 1)
    {
        f(std::make_shared<mpm::SerialCommunicator>(), result);
        return result;
    }
    threadRanks::run
    (
        nRanks,
        [&](const Ranks& ranks)
        {
            Outcome own;
            f(ranks, own);
            if (ranks->master())
            {
                result = own;
            }
        }
    );
    return result;
}


//- A column beside a corner that falls across the blocks of a small grid
template<int Dim>
std::unique_ptr<mpm::Simulation<Dim>> wideColumn
(
    const Ranks& ranks,
    mpm::Settings s,
    const int cells,
    const mpm::Material& material = soil()
)
{
    // Orderings, and blocks that change hands, every few steps
    s.sortInterval = 13;
    s.maxImbalance = 1.02;
    mpm::PointData data(box(Dim, s.cellSize, {{cells, cells, cells}}));
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        // Two laws, and a fast part
        data.frictionAngle[i] = i % 3 ? 20 : 35;
        data.velocity.push_back({{0, 0, 0}});
        data.velocity.back()[0] =
            data.position[i][Dim - 1] > 0.5*cells*s.cellSize ? 4 : 0;
    }

    // In a section a side with dashpots, which in space would slow the soil too
    // much for blocks to change hands, and a body in the way; what all walls
    // bear is in the bytes that are saved
    std::vector<mpm::WallSettings> walls(baseAndSide(Dim));
    mpm::WallSettings end;
    end.name = "end";
    end.condition = "absorbing";
    end.point[0] = cells*s.cellSize;
    end.normal = {{-1, 0, 0}};
    if (Dim == 2)
    {
        walls.push_back(end);
    }
    mpm::WallSettings body;
    body.name = "body";
    body.type = "box";
    body.condition = "coulomb";
    body.friction = 0.3;
    body.adhesion = 200;
    body.lower = {{(cells + 5.2)*s.cellSize, -1, -1}};
    body.upper = {{(cells + 9)*s.cellSize, 20, 0.4*cells*s.cellSize}};
    walls.push_back(body);
    for (mpm::WallSettings& wall : walls)
    {
        wall.recordsLoad = true;
    }
    return std::make_unique<mpm::Simulation<Dim>>
    (
        s, data, std::vector<mpm::Material>{material}, walls, ranks
    );
}


mpm::Settings named
(
    mpm::Settings s,
    const std::string& shape,
    const std::string& transfer,
    const std::string& update
)
{
    s.shapeFunction = shape;
    s.transferScheme = transfer;
    s.stressUpdate = update;
    return s;
}


template<int Dim>
void checkRanks
(
    const mpm::Settings& s,
    const int cells,
    const int steps,
    const double dilationAngle = 0,
    const mpm::SofteningSettings& softening = mpm::SofteningSettings()
)
{
    CAPTURE(Dim);
    CAPTURE(s.symmetry);
    CAPTURE(s.transferScheme);
    CAPTURE(s.stressUpdate);
    CAPTURE(s.antiLocking);
    mpm::Material material(soil());
    material.dilationAngle = dilationAngle;
    material.softening = softening;

    const auto fall = [&](const Ranks& ranks, Outcome& outcome)
    {
        auto run = wideColumn<Dim>(ranks, s, cells, material);
        for (int i = 0; i < steps; ++i)
        {
            run->step(1);
        }
        outcome.take(*run);
    };
    const Outcome one = on(1, fall);
    CHECK((one.last.sleepingPoints > 0) == (s.sleepVelocity > 0));
    long rebalances = 0;
    for (const int nRanks : {2, 3, 5})
    {
        CAPTURE(nRanks);
        const Outcome several = on(nRanks, fall);
        rebalances += several.last.rebalances;
        checkSame(one, several);
    }
    CHECK(rebalances > 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("several ranks give the run of one, bit by bit")
{
    checkRanks<2>(settings(2, 0.1), 20, 300);
    checkRanks<3>(settings(3, 0.2), 7, 100);

    // The generic kernels scatter once to four times a step; patches reach one,
    // two or three nodes beyond their blocks
    const auto section = [](auto... names)
    {
        checkRanks<2>(named(settings(2, 0.1), names...), 20, 100);
    };
    section("linear", "FLIP", "MUSL");
    section("cpGIMP", "TPIC", "USL");
    section("quadraticBSpline", "AFLIP", "USF");
    section("cubicBSpline", "XPIC", "USL");
    checkRanks<3>
    (
        named(settings(3, 0.2), "quadraticBSpline", "FLIP", "USF"), 7, 40
    );

    section("linear", "FLIP", "USF");

    // What blocks know of their rest goes with them
    const auto sleepy = [](mpm::Settings s, const double sleepVelocity)
    {
        s.sleepVelocity = sleepVelocity;
        s.sleepDelay = 0.01;
        return s;
    };
    checkRanks<2>(sleepy(settings(2, 0.1), 0.5), 20, 300);
    checkRanks<3>(sleepy(settings(3, 0.2), 0.5), 7, 100);
    checkRanks<2>
    (
        sleepy(named(settings(2, 0.1), "linear", "FLIP", "USF"), 2), 20, 100
    );

    // The average against locking sends patches of its own; what a soil dilates
    // goes with its points
    for (const char* antiLocking : {"node", "cell"})
    {
        mpm::Settings s = settings(2, 0.1);
        s.antiLocking = antiLocking;
        checkRanks<2>(s, 20, 100, 15);
        s.symmetry = "axisymmetric";
        checkRanks<2>(s, 20, 100, 15);
        s = settings(3, 0.2);
        s.antiLocking = antiLocking;
        checkRanks<3>(s, 7, 40, 15);
    }

    // So does the nonlocal plastic strain
    mpm::SofteningSettings nonlocal;
    nonlocal.residualFrictionAngle = 10;
    nonlocal.residualStrain = 0.3;
    nonlocal.length = 1;
    checkRanks<2>(settings(2, 0.1), 20, 100, 0, nonlocal);
    checkRanks<3>(settings(3, 0.2), 7, 100, 0, nonlocal);

    // Nodes that ranks share count once in the energy account
    mpm::Settings s = settings(2, 0.1);
    s.energyAccount = true;
    checkRanks<2>(s, 20, 100);
    s = settings(3, 0.2);
    s.energyAccount = true;
    checkRanks<3>(s, 7, 100);
}


TEST_CASE("threads in ranks change nothing")
{
    mpm::Settings s(settings(2, 0.1));
    const auto fall = [&](const Ranks& ranks, Outcome& outcome)
    {
        mpm::Settings mine(s);
        mine.threads = ranks->size();
        auto run = wideColumn<2>(ranks, mine, 20);
        run->advance(0.1);
        outcome.take(*run);
    };
    checkSame(on(1, fall), on(2, fall));
}


TEST_CASE("ranks without points: more of them than blocks")
{
    const auto fall = [](const Ranks& ranks, Outcome& outcome)
    {
        auto run = wideColumn<2>(ranks, settings(2, 0.5), 4);
        run->advance(0.3);
        outcome.take(*run);
    };
    const Outcome several = on(7, fall);
    CHECK(several.last.idleRanks > 0);
    checkSame(on(1, fall), several);
}


TEST_CASE("the start state of several ranks is that of one")
{
    const auto check = [](auto dimension, const std::string& type)
    {
        constexpr int Dim = decltype(dimension)::value;
        const auto start = [&](const Ranks& ranks, Outcome& outcome)
        {
            auto run = wideColumn<Dim>
            (
                ranks, settings(Dim, Dim == 2 ? 0.1 : 0.2), Dim == 2 ? 20 : 7
            );
            mpm::StartSettings s;
            s.type = type;
            s.elasticTime = 0.1;
            s.relaxationTime = 0.2;
            s.addedCohesion = 100;
            s.stableFrictionAngle.assign(run->nPoints(), 25);
            const mpm::StartReport r = run->establishStart(s);
            run->advance(0.05);
            outcome.take(*run);
            for
            (
                const double x :
                {
                    r.time, double(r.steps), double(r.resets), r.rmsVelocity,
                    r.settlement, r.maxDisplacement, r.yieldedFraction,
                    r.outOfBalance, r.outsideFraction, r.maxExcess
                }
            )
            {
                outcome.figures.push_back(x);
            }
        };
        const Outcome one = on(1, start);
        checkSame(one, on(2, start));
        checkSame(one, on(3, start));
    };
    check(std::integral_constant<int, 2>(), "columnK0");
    check(std::integral_constant<int, 2>(), "elasticGravity");
    check(std::integral_constant<int, 3>(), "columnK0");
}


TEST_CASE("what some ranks saved, others go on from")
{
    const auto straight = [](const Ranks& ranks, Outcome& outcome)
    {
        auto run = wideColumn<2>(ranks, settings(2, 0.1), 20);
        for (int i = 0; i < 100; ++i)
        {
            run->step(1);
        }
        outcome.take(*run);
    };
    const auto half = [](const Ranks& ranks, Outcome& outcome)
    {
        auto run = wideColumn<2>(ranks, settings(2, 0.1), 20);
        for (int i = 0; i < 47; ++i)
        {
            run->step(1);
        }
        outcome.take(*run);
    };
    const Outcome whole = on(1, straight);
    for (const std::array<int, 2>& n : {std::array<int, 2>{{3, 2}}, {{1, 3}}, {{2, 1}}})
    {
        CAPTURE(n);
        const Outcome saved = on(n[0], half);
        const auto other = [&saved](const Ranks& ranks, Outcome& outcome)
        {
            auto run = wideColumn<2>(ranks, settings(2, 0.1), 20);
            std::istringstream is(ranks->master() ? saved.saved : "");
            run->restore(is);
            for (int i = 47; i < 100; ++i)
            {
                run->step(1);
            }
            outcome.take(*run);
        };
        checkSame(whole, on(n[1], other));
    }
}


TEST_CASE("a broken point of one rank stops all with one message, and all go back")
{
    const auto breaks = [](const Ranks& ranks, Outcome& outcome)
    {
        auto run = wideColumn<2>(ranks, settings(2, 0.1), 20, elastic());
        run->advance(0.02);

        // Towards each other so fast that cells collapse within a step
        std::vector<double> v(3*run->nPoints(), 0.0);
        for (std::size_t i = 0; i < run->nPoints(); ++i)
        {
            v[3*i + 1] = 1e4*(i < run->nPoints()/2 ? 1 : -1);
        }
        run->setField("velocity", v);
        std::string message;
        try
        {
            run->advance(1);
        }
        catch (const std::runtime_error& e)
        {
            message = e.what();
        }
        outcome.take(*run);
        outcome.saved += message;
        outcome.figures.push_back(message.empty());
    };
    const Outcome one = on(1, breaks);
    CHECK(one.figures.back() == 0);
    checkSame(one, on(3, breaks));
}


TEST_CASE("wrong input of one rank's points is refused by all")
{
    const auto wrong = []
    (
        const Ranks& ranks,
        const std::function<void(mpm::PointData&, mpm::Material&)>& spoil
    )
    {
        mpm::Settings s(settings(2, 0.1));
        mpm::PointData data(box(2, s.cellSize, {{20, 20, 1}}));
        mpm::Material material(soil());
        spoil(data, material);
        mpm::Simulation<2>(s, data, {material}, baseAndSide(2), ranks);
    };
    CHECK_THROWS_WITH_AS
    (
        threadRanks::run
        (
            3,
            [&](const Ranks& ranks)
            {
                wrong
                (
                    ranks,
                    [](mpm::PointData& d, mpm::Material& m)
                    {
                        m.dilationAngle = 25;
                        d.frictionAngle.back() = 10;
                    }
                );
            }
        ),
        doctest::Contains("dilationAngle"),
        std::invalid_argument
    );
    CHECK_THROWS_WITH_AS
    (
        threadRanks::run
        (
            3,
            [&](const Ranks& ranks)
            {
                wrong
                (
                    ranks,
                    [](mpm::PointData& d, mpm::Material&)
                    {
                        d.position[1000][0] = 1e9;
                    }
                );
            }
        ),
        doctest::Contains("point 1000 at ( 1e+09"),
        std::invalid_argument
    );
}


// ************************************************************************* //
