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
    The Drucker-Prager cone against closed forms: its fits to the Mohr-Coulomb
    pyramid, the return to its side, apex and cut-off.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"
#include "druckerPrager.H"

#include <doctest/doctest.h>

using namespace mpm;
using namespace constitutiveTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double degree = std::acos(-1.0)/180;
const double E = 50e6, nu = 0.3;

// Closed forms in double precision, relative
const double exact = 1e-10;


DruckerPrager<double> cone
(
    const DruckerPragerFit fit,
    const double phi,
    const double psi
)
{
    DruckerPrager<double> soil;
    soil.moduli = elasticModuli(E, nu);
    soil.setAngles
    (
        fit, std::sin(degree*phi), std::cos(degree*phi), std::sin(degree*psi)
    );
    return soil;
}


//- Radius of the largest Mohr circle over what Mohr-Coulomb allows
double ofPyramid(const Eigen::Vector3d& s, const double phi, const double c)
{
    return
        0.5*(s[0] - s[2])
       /(
            c*std::cos(degree*phi)
          - 0.5*(s[0] + s[2])*std::sin(degree*phi)
        );
}


double meanOf(const SpaceStress& s)
{
    return s.trace()/3;
}


double shearOf(const SpaceStress& s)
{
    return std::sqrt(0.5)*
    (
        matrix(s) - meanOf(s)*Eigen::Matrix3d::Identity()
    ).norm();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Drucker-Prager: outer fails with Mohr-Coulomb in triaxial "
    "compression, middle in extension, inner touches it")
{
    const double phi = 33, c = 7e3, confining = -40e3;
    const double N = (1 + std::sin(degree*phi))/(1 - std::sin(degree*phi));

    // sigma_axial = N sigma_side - 2 c sqrt(N), tension positive
    const double compressed = N*confining - 2*c*std::sqrt(N);
    const SpaceStress compression{confining, confining, compressed, 0, 0, 0};
    CHECK
    (
        std::fabs(cone(DruckerPragerFit::outer, phi, 0).excess(compression, c))
      < exact*std::fabs(compressed)
    );

    // The same circle with the axis as the least compression
    const SpaceStress extension{compressed, compressed, confining, 0, 0, 0};
    CHECK
    (
        std::fabs(cone(DruckerPragerFit::middle, phi, 0).excess(extension, c))
      < exact*std::fabs(compressed)
    );

    // Over all Lode angles the inner cone is inside and touches at
    // tan(angle) = -sin(phi)/sqrt(3) (O.C. Zienkiewicz, C. Humpheson 1977)
    const auto onInner = [&](const double angle)
    {
        const DruckerPrager<double> soil =
            cone(DruckerPragerFit::inner, phi, 0);
        const double q = soil.perCohesion*c - soil.slope*confining;
        Eigen::Vector3d s;
        const double twoThirds = 2*std::acos(-1.0)/3;
        for (int i = 0; i < 3; ++i)
        {
            s[i] =
                confining
              + 2/std::sqrt(3.0)*q*std::sin(angle + (1 - i)*twoThirds);
        }
        return ofPyramid(s, phi, c);
    };
    double largest = 0;
    for (int i = -300; i <= 300; ++i)
    {
        const double used = onInner(degree*0.1*i);
        largest = std::max(largest, used);
        CHECK(used < 1 + exact);
    }
    const double touching = -std::atan(std::sin(degree*phi)/std::sqrt(3.0));
    CHECK(onInner(touching) == doctest::Approx(1).epsilon(exact));
    CHECK(largest < 1 + exact);
}


TEST_CASE("Drucker-Prager: planeStrain flows at Mohr-Coulomb's strength, and "
    "at its dilation, when sheared in plane strain")
{
    for (const double psi : {0.0, 8.0, 30.0})
    {
        CAPTURE(psi);
        const double phi = 30, c = 5e3;
        const DruckerPrager<double> soil =
            cone(DruckerPragerFit::planeStrain, phi, psi);

        // Shear with the volume change of psi keeps the stress: strain
        // increments e1 - e3 = 1e-4, e1 + e3 = sin(psi) of it
        const double shear = 1e-4;
        const double swelling = std::sin(degree*psi)*shear;
        const PlaneStress strain
        {
            0.5*(swelling + shear), 0.5*(swelling - shear), 0, 0
        };
        PlaneStress s{-50e3, -50e3, -50e3, 0};
        double p = 0;
        for (int i = 0; i < 4000; ++i)
        {
            p = s.trace();
            addElasticStress(s, strain, soil.moduli);
            soil.returnStress(s, c);
        }

        // Steady, on Mohr-Coulomb's line in the plane
        CHECK(s.trace() == doctest::Approx(p).epsilon(exact));
        const double radius = 0.5*(s.xx - s.yy);
        const double centre = 0.5*(s.xx + s.yy);
        CHECK
        (
            radius
         == doctest::Approx
            (
                c*std::cos(degree*phi) - centre*std::sin(degree*phi)
            ).epsilon(exact)
        );
    }
}


TEST_CASE("Drucker-Prager: the return is along the flow, onto the cone")
{
    Random random(5);
    int atSide = 0, atApex = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const double phi = random(0, 50);
        const double psi = random(0, phi);
        const double c = random(-20e3, 30e3);
        const DruckerPragerFit fit = DruckerPragerFit(i % 4);
        const DruckerPrager<double> soil = cone(fit, phi, psi);
        const SpaceStress trial = random.space(random(-1e5, 5e4), 8e4);
        SpaceStress s(trial);
        const PlasticIncrement<double> plastic = soil.returnStress(s, c);
        const double size = 1e5;

        if (plastic.region == yieldRegion::elastic)
        {
            CHECK(soil.excess(trial, c) <= 0);
            CHECK(difference(s, trial) == 0);
            continue;
        }

        // Strain lost, split: its trace over its shear is the dilation
        const double volume =
            3*(meanOf(trial) - meanOf(s))/(3*soil.moduli.bulk());
        const double shear =
            (shearOf(trial) - shearOf(s))/soil.moduli.mu;
        CHECK
        (
            plastic.equivalentStrain
         == doctest::Approx(shear/std::sqrt(3.0)).epsilon(1e-9)
        );
        if (plastic.region == yieldRegion::apex)
        {
            ++atApex;
            CHECK(shearOf(s) < 1e-6);
            if (phi > 1)
            {
                CHECK
                (
                    std::fabs(meanOf(s) - c/std::tan(degree*phi))
                  < exact*(size + std::fabs(c/std::tan(degree*phi)))
                );
            }
            continue;
        }
        ++atSide;
        CHECK(std::fabs(soil.excess(s, c)) < exact*size);
        CHECK
        (
            std::fabs(volume - soil.dilation*shear)
          < exact*(size/soil.moduli.mu)
        );

        // The deviator keeps its direction
        const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
        const Eigen::Matrix3d before = matrix(trial) - meanOf(trial)*I;
        const Eigen::Matrix3d after = matrix(s) - meanOf(s)*I;
        CHECK
        (
            (after*before.norm() - before*after.norm()).norm()
          < exact*size*size
        );
    }
    CHECK(atSide > 1000);
    CHECK(atApex > 1000);
}


TEST_CASE("Drucker-Prager: the cut-off of the mean stress")
{
    const double phi = 30, c = 10e3, limit = 2e3;
    const DruckerPrager<double> soil =
        cone(DruckerPragerFit::inner, phi, 10);
    const double corner = soil.perCohesion*c - soil.slope*limit;

    // Below the corner q is kept, beyond it the corner is the answer
    SpaceStress low{8e3, 8e3, 8e3, 0.5*corner, 0, 0};
    CHECK(soil.returnStress(low, c, &limit).region == yieldRegion::tension);
    CHECK
    (
        difference(low, SpaceStress{limit, limit, limit, 0.5*corner, 0, 0})
      < exact*c
    );
    SpaceStress high{8e3, 8e3, 8e3, 1.2*corner, 0, 0};
    CHECK(soil.returnStress(high, c, &limit).region == yieldRegion::tension);
    CHECK
    (
        difference(high, SpaceStress{limit, limit, limit, corner, 0, 0})
      < exact*c
    );

    // A return to the side that ends below the limit is not cut
    SpaceStress side{-9e3, -9e3, -9e3, 4*corner, 0, 0};
    SpaceStress free(side);
    CHECK(soil.returnStress(side, c, &limit).region == yieldRegion::plane);
    soil.returnStress(free, c);
    CHECK(difference(side, free) == 0);

    // Below a water table the apex is in compression: cf = c - p_w tan(phi)
    const double pw = 50e3;
    const double cf = c - pw*std::tan(degree*phi);
    SpaceStress wet{-1e3, -1e3, -1e3, 1e3, 0, 0};
    CHECK(soil.returnStress(wet, cf).region == yieldRegion::apex);
    CHECK
    (
        meanOf(wet)
     == doctest::Approx(c/std::tan(degree*phi) - pw).epsilon(exact)
    );
}


TEST_CASE("Drucker-Prager: points side by side give what each gives alone")
{
    Random random(6);
    const DruckerPrager<double> soil =
        cone(DruckerPragerFit::planeStrain, 35, 5);
    DruckerPrager<Lanes> many;
    many.moduli = {Lanes(soil.moduli.lambda), Lanes(soil.moduli.mu)};
    many.setAngles
    (
        DruckerPragerFit::planeStrain,
        Lanes(std::sin(degree*35)),
        Lanes(std::cos(degree*35)),
        Lanes(std::sin(degree*5))
    );
    for (int i = 0; i < 500; ++i)
    {
        PlaneStress alone[laneCount];
        SymmetricTensor<2, Lanes> s;
        Lanes cohesion, limit;
        for (int l = 0; l < laneCount; ++l)
        {
            alone[l] = random.plane(random(-6e4, 3e4), 5e4);
            setNumber(s.xx, l, alone[l].xx);
            setNumber(s.yy, l, alone[l].yy);
            setNumber(s.zz, l, alone[l].zz);
            setNumber(s.xy, l, alone[l].xy);
            setNumber(cohesion, l, random(-1e4, 2e4));
            setNumber(limit, l, random(0, 5e3));
        }
        const PlasticIncrement<Lanes> plastic =
            many.returnStress(s, cohesion, &limit);
        for (int l = 0; l < laneCount; ++l)
        {
            const double tension = limit[l];
            const PlasticIncrement<double> one =
                soil.returnStress(alone[l], cohesion[l], &tension);
            CHECK(plastic.region[l] == one.region);
            CHECK
            (
                difference
                (
                    alone[l],
                    PlaneStress{s.xx[l], s.yy[l], s.zz[l], s.xy[l]}
                ) < 1e-9
            );
        }
    }
}

// ************************************************************************* //
