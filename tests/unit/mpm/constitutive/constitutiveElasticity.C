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
    Linear elasticity, stress rotation and principal values.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"

#include <doctest/doctest.h>

using namespace mpm;
using namespace constitutiveTools;

// Everything here is a closed form or an independent code (Eigen); double
// precision leaves a few 1e-16 of the largest number for each operation
static const double roundOff = 1e-13;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Elasticity: uniaxial stress gives E and nu")
{
    const double E = 50e6, nu = 0.3, axial = -1e-3;
    SpaceStress s{0, 0, 0, 0, 0, 0};
    addElasticStress
    (
        s,
        SpaceStress{-nu*axial, -nu*axial, axial, 0, 0, 0},
        elasticModuli(E, nu)
    );

    CHECK(s.zz == doctest::Approx(E*axial).epsilon(roundOff));
    CHECK(std::fabs(s.xx) < roundOff*std::fabs(s.zz));
    CHECK(std::fabs(s.yy) < roundOff*std::fabs(s.zz));
}


TEST_CASE("Elasticity: plane strain carries nu (s_xx + s_yy) out of plane")
{
    const double E = 50e6, nu = 0.3;
    PlaneStress s{0, 0, 0, 0};
    const PlaneStress strain{1e-3, -4e-4, 0, 2e-4};
    addElasticStress(s, strain, elasticModuli(E, nu));

    CHECK(s.zz == doctest::Approx(nu*(s.xx + s.yy)).epsilon(roundOff));
    CHECK(s.xy == doctest::Approx(E/(1 + nu)*strain.xy).epsilon(roundOff));

    // Energy: half of stress times strain
    const double work =
        0.5*(s.xx*strain.xx + s.yy*strain.yy + 2*s.xy*strain.xy);
    CHECK
    (
        elasticEnergyDensity(s, elasticModuli(E, nu))
     == doctest::Approx(work).epsilon(roundOff)
    );
}


TEST_CASE("Elasticity: impossible moduli are refused with value and range")
{
    CHECK_THROWS_WITH_AS
    (
        elasticModuli(-1, 0.3),
        "linear elasticity: E = -1 Pa, nu = 0.3 is outside E > 0, "
        "-1 < nu < 0.5",
        std::invalid_argument
    );
    CHECK_THROWS_AS(elasticModuli(1, 0.5), std::invalid_argument);
    CHECK_THROWS_AS(elasticModuli(1, -1), std::invalid_argument);
}


TEST_CASE("Rotation: a rigid turn by any angle is exact when W is taken "
    "at the middle of the step")
{
    Random random(1);
    for (int i = 0; i < 1000; ++i)
    {
        const double angle = random(-3, 3);

        PlaneStress s = random.plane(-1e5, 1e5);
        Eigen::Matrix3d Q =
            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())
           .toRotationMatrix();
        const PlaneStress turned = planeStress(Q*matrix(s)*Q.transpose());
        rotateStress(s, Spin<2, double>{2*std::tan(0.5*angle)});
        CHECK(difference(s, turned) < 1e-10*1e5);

        SpaceStress s3 = random.space(-1e5, 1e5);
        const Eigen::Vector3d axis = random.rotation().col(0);
        Q = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
        const SpaceStress turned3 = spaceStress(Q*matrix(s3)*Q.transpose());
        const Eigen::Vector3d w = 2*std::tan(0.5*angle)*axis;
        rotateStress(s3, Spin<3, double>{w[0], w[1], w[2]});
        CHECK(difference(s3, turned3) < 1e-10*1e5);
    }
}


TEST_CASE("Rotation: ten turns in small steps keep the norm to 1e-10, and a "
    "small spin is followed to third order")
{
    const double step = 1e-3;
    const int turns = 10;
    const int steps = int(turns*2*std::acos(-1.0)/step);
    const PlaneStress start{-1e5, -3e4, -5e4, 2e4};
    PlaneStress s = start;
    for (int i = 0; i < steps; ++i)
    {
        rotateStress(s, Spin<2, double>{step});
    }

    CHECK
    (
        s.magnitudeSquared()
     == doctest::Approx(start.magnitudeSquared()).epsilon(1e-10)
    );
    CHECK(s.zz == start.zz);

    // The angle of one step is 2 atan(w/2) = w - w^3/12 + O(w^5)
    const double angle = steps*2*std::atan(0.5*step);
    const Eigen::Matrix3d Q =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    CHECK
    (
        difference(s, planeStress(Q*matrix(start)*Q.transpose())) < 1e-10*1e5
    );
    CHECK(std::fabs(angle - steps*step) < steps*step*step*step/11);
}


TEST_CASE("Principal values: as Eigen's, also repeated and on the axes; and "
    "back")
{
    Random random(2);
    double worst = 0, worstBack = 0;
    for (int i = 0; i < 70000; ++i)
    {
        Eigen::Vector3d values
        (
            random(-1, 1), random(-1, 1), random(-1, 1)
        );
        Eigen::Matrix3d Q = random.rotation();
        switch (i % 7)
        {
            case 0: values[1] = values[0]; break;
            case 1: values[1] = values[0]*(1 + 1e-9); break;
            case 2: values[1] = values[2] = values[0]; break;
            case 3: values[1] = values[0] + 1e-14; break;
            case 4: values.array() += 1e8; break;
            case 5: Q.setIdentity(); break;
            default: break;
        }

        const SpaceStress s =
            spaceStress(Q*values.asDiagonal()*Q.transpose());
        const double norm = std::sqrt(s.magnitudeSquared());
        const PrincipalStress<3, double> p(s);
        std::sort(values.data(), values.data() + 3);
        worst = std::max
        ({
            worst,
            std::fabs(p.first - values[2])/norm,
            std::fabs(p.second - values[1])/norm,
            std::fabs(p.third - values[0])/norm
        });
        worstBack = std::max
        (
            worstBack,
            difference(p.withValues(p.first, p.second, p.third), s)/norm
        );
    }
    CHECK(worst < 1e-14);
    CHECK(worstBack < 1e-14);

    const SpaceStress nothing{0, 0, 0, 0, 0, 0};
    const PrincipalStress<3, double> p(nothing);
    CHECK(std::fabs(p.first) < 1e-90);
    CHECK(std::fabs(p.third) < 1e-90);
    CHECK
    (
        difference(p.withValues(5, 5, 5), SpaceStress{5, 5, 5, 0, 0, 0}) == 0
    );
}


TEST_CASE("Principal values: in the plane zz may stand in any place")
{
    Random random(3);
    for (int i = 0; i < 10000; ++i)
    {
        PlaneStress s = random.plane(-1e5, 1e5);
        if (i % 3 == 0)
        {
            s.xx = s.yy = s.zz;
        }
        const PrincipalStress<2, double> p(s);
        const Eigen::Vector3d values = principal(s);
        CHECK(std::fabs(p.first - values[0]) < 1e-9);
        CHECK(std::fabs(p.second - values[1]) < 1e-9);
        CHECK(std::fabs(p.third - values[2]) < 1e-9);
        CHECK
        (
            difference(p.withValues(p.first, p.second, p.third), s) < 1e-9
        );
    }
}

// ************************************************************************* //
