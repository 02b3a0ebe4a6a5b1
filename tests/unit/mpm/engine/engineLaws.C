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
    Runs with several constitutive laws.

\*---------------------------------------------------------------------------*/

#include "engineCases.H"

#include <doctest/doctest.h>

#include <sstream>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

mpm::Material neoHookean()
{
    mpm::Material material(soil());
    material.name = "rubber";
    material.constitutiveModel = "neoHookean";
    return material;
}


mpm::Material softCone()
{
    mpm::Material material(soil());
    material.name = "softening cone";
    material.constitutiveModel = "DruckerPrager";
    material.viscosity = 10;
    material.softening.residualFrictionAngle = 20;
    material.softening.residualStrain = 0.01;
    material.softening.length = 0.1;
    material.softening.regularisation = "crackBand";
    return material;
}


mpm::Material nonlocalSand(const double cellSize)
{
    mpm::Material material(soil());
    material.name = "softening sand";
    material.softening.residualFrictionAngle = 20;
    material.softening.residualStrain = 0.01;

    // The mean is of every second step
    material.softening.length = 6*cellSize;
    return material;
}


//- Points of the first zones in turn, for as many zones as are given
void takeTurns(mpm::PointData& data, const int nZones)
{
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        data.zone[i] = int(i) % nZones;
    }
}


template<int Dim>
void checkRestart(const mpm::Settings& s)
{
    CAPTURE(Dim);
    mpm::PointData data = box(Dim, s.cellSize, {{6, 6, 4}});
    takeTurns(data, 5);
    const std::vector<mpm::Material> materials
    {
        soil(), elastic(), neoHookean(), softCone(), nonlocalSand(s.cellSize)
    };
    mpm::Simulation<Dim> straight(s, data, materials, baseAndSide(Dim));
    mpm::Simulation<Dim> first(s, data, materials, baseAndSide(Dim));
    for (int i = 0; i < 60; ++i)
    {
        straight.step(1);
    }
    for (int i = 0; i < 25; ++i)
    {
        first.step(1);
    }
    std::stringstream saved;
    first.save(saved);
    mpm::Simulation<Dim> second(s, data, materials, baseAndSide(Dim));
    second.restore(saved);
    for (int i = 25; i < 60; ++i)
    {
        second.step(1);
    }
    for (const std::string& name : mpm::Run::fields())
    {
        CAPTURE(name);
        const bool same = straight.field(name) == second.field(name);
        CHECK(same);
    }

    mpm::Simulation<Dim> other(s, data, std::vector<mpm::Material>(5, soil()), {});
    saved.clear();
    saved.seekg(0);
    CHECK_THROWS_WITH_AS
    (
        other.restore(saved),
        "The saved run was made with other constitutive models, another "
        "antiLocking or another energyAccount",
        std::runtime_error
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("points update law by law as they do when all share the fast path")
{
    mpm::PointData data = box(2, 0.1, {{6, 6, 1}});
    takeTurns(data, 2);
    mpm::PointData more = data;
    more.position.push_back({{100, 100, 0}});
    more.volume.push_back(1e-3);
    more.rho.push_back(2000);
    more.zone.push_back(2);
    more.cohesionIntercept.push_back(0);
    more.frictionAngle.push_back(30);

    const std::vector<mpm::Material> materials
    {
        soil(), elastic(), neoHookean()
    };
    mpm::Simulation<2> fast
    (
        settings(2, 0.1), data, {soil(), elastic()}, baseAndSide(2)
    );
    mpm::Simulation<2> byLaw
    (
        settings(2, 0.1), more, materials, baseAndSide(2)
    );
    for (int i = 0; i < 50; ++i)
    {
        fast.step(1e-3);
        byLaw.step(1e-3);
    }
    const std::vector<double> a = fast.field("sigma");
    const std::vector<double> b = byLaw.field("sigma");
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        worst = std::max(worst, std::fabs(a[i] - b[i]));
        largest = std::max(largest, std::fabs(a[i]));
    }
    CHECK(fast.diagnostics().yieldingPoints > 0);
    CHECK(worst <= 1e-10*largest);
}


TEST_CASE("a spinning neo-Hookean body moves as a linear elastic one while "
    "strains are small")
{
    const double cellSize = 0.1, spin = 1;
    mpm::PointData data = box(2, cellSize, {{8, 8, 1}});
    for (const mpm::Point3& x : data.position)
    {
        data.velocity.push_back
        ({{
            -spin*(x[1] - 0.4), spin*(x[0] - 0.4), 0
        }});
    }
    const auto turned = [&](const mpm::Material& material)
    {
        mpm::Simulation<2> run(settings(2, cellSize, 0), data, {material}, {});
        run.advance(3);
        return run.diagnostics();
    };
    const mpm::Diagnostics linear = turned(elastic());
    const mpm::Diagnostics finite = turned(neoHookean());

    // Strains rho (spin R)^2/E are below 4e-4, and so is what the laws differ
    // by; nearly half a turn takes the corners 1.1 m
    CHECK(linear.maxDisplacement > 1);
    CHECK
    (
        finite.maxDisplacement
     == doctest::Approx(linear.maxDisplacement).epsilon(1e-3)
    );
    CHECK
    (
        finite.kineticEnergy
     == doctest::Approx(linear.kineticEnergy).epsilon(4e-3)
    );
    CHECK(finite.volume == doctest::Approx(linear.volume).epsilon(4e-4));
}


TEST_CASE("mixed laws restart to the last bit")
{
    checkRestart<2>(settings(2, 0.1));
    checkRestart<3>(settings(3, 0.1));

    mpm::Settings paper = settings(2, 0.1);
    paper.shapeFunction = "linear";
    paper.transferScheme = "FLIP";
    paper.stressUpdate = "USF";
    checkRestart<2>(paper);
}


TEST_CASE("a stress that follows from the deformation cannot be given")
{
    mpm::PointData data = box(2, 0.1, {{2, 2, 1}});
    mpm::Simulation<2> run(settings(2, 0.1), data, {neoHookean()}, {});
    std::vector<double> sigma(6*data.size(), 0);
    run.setField("sigma", sigma);
    sigma[6*3] = 1;
    CHECK_THROWS_WITH_AS
    (
        run.setField("sigma", sigma),
        "point 3: sigma is given, but that of material rubber (neoHookean) "
        "follows from its deformation",
        std::invalid_argument
    );

    mpm::StartSettings start;
    CHECK_THROWS_AS(run.establishStart(start), std::invalid_argument);
    start.type = "elasticGravity";
    start.elasticTime = 0.01;
    start.relaxationTime = 0.01;
    run.establishStart(start);

    data.sigma.assign(data.size(), {{0, 1, 0, 0, 0, 0}});
    CHECK_THROWS_AS
    (
        mpm::Simulation<2>(settings(2, 0.1), data, {neoHookean()}, {}),
        std::invalid_argument
    );
}

// ************************************************************************* //
