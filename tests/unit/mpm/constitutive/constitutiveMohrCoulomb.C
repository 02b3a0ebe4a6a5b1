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
    Mohr-Coulomb element tests with closed forms: soil samples driven by a
    strain, beyond yield. Tension positive; stresses in Pa.

    Tolerance 1e-10 of the stress: closed forms, a few hundred operations.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"

#include <doctest/doctest.h>

using namespace mpm;
using namespace constitutiveTools;

static const double tolerance = 1e-10;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double E = 50e6;
const double nu = 0.3;
const double degree = std::acos(-1.0)/180;

//- Drive a stress by n equal strain increments
template<int Dim>
PlasticIncrement<double> drive
(
    SymmetricTensor<Dim, double>& s,
    const SymmetricTensor<Dim, double>& strain,
    const int n,
    const MohrCoulomb<double>& soil,
    const double cohesion
)
{
    SymmetricTensor<Dim, double> part(strain);
    part.combine(strain, [n](double& a, const double b) { a = b/n; });

    PlasticIncrement<double> sum{0, yieldRegion::elastic};
    for (int i = 0; i < n; ++i)
    {
        addElasticStress(s, part, soil.moduli);
        const PlasticIncrement<double> increment =
            soil.returnStress(s, cohesion);
        sum.equivalentStrain += increment.equivalentStrain;
        sum.region = increment.region;
    }
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Element: confined compression yields on the edge of triaxial "
    "compression, psi 0")
{
    // s_r (1 + sin phi) - s_a (1 - sin phi) = 2 c cos phi, and with psi = 0
    // the mean stress stays elastic: s_a + 2 s_r = 3 K e
    const double c = 10e3, phi = 35, axial = -0.02;
    const MohrCoulomb<double> soil = mohrCoulomb(E, 0.2, phi, 0);
    const double sine = std::sin(degree*phi), cosine = std::cos(degree*phi);
    const double threeMean = 3*soil.moduli.bulk()*axial;
    const double axialStress =
        (threeMean*(1 + sine) - 4*c*cosine)/(3 - sine);
    const double radialStress = 0.5*(threeMean - axialStress);

    SpaceStress s{0, 0, 0, 0, 0, 0};
    const auto done =
        drive(s, SpaceStress{0, 0, axial, 0, 0, 0}, 37, soil, c);
    CHECK(s.zz == doctest::Approx(axialStress).epsilon(tolerance));
    CHECK(s.xx == doctest::Approx(radialStress).epsilon(tolerance));
    CHECK(s.yy == doctest::Approx(radialStress).epsilon(tolerance));
    CHECK(done.region == yieldRegion::compressionEdge);

    // Axial strain less the elastic part of its deviator, times 2/3
    const double equivalent =
        2.0/3.0*std::fabs
        (
            axial - (axialStress - radialStress)/(2*soil.moduli.mu)
        );
    CHECK(done.equivalentStrain == doctest::Approx(equivalent).epsilon(1e-9));

    // The section sees the same when its y axis is the loaded one: zz = xx
    PlaneStress p{0, 0, 0, 0};
    drive(p, PlaneStress{0, axial, 0, 0}, 11, soil, c);
    CHECK(p.yy == doctest::Approx(axialStress).epsilon(tolerance));
    CHECK(p.xx == doctest::Approx(radialStress).epsilon(tolerance));
    CHECK(p.zz == doctest::Approx(radialStress).epsilon(tolerance));
}


TEST_CASE("Element: extension after isotropic compression yields on the "
    "edge of triaxial extension")
{
    // s_a (1 + sin phi) - s_r (1 - sin phi) = 2 c cos phi with the mean
    // stress of the elastic body
    const double c = 5e3, phi = 25, p0 = -200e3, axial = 0.004;
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, phi, 0);
    const double sine = std::sin(degree*phi), cosine = std::cos(degree*phi);
    const double threeMean = 3*p0;
    const double axialStress =
        (4*c*cosine + threeMean*(1 - sine))/(3 + sine);

    SpaceStress s{p0, p0, p0, 0, 0, 0};
    const auto done = drive
    (
        s,
        SpaceStress{-0.5*axial, axial, -0.5*axial, 0, 0, 0},
        20,
        soil,
        c
    );
    CHECK(s.yy == doctest::Approx(axialStress).epsilon(tolerance));
    CHECK
    (
        s.xx
     == doctest::Approx(0.5*(threeMean - axialStress)).epsilon(tolerance)
    );
    CHECK(done.region == yieldRegion::extensionEdge);
}


TEST_CASE("Element: shearing in plane strain runs along the plane, psi 0")
{
    // Mohr's circle about the constant mean: radius c cos phi - mean sin phi
    const double c = 10e3, phi = 30, p0 = -100e3, shear = 5e-3;
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, phi, 0);
    const double radius =
        c*std::cos(degree*phi) - p0*std::sin(degree*phi);

    // Direction of the circle (difference, shear) by strain
    PlaneStress s{p0, p0, p0, 0};
    const auto done = drive
    (
        s,
        PlaneStress{0.6*shear, -0.6*shear, 0, 0.8*shear},
        25,
        soil,
        c
    );
    CHECK(s.xx == doctest::Approx(p0 + 0.6*radius).epsilon(tolerance));
    CHECK(s.yy == doctest::Approx(p0 - 0.6*radius).epsilon(tolerance));
    CHECK(s.xy == doctest::Approx(0.8*radius).epsilon(tolerance));
    CHECK(s.zz == doctest::Approx(p0).epsilon(tolerance));
    CHECK(done.region == yieldRegion::plane);

    // Plastic shear gamma^p = 2 (e - radius/(2 mu)); 1/sqrt(3) of it counts
    const double gamma = 2*(shear - radius/(2*soil.moduli.mu));
    CHECK
    (
        done.equivalentStrain
     == doctest::Approx(gamma/std::sqrt(3.0)).epsilon(1e-9)
    );
}


TEST_CASE("Element: dilation at fixed volume raises the pressure as the "
    "consistency condition says")
{
    // Pure shear (e, -e, 0): a.D.de = 4 mu de, so beyond yield
    // d lambda = mu de/(mu (1 + s s') + lambda s s')
    const double c = 10e3, phi = 30, psi = 12, p0 = -100e3, shear = 5e-3;
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, phi, psi);
    const double mu = soil.moduli.mu, lambda = soil.moduli.lambda;
    const double sine = std::sin(degree*phi), dilation = std::sin(degree*psi);
    const double atYield =
        (c*std::cos(degree*phi) - p0*sine)/(2*mu);
    const double beyond = shear - atYield;
    const double multiplier =
        mu*beyond/(mu*(1 + sine*dilation) + lambda*sine*dilation);

    PlaneStress s{p0, p0, p0, 0};
    drive(s, PlaneStress{shear, -shear, 0, 0}, 40, soil, c);
    CHECK
    (
        s.xx == doctest::Approx
        (
            p0 + 2*mu*shear
          - multiplier*(2*mu*(1 + dilation) + 2*lambda*dilation)
        ).epsilon(tolerance)
    );
    CHECK
    (
        s.yy == doctest::Approx
        (
            p0 - 2*mu*shear
          + multiplier*(2*mu*(1 - dilation) - 2*lambda*dilation)
        ).epsilon(tolerance)
    );
    CHECK
    (
        s.zz == doctest::Approx
        (
            p0 - multiplier*2*lambda*dilation
        ).epsilon(tolerance)
    );
}


TEST_CASE("Element: pulling ends at the apex, in compression where cf' < 0")
{
    for (const double psi : {0.0, 10.0, 30.0})
    {
        const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 30, psi);
        for (const double c : {10e3, 0.0, -20e3})
        {
            const double apex = c*std::sqrt(3.0);

            SpaceStress s{-200e3, -200e3, -200e3, 0, 0, 0};
            auto done =
                drive(s, SpaceStress{0.01, 0.01, 0.01, 0, 0, 0}, 9, soil, c);
            CHECK(difference(s, SpaceStress{apex, apex, apex, 0, 0, 0})
                < tolerance*200e3);
            CHECK(done.region == yieldRegion::apex);

            PlaneStress p{-200e3, -200e3, -200e3, 0};
            done = drive(p, PlaneStress{0.02, 0.02, 0, 1e-4}, 9, soil, c);
            CHECK(difference(p, PlaneStress{apex, apex, apex, 0})
                < tolerance*200e3);
            CHECK(done.region == yieldRegion::apex);
        }
    }
}


TEST_CASE("Element: negative cf' weakens a sample that is still in "
    "compression")
{
    // 10 m below a water table with c' = 2 kPa, phi' = 30: total stress
    // -150 kPa, p_w = 98.1 kPa. The strength is that of the effective
    // stress; clamped to cf' = 0 it would be 1.4 times as large.
    const double phi = 30, cPrime = 2e3, pw = 98.1e3, p0 = -150e3;
    const double cf = cPrime - pw*std::tan(degree*phi);
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, phi, 0);
    REQUIRE(cf < 0);

    PlaneStress s{p0, p0, p0, 0};
    drive(s, PlaneStress{0, 0, 0, 0.01}, 10, soil, cf);
    const double strength =
        cPrime*std::cos(degree*phi) - (p0 + pw)*std::sin(degree*phi);
    CHECK(s.xy == doctest::Approx(strength).epsilon(tolerance));
    CHECK(strength < 0.4*(-p0*std::sin(degree*phi)));
}


TEST_CASE("Element: Tresca, phi 0, has a shear strength and no apex")
{
    const double c = 30e3;
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 0, 0);

    PlaneStress s{-1e5, -1e5, -1e5, 0};
    drive(s, PlaneStress{0, 0, 0, 0.01}, 10, soil, c);
    CHECK(s.xy == doctest::Approx(c).epsilon(tolerance));
    CHECK(s.xx == doctest::Approx(-1e5).epsilon(tolerance));

    // Confined compression: s_a - s_r = -2 c, mean stress elastic
    SpaceStress t{0, 0, 0, 0, 0, 0};
    drive(t, SpaceStress{0, -0.02, 0, 0, 0, 0}, 10, soil, c);
    const double mean = -0.02*soil.moduli.bulk();
    CHECK(t.yy == doctest::Approx(mean - 4*c/3).epsilon(tolerance));
    CHECK(t.xx == doctest::Approx(mean + 2*c/3).epsilon(tolerance));

    // Isotropic tension of any size is elastic
    SpaceStress u{1e9, 1e9, 1e9, 0, 0, 0};
    CHECK(soil.returnStress(u, c).region == yieldRegion::elastic);

    // Without strength: a fluid that keeps its pressure
    for (const double none : {0.0, -1e3})
    {
        SpaceStress v{-1e5, -2e5, -3e5, 1e4, 0, -2e4};
        soil.returnStress(v, none);
        CHECK(difference(v, SpaceStress{-2e5, -2e5, -2e5, 0, 0, 0})
            < tolerance*2e5);
    }
}


TEST_CASE("Element: impossible angles are refused with value and range")
{
    CHECK_THROWS_WITH_AS
    (
        mohrCoulomb(E, nu, 90, 0),
        "Mohr-Coulomb: frictionAngle = 90 degrees is outside [0, 90)",
        std::invalid_argument
    );
    CHECK_THROWS_WITH_AS
    (
        mohrCoulomb(E, nu, 20, 25),
        "Mohr-Coulomb: dilationAngle = 25 degrees is outside "
        "[0, frictionAngle = 20]",
        std::invalid_argument
    );
    CHECK_THROWS_AS(mohrCoulomb(E, nu, -1, 0), std::invalid_argument);
}

// ************************************************************************* //
