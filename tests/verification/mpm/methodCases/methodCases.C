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

#include "methodCases.H"
#include "manufacturedSolutions.H"

#include <cmath>
#include <ctime>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using methodCases::Method;
using methodCases::Outcome;
using namespace manufactured;


mpm::Settings settings(const Method& method, const double cellSize)
{
    mpm::Settings s;
    s.cellSize = cellSize;
    s.shapeFunction = method.shape;
    s.transferScheme = method.transfer;
    s.stressUpdate = method.update;
    s.flipBlend = 1;
    return s;
}


double cpuTime()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}


//- Follow a manufactured solution to its end
template<class Solution>
Outcome follow
(
    const Solution& solution,
    mpm::PointData points,
    mpm::Settings s,
    const std::vector<mpm::WallSettings>& walls,
    const double cfl
)
{
    const std::size_t n = points.size();
    std::vector<Vector2d> X(n);
    double speed = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        X[i] = Vector2d(points.position[i][0], points.position[i][1]);
        speed = std::fmax(speed, solution.velocity(X[i], 0).norm());
    }

    // Steps of one length; the limit of the run is out of the way
    const double wave = std::sqrt((lambda + 2*mu)/rho);
    const double end = solution.endTime();
    const int steps = int(std::ceil(end*(wave + speed)/(cfl*s.cellSize)));
    const double dt = end/steps;
    s.cfl = 1;

    // Velocities live half a step before positions
    for (std::size_t i = 0; i < n; ++i)
    {
        const Vector2d v = solution.velocity(X[i], -0.5*dt);
        points.velocity.push_back({{v[0], v[1], 0}});
    }

    Outcome result;
    const double start = cpuTime();
    try
    {
        auto run = mpm::Run::New(2, s, points, {solid()}, walls);
        for (int k = 0; k < steps; ++k)
        {
            std::vector<double> v = run->field("velocity");
            for (std::size_t i = 0; i < n; ++i)
            {
                const Vector2d b = solution.bodyForce(X[i], k*dt);
                v[3*i] += dt*b[0];
                v[3*i + 1] += dt*b[1];
            }
            run->setField("velocity", v);
            for (double left = dt; left > 1e-9*dt;)
            {
                left -= run->step(left);
            }
        }

        const std::vector<double> u = run->field("displacement");
        double square = 0;
        for (std::size_t i = 0; i < n; ++i)
        {
            square +=
                (
                    Vector2d(u[3*i], u[3*i + 1])
                  - solution.displacement(X[i], end)
                ).squaredNorm();
        }
        result.error =
            std::fmin(1, std::sqrt(square/double(n))/solution.amplitude());
        result.failed = result.error >= 1;
    }
    catch (const std::runtime_error&)
    {}
    result.cpu = cpuTime() - start;
    return result;
}


} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

methodCases::Outcome methodCases::bar
(
    const Method& method,
    const int cells,
    const double cfl,
    const double offset,
    const double periods
)
{
    const double length = 25, stiffness = 100, density = 1, v0 = 0.1, U = 1;
    const double c = std::sqrt(stiffness/density);
    const double k = pi/length, omega = k*c;

    mpm::Settings s = settings(method, length/cells);
    s.cfl = cfl;
    s.origin = {{-offset*s.cellSize, -offset*s.cellSize, 0}};

    mpm::PointData points = verification::seed
    (
        2,
        s.cellSize,
        2,
        {{0, 0, 0}},
        {{length, s.cellSize, 0}},
        [](const mpm::Point3&) { return true; },
        density
    );
    for (const mpm::Point3& x : points.position)
    {
        points.velocity.push_back({{U + v0*std::cos(k*x[0]), 0, 0}});
    }
    mpm::Material material;
    material.constitutiveModel = "linearElastic";
    material.E = stiffness;

    // In the frame that flies with the bar
    const auto energy = [U](const mpm::Diagnostics& d)
    {
        return
            d.kineticEnergy + d.affineKineticEnergy + d.elasticEnergy
          - U*d.momentum[0] + 0.5*d.mass*U*U;
    };

    Outcome result;
    const double start = cpuTime();
    try
    {
        auto run = mpm::Run::New(2, s, points, {material}, {});
        const double before = energy(run->diagnostics());
        const double end = periods*2*pi/omega;
        double largest = before;
        while (run->time() < end && largest < 2*before)
        {
            run->step(end - run->time());
            if (run->stepNumber() % 50 == 0)
            {
                largest = std::fmax(largest, energy(run->diagnostics()));
            }
        }
        const double after = energy(run->diagnostics());
        result.energyDrift = after/before - 1;

        const std::vector<double> u = run->field("displacement");
        const double t = run->time();
        double square = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double exact =
                U*t + v0/omega*std::cos(k*points.position[i][0])
               *std::sin(omega*t);
            square += std::pow(u[3*i] - exact, 2);
        }
        result.error = std::fmin
        (
            1, std::sqrt(square/double(points.size()))*omega/v0
        );
        result.failed = !(largest < 2*before && after < 2*before);
    }
    catch (const std::runtime_error&)
    {}
    result.cpu = cpuTime() - start;
    return result;
}


methodCases::Outcome methodCases::axisAligned
(
    const Method& method,
    const int cells,
    const double cfl
)
{
    using verification::plane;

    const mpm::Settings s = settings(method, 1.0/cells);
    const mpm::PointData points = verification::seed
    (
        2,
        s.cellSize,
        2,
        {{0, 0, 0}},
        {{1, 1, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    return follow
    (
        AxisAligned(),
        points,
        s,
        {
            plane("left", "roller", {{0, 0, 0}}, {{1, 0, 0}}),
            plane("right", "roller", {{1, 0, 0}}, {{-1, 0, 0}}),
            plane("bottom", "roller", {{0, 0, 0}}, {{0, 1, 0}}),
            plane("top", "roller", {{0, 1, 0}}, {{0, -1, 0}})
        },
        cfl
    );
}


methodCases::Outcome methodCases::vortex
(
    const Method& method,
    const int cells,
    const double cfl
)
{
    const mpm::Settings s = settings(method, 1.0/cells);

    // Rings of points, each with the area that it stands for
    const double spacing = 0.5*s.cellSize;
    const int rings =
        int(std::lround((Vortex::outer - Vortex::inner)/spacing));
    const double dR = (Vortex::outer - Vortex::inner)/rings;
    mpm::PointData points;
    for (int r = 0; r < rings; ++r)
    {
        const double R = Vortex::inner + (r + 0.5)*dR;
        const int n = int(std::lround(2*pi*R/spacing));
        for (int i = 0; i < n; ++i)
        {
            const double a = 2*pi*(i + 0.5*(r % 2))/n;
            points.position.push_back({{R*std::cos(a), R*std::sin(a), 0}});
            points.volume.push_back(2*pi*R*dR/n);
            points.rho.push_back(rho);
            points.zone.push_back(0);
        }
    }
    return follow(Vortex(), points, s, {}, cfl);
}


methodCases::Outcome methodCases::column
(
    const Method& method,
    const int cells,
    const double cfl
)
{
    using verification::plane;

    // Half of the stiffness at the base: a logarithmic strain of -0.5
    const double height = 50, density = 80, stiffness = 10e3;
    const double g = 0.5*stiffness/(density*height);

    mpm::Settings s = settings(method, height/cells);
    s.gravity = {{0, -g, 0}};
    s.cfl = cfl;
    const double width = s.cellSize;
    const mpm::PointData points = verification::seed
    (
        2,
        s.cellSize,
        2,
        {{0, 0, 0}},
        {{width, height, 0}},
        [](const mpm::Point3&) { return true; },
        density
    );
    mpm::Material soft;
    soft.constitutiveModel = "linearElastic";
    soft.E = stiffness;

    Outcome result;
    const double start = cpuTime();
    try
    {
        auto run = mpm::Run::New
        (
            2,
            s,
            points,
            {soft},
            {
                plane("base", "rough", {{0, 0, 0}}, {{0, 1, 0}}),
                plane("left", "roller", {{0, 0, 0}}, {{1, 0, 0}}),
                plane("right", "roller", {{width, 0, 0}}, {{-1, 0, 0}})
            }
        );

        // Natural period 18 s; kinetic relaxation needs some of them
        mpm::StartSettings rest;
        rest.type = "elasticGravity";
        rest.elasticTime = 100;
        rest.relaxationTime = 0;
        run->establishStart(rest);

        const std::vector<double> sigma = run->field("sigma");
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double Y = points.position[i][1];
            sum += std::fabs
            (
                sigma[6*i + 1]/(density*g*height) + 1 - Y/height
            );
        }
        result.error = std::fmin(1, sum/double(points.size()));
        result.failed = result.error >= 1;
    }
    catch (const std::runtime_error&)
    {}
    result.cpu = cpuTime() - start;
    return result;
}


double methodCases::collapseRunout
(
    const Method& method,
    const int cells,
    double& cpu
)
{
    using verification::plane;

    mpm::Settings s = settings(method, 1.0/cells);
    s.gravity = {{0, -verification::gravity, 0}};
    // The blend of a slide, not that of a vibration
    s.flipBlend = -1;

    mpm::PointData points = verification::seed
    (
        2,
        s.cellSize,
        2,
        {{0, 0, 0}},
        {{1, 1, 0}},
        [](const mpm::Point3&) { return true; },
        1600
    );
    points.frictionAngle.assign(points.size(), 30);
    mpm::Material sand;
    sand.E = 1e6;
    sand.nu = 0.3;

    const double start = cpuTime();
    double sum = 0;
    try
    {
        auto run = mpm::Run::New
        (
            2,
            s,
            points,
            {sand},
            {
                plane("middle", "roller", {{0, 0, 0}}, {{1, 0, 0}}),
                plane("floor", "rough", {{0, 0, 0}}, {{0, 1, 0}})
            }
        );
        run->advance(1.2);

        const std::vector<double> u = run->field("displacement");
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            sum += u[3*i];
        }
    }
    catch (const std::runtime_error&)
    {}
    cpu = cpuTime() - start;
    return sum/double(points.size());
}


methodCases::Outcome methodCases::cylinder
(
    const Method& method,
    const int cells,
    const double cfl
)
{
    using verification::plane;

    const double radius = 1, amplitude = 1e-3;
    const double wave = std::sqrt((lambda + 2*mu)/rho);

    // The lowest root by bisection: J1 less the other side grows from below
    double low = 1, high = 3;
    for (int i = 0; i < 60; ++i)
    {
        const double x = 0.5*(low + high);
        const double excess =
            ::j1(x)
          - (1 - nu)/(1 - 2*nu)*x*::j0(x);
        (excess < 0 ? low : high) = x;
    }
    const double k = low/radius, omega = k*wave;

    mpm::Settings s = settings(method, radius/cells);
    s.symmetry = "axisymmetric";
    s.cfl = cfl;
    mpm::PointData points = verification::seed
    (
        2,
        s.cellSize,
        2,
        {{0, 0, 0}},
        {{radius, s.cellSize, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    for (const mpm::Point3& x : points.position)
    {
        points.velocity.push_back
        (
            {{amplitude*omega*::j1(k*x[0]), 0, 0}}
        );
    }
    mpm::Material material = solid();
    material.constitutiveModel = "linearElastic";

    Outcome result;
    const double start = cpuTime();
    try
    {
        auto run = mpm::Run::New
        (
            2,
            s,
            points,
            {material},
            {
                plane("bottom", "roller", {{0, 0, 0}}, {{0, 1, 0}}),
                plane("top", "roller", {{0, s.cellSize, 0}}, {{0, -1, 0}})
            }
        );
        run->advance(0.5*pi/omega);

        // Of the area
        const std::vector<double> u = run->field("displacement");
        double square = 0, exact2 = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double r = points.position[i][0];
            const double exact = amplitude*::j1(k*r);
            square += r*std::pow(u[3*i] - exact, 2);
            exact2 += r*exact*exact;
        }
        result.error = std::fmin(1, std::sqrt(square/exact2));
        result.failed = result.error >= 1;
    }
    catch (const std::runtime_error&)
    {}
    result.cpu = cpuTime() - start;
    return result;
}


double methodCases::residualAxisAligned()
{
    return largestResidual(AxisAligned(), 0.1);
}


double methodCases::residualVortex()
{
    return largestResidual(Vortex(), Vortex::inner);
}

// ************************************************************************* //
