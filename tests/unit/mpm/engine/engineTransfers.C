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
#include "mpmSort.H"

#include <doctest/doctest.h>

using namespace engineCases;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct Names
{
    std::string shape;
    std::string transfer;
    std::string stress;
};

//- Every pair
std::vector<Names> allNames()
{
    std::vector<Names> names;
    for (const std::string& shape : mpm::Settings::shapeFunctions())
    {
        for (const std::string& transfer : mpm::Settings::transferSchemes())
        {
            for (const std::string& stress : mpm::Settings::stressUpdates())
            {
                names.push_back({shape, transfer, stress});
            }
        }
    }
    return names;
}


mpm::Settings named(const int dimension, const Names& names)
{
    mpm::Settings s = settings(dimension, 0.25, 0);
    s.shapeFunction = names.shape;
    s.transferScheme = names.transfer;
    s.stressUpdate = names.stress;

    // What a node lighter than the cut-off gets is lost
    s.massCutOff = 0;
    s.origin = {{0.03, -0.07, dimension == 3 ? 0.011 : 0}};
    return s;
}


//- Sum of |m v|, the size that momentum is compared with
double size(const mpm::PointData& data)
{
    double sum = 0;
    for (std::size_t i = 0; i < data.size(); ++i)
    {
        for (const double v : data.velocity[i])
        {
            sum += data.rho[i]*data.volume[i]*std::fabs(v);
        }
    }
    return sum;
}


template<int Dim>
void checkConservation(const Names& names)
{
    CAPTURE(Dim);
    CAPTURE(names.shape);
    CAPTURE(names.transfer);
    CAPTURE(names.stress);

    const mpm::PointData data = cloud(Dim, 300);
    mpm::Simulation<Dim> run(named(Dim, names), data, {elastic()}, {});
    const mpm::Diagnostics before = run.diagnostics();

    // USL with linear shapes turns points of such a wild cloud inside out
    // within a few steps: its gradient has no bound at nearly empty nodes.
    // Where the points carry it, so do the others
    const bool carries =
        names.transfer == "APIC"
     || names.transfer == "TPIC"
     || names.transfer == "AFLIP";
    const int nSteps =
        names.shape != "linear" ? 5
      : names.stress == "USL" ? 1
      : carries ? 2
      : 5;
    for (int i = 0; i < nSteps; ++i)
    {
        run.step(1);
    }
    const mpm::Diagnostics after = run.diagnostics();

    // Round-off of sums over some 3000 nodes and 300 points in each step, and
    // of divisions by the mass of nearly empty nodes, relative to the sum of
    // the magnitudes
    const double bound = 1e-13*size(data)*nSteps;

    // Points do not change their mass; the sums of the blocks, between which
    // they move, are each rounded once
    CHECK(after.mass == doctest::Approx(before.mass).epsilon(1e-14));
    for (int d = 0; d < 3; ++d)
    {
        CHECK(std::fabs(after.momentum[d] - before.momentum[d]) <= bound);

        // The cloud is within two metres of the origin. The angular momentum
        // of the affine part is known where its second moment is
        if
        (
            names.transfer == "APIC"
         && names.shape.find("BSpline") != std::string::npos
        )
        {
            CHECK
            (
                std::fabs(after.angularMomentum[d] - before.angularMomentum[d])
             <= 2*bound
            );
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("transfers keep mass, momentum and, with APIC, angular momentum")
{
    for (const Names& names : allNames())
    {
        checkConservation<2>(names);
        checkConservation<3>(names);
    }
}


TEST_CASE_TEMPLATE
(
    "APIC: an affine velocity field survives the way to the grid and back",
    Number,
    std::integral_constant<int, 2>,
    std::integral_constant<int, 3>
)
{
    constexpr int Dim = Number::value;
    mpm::PointData data = cloud(Dim, 200);
    data.sigma.clear();
    const double A[3][3] = {{.1, .7, -.3}, {-.4, .2, .5}, {.6, -.8, -.3}};
    const double b[3] = {0.4, -0.2, 0.1};

    for (const bool generic : {false, true})
    {
        const mpm::Settings names = named(Dim, {"quadraticBSpline", "APIC", "USL"});
        const std::vector<mpm::Wall<Dim>> noWalls;
        mpm::State<Dim> state
        (
            names, {}, {{0.03, -0.07}}, noWalls, {elastic()}
        );
        state.cloud.assign(data, 0, data.size());
        state.laws.find(0, 0);
        const std::unique_ptr<mpm::Cycle<Dim>> cycle =
            generic
          ? mpm::Cycle<Dim>::NewGeneric(names)
          : mpm::Cycle<Dim>::New(names);
        mpm::placePoints(state, *cycle);

        mpm::PointCloud<Dim>& points = state.cloud;
        const auto velocity = [&](const auto& x, const int r)
        {
            double v = b[r];
            for (int c = 0; c < Dim; ++c)
            {
                v += A[r][c]*x[c];
            }
            return v;
        };
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            for (int r = 0; r < Dim; ++r)
            {
                points.v[i][r] = velocity(points.x[i], r);
                for (int c = 0; c < Dim; ++c)
                {
                    points.C[i][c*Dim + r] = A[r][c];
                }
            }
        }

        // So short that no stress and no motion comes of it
        const auto x = points.x;
        cycle->step(state, 1e-12);
        double worst = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            for (int r = 0; r < Dim; ++r)
            {
                const double v = velocity(x[i], r);
                worst = std::max(worst, std::fabs(points.v[i][r] - v));
                for (int c = 0; c < Dim; ++c)
                {
                    const double difference =
                        points.C[i][c*Dim + r] - A[r][c];
                    worst = std::max(worst, std::fabs(difference));
                }
            }
        }

        // Nearly empty nodes lose digits, which their light weights hide
        CHECK(worst <= 1e-11);
    }
}


TEST_CASE("the generic kernels repeat those made for a combination")
{
    const auto compare = [](auto special, auto generic)
    {
        generic->useGenericKernels();
        for (int i = 0; i < 60; ++i)
        {
            special->step(1e-3);
            generic->step(1e-3);
        }
        for (const char* name : {"position", "sigma", "velocity"})
        {
            const std::vector<double> a = special->field(name);
            const std::vector<double> b = generic->field(name);
            double difference = 0, largest = 0;
            for (std::size_t i = 0; i < a.size(); ++i)
            {
                difference = std::max(difference, std::fabs(a[i] - b[i]));
                largest = std::max(largest, std::fabs(a[i]));
            }
            CAPTURE(name);
            // Round-off of another order of summation, over 60 steps of a
            // flow that does not amplify it
            CHECK(difference <= 1e-10*largest);
        }
    };

    compare(column<2>(settings(2, 0.1), 6), column<2>(settings(2, 0.1), 6));
    compare(column<3>(settings(3, 0.1), 4), column<3>(settings(3, 0.1), 4));

    const auto linear = [](const int dimension)
    {
        mpm::Settings s = settings(dimension, 0.1);
        s.shapeFunction = "linear";
        s.transferScheme = "FLIP";
        s.stressUpdate = "USF";
        return s;
    };
    compare(column<2>(linear(2), 6), column<2>(linear(2), 6));
    compare(column<3>(linear(3), 4), column<3>(linear(3), 4));

    for (const char* antiLocking : {"node", "cell"})
    {
        CAPTURE(antiLocking);
        mpm::Settings s = settings(2, 0.1);
        s.antiLocking = antiLocking;
        compare(column<2>(s, 6, 15), column<2>(s, 6, 15));
        s = settings(3, 0.1);
        s.antiLocking = antiLocking;
        compare(column<3>(s, 4, 15), column<3>(s, 4, 15));
    }
}


TEST_CASE("FLIP share: 1 keeps velocities that PIC smooths")
{
    mpm::PointData data = cloud(2, 300);
    data.sigma.clear();
    double energy[2];
    for (const int share : {0, 1})
    {
        mpm::Settings s = named(2, {"linear", "FLIP", "USF"});
        s.flipBlend = share;
        mpm::Simulation<2> run(s, data, {elastic()}, {});
        const double before = run.diagnostics().kineticEnergy;
        run.step(1e-12);
        energy[share] = run.diagnostics().kineticEnergy/before;
    }

    // Without forces FLIP changes nothing but by round-off
    CHECK(std::fabs(energy[1] - 1) <= 1e-12);
    CHECK(energy[0] < 0.9);
}


TEST_CASE("gravity alone is free fall")
{
    mpm::Settings s = settings(2, 0.25);
    mpm::Simulation<2> run(s, box(2, 0.25, {{4, 4, 0}}), {soil()}, {});
    run.advance(0.5);
    const std::vector<double> v = run.field("velocity");
    for (std::size_t i = 0; i < run.nPoints(); ++i)
    {
        // Symplectic Euler keeps v = g t exactly; 500 additions' round-off
        CHECK(std::fabs(v[3*i + 1] + 9.81*0.5) <= 1e-11);
        CHECK(std::fabs(v[3*i]) <= 1e-11);
    }
}


// ************************************************************************* //
