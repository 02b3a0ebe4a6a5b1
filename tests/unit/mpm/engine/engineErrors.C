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

//- What a run made of these says, or nothing
std::string complaint
(
    const mpm::Settings& s,
    const mpm::PointData& data,
    const mpm::Material& material = soil(),
    const std::vector<mpm::WallSettings>& walls = {},
    const int dimension = 2
)
{
    try
    {
        mpm::Run::New(dimension, s, data, {material}, walls);
    }
    catch (const std::invalid_argument& e)
    {
        return e.what();
    }
    return "";
}


void checkSays
(
    const std::string& message,
    const std::vector<std::string>& parts
)
{
    CAPTURE(message);
    for (const std::string& part : parts)
    {
        CAPTURE(part);
        CHECK(message.find(part) != std::string::npos);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("unknown names are answered by the valid ones")
{
    const mpm::PointData data = box(2, 0.1, {{1, 1, 0}});
    mpm::Settings s = settings(2, 0.1);

    s.shapeFunction = "cubic";
    checkSays
    (
        complaint(s, data),
        {
            "cubic", "quadraticBSpline", "cubicBSpline", "linear", "uGIMP",
            "cpGIMP"
        }
    );

    s = settings(2, 0.1);
    s.transferScheme = "PICARD";
    checkSays
    (
        complaint(s, data),
        {"PICARD", "APIC", "TPIC", "AFLIP", "FLIP", "XPIC", "PIC"}
    );

    s = settings(2, 0.1);
    s.stressUpdate = "last";
    checkSays(complaint(s, data), {"last", "USL", "MUSL", "USF"});

    s = settings(2, 0.1);
    mpm::Material material = soil();
    material.constitutiveModel = "CamClay";
    checkSays
    (
        complaint(s, data, material),
        {"sand", "CamClay", "MohrCoulomb", "linearElastic"}
    );

    mpm::WallSettings wall;
    wall.name = "bottom";
    wall.condition = "sticky";
    checkSays
    (
        complaint(s, data, soil(), {wall}),
        {"bottom", "sticky", "rough", "roller", "slip", "coulomb"}
    );

    auto run = mpm::Run::New(2, s, data, {soil()}, {});
    CHECK_THROWS_WITH_AS
    (
        run->field("pressure"),
        doctest::Contains("equivalentPlasticStrain"),
        std::invalid_argument
    );
    CHECK_THROWS_WITH_AS
    (
        run->setField("mass", std::vector<double>(4, 1)),
        doctest::Contains("cohesionIntercept"),
        std::invalid_argument
    );

    mpm::StartSettings start;
    start.type = "hydrostatic";
    CHECK_THROWS_WITH_AS
    (
        run->establishStart(start),
        doctest::Contains("columnK0"),
        std::invalid_argument
    );
}


TEST_CASE("numbers out of range are named with their range")
{
    const mpm::PointData data = box(2, 0.1, {{1, 1, 0}});

    mpm::Settings s = settings(2, 0.1);
    s.cellSize = 0;
    checkSays(complaint(s, data), {"cellSize", "0", "> 0"});

    s = settings(2, 0.1);
    s.cfl = 1.5;
    checkSays(complaint(s, data), {"cfl", "1.5", "<= 1"});

    s = settings(2, 0.1);
    s.gravity[2] = -9.81;
    checkSays(complaint(s, data), {"gravity[2]", "-9.81"});

    s = settings(2, 0.1);
    s.xpicOrder = 0;
    checkSays(complaint(s, data), {"xpicOrder", "0", "20"});

    s = settings(2, 0.1);
    checkSays
    (
        complaint(s, data, soil(), {}, 4),
        {"dimension", "4", "2 (plane strain) or 3"}
    );

    mpm::Material material = soil();
    material.nu = 0.5;
    checkSays(complaint(s, data, material), {"sand", "nu", "0.5", "< 0.5"});

    material = soil();
    material.dilationAngle = 31;
    checkSays
    (
        complaint(s, data, material),
        {"sand", "dilationAngle", "31", "frictionAngle", "30"}
    );

    mpm::WallSettings wall;
    wall.name = "bottom";
    wall.normal = {{0, 0, 0}};
    checkSays(complaint(s, data, soil(), {wall}), {"bottom", "normal"});

    wall = mpm::WallSettings();
    wall.name = "ground";
    wall.type = "terrain";
    wall.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0.5, 1, 0}}};
    checkSays
    (
        complaint(s, data, soil(), {wall}),
        {"ground", "turns back", "0.5 1"}
    );
}


TEST_CASE("bad points are named")
{
    const mpm::Settings s = settings(2, 0.1);
    const mpm::PointData good = box(2, 0.1, {{1, 1, 0}});

    mpm::PointData data(good);
    data.rho[2] = -1;
    checkSays(complaint(s, data), {"point 2", "rho", "-1", "> 0"});

    data = good;
    data.frictionAngle[3] = 90;
    checkSays(complaint(s, data), {"point 3", "frictionAngle", "90", "< 90"});

    data = good;
    data.zone[1] = 7;
    checkSays(complaint(s, data), {"point 1", "zone", "7", "0 .. 0"});

    data = good;
    data.cohesionIntercept.pop_back();
    checkSays
    (
        complaint(s, data), {"cohesionIntercept", "3 values", "4 points"}
    );

    data = good;
    data.position[0][0] = 1e12;
    checkSays(complaint(s, data), {"point 0", "farther", "blocks"});

    checkSays(complaint(s, mpm::PointData()), {"number of points", ">= 1"});
}


TEST_CASE("what is no saved run is refused")
{
    auto run = column<2>(settings(2, 0.1), 2);

    std::stringstream nonsense("This is not a saved run of any kind at all");
    CHECK_THROWS_AS(run->restore(nonsense), std::runtime_error);

    std::stringstream saved;
    run->save(saved);
    auto other = column<2>(settings(2, 0.2), 2);
    CHECK_THROWS_WITH_AS
    (
        other->restore(saved),
        doctest::Contains("0.1"),
        std::runtime_error
    );

    const std::string whole = saved.str();
    std::stringstream half(whole.substr(0, whole.size()/2));
    CHECK_THROWS_WITH_AS
    (
        run->restore(half),
        doctest::Contains("ends too early"),
        std::runtime_error
    );
}


// ************************************************************************* //
