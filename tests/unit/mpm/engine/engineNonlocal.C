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
    The nonlocal plastic strain against its definition: soil on one side of a
    plane has yielded by one, for which the mean over Gaussian weights is a
    complementary error function; in the right length, whatever the cell, and
    with the weight of the strain itself.

\*---------------------------------------------------------------------------*/

#include "engineCases.H"
#include "mpmNonlocalStrain.H"
#include "mpmSort.H"

#include <doctest/doctest.h>

#include <cmath>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Side of the box [m] and place of the plane
const double side = 4, plane = 2;


mpm::Material nonlocalSoil()
{
    mpm::Material material(soil());
    material.softening.residualFrictionAngle = 20;
    material.softening.residualStrain = 10;
    material.softening.length = 1;
    return material;
}


//- Largest difference of the nonlocal strain from the exact one, in the middle
//  of the box
template<int Dim>
double worst(const double cellSize)
{
    const mpm::Settings s = settings(Dim, cellSize);
    const int cells = int(std::lround(side/cellSize));
    const mpm::PointData data = box(Dim, cellSize, {{cells, cells, cells}});
    const std::vector<mpm::Wall<Dim>> noWalls;
    mpm::State<Dim> state(s, {}, {}, noWalls, {nonlocalSoil()});
    state.cloud.assign(data, 0, data.size());
    state.laws.find(0, 30);
    const auto cycle = mpm::Cycle<Dim>::New(s);
    mpm::placePoints(state, *cycle);

    mpm::PointCloud<Dim>& points = state.cloud;
    points.keepSofteningStrain();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        points.plasticStrain[i] = points.x[i][0] < plane ? 1 : 0;
    }
    const auto strain = mpm::NonlocalStrain<Dim>::New(s, state.laws);
    strain->update(state, 0);

    // Nothing new has yielded
    strain->update(state, 0);

    // A slip in a thin layer, over this length, is the mean in the layer
    const double deviation = 1/std::sqrt(2*std::acos(-1.0));
    double error = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        bool middle = true;
        for (const double x : points.x[i])
        {
            middle = middle && std::fabs(x - 0.5*side) < 0.35*side;
        }
        if (middle)
        {
            const double mean = 0.5*std::erfc
            (
                (points.x[i][0] - plane)/(std::sqrt(2.0)*deviation)
            );
            error = std::max
            (
                error,
                std::fabs(points.softeningStrain[i] - mean)
            );
        }
    }
    return error;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("nonlocal plastic strain: a mean over a length of the soil, whatever "
    "the cell")
{
    const double coarse = worst<2>(0.25);
    const double fine = worst<2>(0.125);
    const double finest = worst<2>(0.0625);
    CAPTURE(coarse);
    CAPTURE(fine);
    CAPTURE(finest);

    // Second order: the weights are those of a binomial distribution
    CHECK(finest < 5e-3);
    CHECK(finest < 0.4*fine);
    CHECK(fine < 0.4*coarse);
    CHECK(worst<3>(0.25) < 1.2*coarse);
}


TEST_CASE("nonlocal softening: a length that the cells are too large for, and "
    "an unknown name, are refused")
{
    mpm::Material material(nonlocalSoil());
    CHECK_THROWS_WITH_AS
    (
        mpm::LawTable({material}, 1),
        "material sand: softening length = 1 is not allowed: >= 1.5 "
        "cellSize for a nonlocal regularisation [m]",
        std::invalid_argument
    );
    material.softening.regularisation = "none";
    CHECK_THROWS_AS(material.validate(), std::invalid_argument);
}

// ************************************************************************* //
