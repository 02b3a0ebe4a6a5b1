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
    Yielding bodies of revolution whose stress depends on the hoop strain, so
    heavy that their stress does not matter: every point flies on, and the
    strains are known at any time.

      - a cylinder that is pressed or drawn along its axis while its radii
        grow or shrink in proportion: the triaxial tests. Without dilation the
        mean stress follows the volume, and the rest is on the edge of the
        Mohr-Coulomb pyramid, where the cone of Drucker and Prager through that
        edge must be too
      - a ring whose points fly off with a/R, as around a cavity that expands
        without change of volume: with
        m = (sigma_t + sigma_r)/2, d = (sigma_t - sigma_r)/2 and those of the
        strain, ev = e_t + e_r, ed = (e_t - e_r)/2, Mohr-Coulomb's face between
        them has

            d = 2 mu ed - mu l
            m = m0 + (lambda + mu) (ev - l sin psi)
            l = (2 mu ed + m1 sin phi - c cos phi)
               /(mu + (lambda + mu) sin phi sin psi),
            m1 = m0 + (lambda + mu) ev

        and l = 0 where that is negative; sigma_z follows
        lambda (ev - l sin psi)

    Strains are logarithmic: e_t = ln(r/R), e_r = ln(dr/dR). FLIP keeps the
    velocities of points that fly.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Elasticity, strength and the isotropic stress of the start [Pa]
const double E = 10e6, nu = 0.3, cohesion = 10e3, m0 = -100e3;
const double mu = E/(2*(1 + nu)), lambda = E*nu/((1 + nu)*(1 - 2*nu));
const double bulk = lambda + 2*mu/3;

//- Stress along r, the axis and the hoop
typedef std::array<double, 3> Stresses;

//- Error of the stress over its exact size (root of the mean square), and the
//  largest displacement that the stress could have caused [m]
struct Outcome
{
    double error, moved;
};


//- Fly for a second from this field of velocities (r, y); compare in the
//  middle of the body with the exact stress at a point that was at R
Outcome fly
(
    const mpm::Material& soil,
    const double phi,
    const double inside,
    const double cellSize,
    const std::function<mpm::Point3(const mpm::Point3&)>& velocity,
    const std::function<Stresses(double)>& exact
)
{
    const double rho = 1e15, height = 0.5, outside = 1;

    mpm::Settings settings;
    settings.cellSize = cellSize;
    settings.symmetry = "axisymmetric";
    settings.maxDeltaT = 0.16*cellSize;
    settings.transferScheme = "FLIP";
    settings.flipTime = 1e9;

    mpm::PointData points = verification::seed
    (
        2,
        cellSize,
        2,
        {{inside, 0, 0}},
        {{outside, height, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );
    points.cohesionIntercept.assign(points.size(), cohesion);
    points.frictionAngle.assign(points.size(), phi);
    points.sigma.assign(points.size(), {{m0, m0, m0, 0, 0, 0}});
    for (const mpm::Point3& x : points.position)
    {
        points.velocity.push_back(velocity(x));
    }

    auto run = mpm::Run::New(2, settings, points, {soil}, {});
    run->advance(1);

    const std::vector<double> sigma = run->field("sigma");
    double square = 0, size = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        // Away from the rims, where the gradient is not second order
        const mpm::Point3& x = points.position[i];
        const double rim = 0.15;
        if
        (
            std::fabs(x[1] - 0.5*height) < 0.5*height - rim
         && std::fabs(x[0] - 0.5*(inside + outside))
          < 0.5*(outside - inside) - rim
        )
        {
            const Stresses s = exact(x[0]);
            for (int c = 0; c < 3; ++c)
            {
                square += std::pow(sigma[6*i + c] - s[c], 2);
                size += s[c]*s[c];
            }
        }
    }
    return {std::sqrt(square/size), -m0/(rho*cellSize)};
}


mpm::Material material(const std::string& model, const double dilationAngle)
{
    mpm::Material soil;
    soil.constitutiveModel = model;
    soil.E = E;
    soil.nu = nu;
    soil.dilationAngle = dilationAngle;
    return soil;
}


//- Radial rate a, axial rate b [1/s]
Outcome triaxial
(
    const std::string& model,
    const std::string& fit,
    const double a,
    const double b,
    const double cellSize
)
{
    const double phi = 30;
    mpm::Material soil = material(model, 0);
    soil.druckerPragerFit = fit;

    const double sine = std::sin(phi*verification::degree);
    const double cosine = std::cos(phi*verification::degree);
    const double p = m0 + bulk*(2*std::log1p(a) + std::log1p(b));
    const double strength = 6*(cohesion*cosine - p*sine);
    const bool pressed = b < 0;
    const double q = strength/(pressed ? 3 - sine : 3 + sine);
    const double side = pressed ? q/3 : -q/3;
    return fly
    (
        soil,
        phi,
        0,
        cellSize,
        [=](const mpm::Point3& x) { return mpm::Point3{{a*x[0], b*x[1], 0}}; },
        [=](double) { return Stresses{{p + side, p - 2*side, p + side}}; }
    );
}


Outcome cavity
(
    const double phi,
    const double dilationAngle,
    const double cellSize
)
{
    const double a = 0.01;
    const double sinPhi = std::sin(phi*verification::degree);
    const double cosPhi = std::cos(phi*verification::degree);
    const double sinPsi = std::sin(dilationAngle*verification::degree);
    return fly
    (
        material("MohrCoulomb", dilationAngle),
        phi,
        0.4,
        cellSize,
        [=](const mpm::Point3& x) { return mpm::Point3{{a/x[0], 0, 0}}; },
        [=](const double R)
        {
            const double hoop = std::log1p(a/(R*R));
            const double radial = std::log1p(-a/(R*R));
            const double ev = hoop + radial, ed = 0.5*(hoop - radial);
            const double excess =
                2*mu*ed + (m0 + (lambda + mu)*ev)*sinPhi - cohesion*cosPhi;
            const double l = std::fmax
            (
                0, excess/(mu + (lambda + mu)*sinPhi*sinPsi)
            );
            const double d = 2*mu*ed - mu*l;
            const double m = m0 + (lambda + mu)*(ev - l*sinPsi);
            return Stresses{{m - d, m0 + lambda*(ev - l*sinPsi), m + d}};
        }
    );
}


void check
(
    verification::Checks& checks,
    const std::string& name,
    const std::function<Outcome(double)>& run
)
{
    const Outcome coarse = run(1.0/16), fine = run(1.0/32);
    checks.less
    (
        name + ": error of the stress over its size, 32 cells",
        fine.error,
        4e-3,
        "second order; without the hoop strain it is above 0.5"
    );
    checks.within
    (
        name + ": observed order",
        verification::order(coarse.error, fine.error),
        1.6,
        3,
        "second order in cell and step"
    );
    checks.less
    (
        name + ": what the stress itself may have moved [m]",
        fine.moved,
        1e-8,
        "the flight is free"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::hoopStrain(Checks& checks, const bool)
{
    for (const bool pressed : {true, false})
    {
        const double b = pressed ? -0.03 : 0.03;
        const double a = pressed ? 0.012 : -0.012;
        const std::string test =
            pressed ? "triaxial compression, " : "triaxial extension, ";
        check
        (
            checks,
            test + "Mohr-Coulomb",
            [=](const double h)
            {
                return triaxial("MohrCoulomb", "planeStrain", a, b, h);
            }
        );
        check
        (
            checks,
            test + "Drucker-Prager",
            [=](const double h)
            {
                return triaxial
                (
                    "DruckerPrager", pressed ? "outer" : "middle", a, b, h
                );
            }
        );
    }
    check
    (
        checks,
        "cavity, Tresca",
        [](const double h) { return cavity(0, 0, h); }
    );
    check
    (
        checks,
        "cavity, phi 30, psi 0",
        [](const double h) { return cavity(30, 0, h); }
    );
    check
    (
        checks,
        "cavity, phi 30, psi 15",
        [](const double h) { return cavity(30, 15, h); }
    );
}

// ************************************************************************* //
