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
    Softening and viscosity of single points as the stress update applies
    them, against closed forms.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"
#include "mpmStressUpdate.H"

#include <doctest/doctest.h>

#include <numeric>

using namespace mpm;
using namespace constitutiveTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double degree = std::acos(-1.0)/180;

// Closed forms in double precision, relative
const double exact = 1e-10;


Material clay()
{
    Material material;
    material.name = "clay";
    material.E = 10e6;
    material.nu = 0.25;
    return material;
}


//- Points in the same plane strain, driven by a velocity gradient
class Element
{
    LawTable laws_;
    PointCloud<2> cloud_;

public:

    Element
    (
        const Material& material,
        const double cellSize,
        const double cohesion,
        const double frictionAngle,
        const double porePressure,
        const double stress
    )
    :
        laws_({material}, cellSize)
    {
        PointData data;
        for (int i = 0; i < laneCount; ++i)
        {
            data.position.push_back({{0, 0, 0}});
            data.volume.push_back(1);
            data.rho.push_back(2000);
            data.zone.push_back(0);
            data.cohesionIntercept.push_back(cohesion);
            data.porePressure.push_back(porePressure);
            data.sigma.push_back({{stress, stress, stress, 0, 0, 0}});
        }
        cloud_.assign(data, 0, data.size());
        for (std::int32_t& law : cloud_.law)
        {
            law = laws_.find(0, frictionAngle);
        }
    }

    //- dv_i/dx_j at [j*2 + i]
    void shear(const std::array<double, 4>& gradient, const double deltaT)
    {
        std::int32_t points[laneCount];
        std::iota(points, points + laneCount, 0);
        const Lanes L[4] =
        {
            Lanes(gradient[0]), Lanes(gradient[1]),
            Lanes(gradient[2]), Lanes(gradient[3])
        };
        StressUpdate<2>(laws_, deltaT, false).update
        (
            cloud_, points, laneCount, L
        );
    }

    PlaneStress stress() const
    {
        const Stress<2>& s = cloud_.sigma[2];
        return {s[0], s[1], s[2], s[3]};
    }

    double plasticStrain() const
    {
        return cloud_.plasticStrain[2];
    }
};


//- Half the difference of the principal stresses in the plane
double radius(const PlaneStress& s)
{
    return std::hypot(0.5*(s.xx - s.yy), s.xy);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Viscosity: steady pure shear carries c + viscosity x rate, "
    "whatever the step")
{
    const double c = 2e3, viscosity = 300, rate = 0.7;
    for (const std::string model : {"MohrCoulomb", "DruckerPrager"})
    {
        for (const double deltaT : {1e-6, 1e-4, 1e-2})
        {
            CAPTURE(model);
            CAPTURE(deltaT);
            Material material(clay());
            material.constitutiveModel = model;
            material.viscosity = viscosity;
            Element element(material, 1, c, 0, 0, -20e3);

            // Until the strain is far beyond the yield strain, 5e-4, and the
            // time far beyond viscosity/mu = 7.5e-5 s
            const int steps = std::max(100, int(0.01/deltaT));
            for (int i = 0; i < steps; ++i)
            {
                element.shear({{0.5*rate, 0, 0, -0.5*rate}}, deltaT);
            }
            CHECK
            (
                radius(element.stress())
             == doctest::Approx(c + viscosity*rate).epsilon(exact)
            );
        }
    }
}


TEST_CASE("Viscosity: a soil with friction carries p sin(phi) + c cos(phi) "
    "and viscosity x rate")
{
    const double c = 1e3, phi = 30, p = -30e3, viscosity = 2e3, rate = 0.4;
    Material material(clay());
    material.viscosity = viscosity;
    Element element(material, 1, c, phi, 0, p);
    for (int i = 0; i < 4000; ++i)
    {
        element.shear({{0.5*rate, 0, 0, -0.5*rate}}, 1e-4);
    }

    // No dilation: the mean stress in the plane stays as it was
    CHECK
    (
        radius(element.stress())
     == doctest::Approx
        (
            c*std::cos(degree*phi) - p*std::sin(degree*phi) + viscosity*rate
        ).epsilon(exact)
    );
}


TEST_CASE("Softening: strength falls in a straight line with slip, the same "
    "for every cell size")
{
    const double c = 12e3, phi = 32, p = -60e3, pw = 15e3;
    Material material(clay());
    material.softening.residualCohesion = 3e3;
    material.softening.residualFrictionAngle = 20;
    material.softening.peakStrain = 0.01;
    material.softening.residualStrain = 0.11;
    material.softening.length = 0.5;
    material.softening.regularisation = "crackBand";

    const auto tangent = [](const double a) { return std::tan(degree*a); };
    for (const double cellSize : {0.25, 0.5, 2.0})
    {
        CAPTURE(cellSize);
        Element element
        (
            material, cellSize, c - pw*tangent(phi), phi, pw, p
        );
        const double strainStep = 1e-5*0.5/cellSize;
        double worst = 0, used = 0;
        for (int i = 0; i < 25000; ++i)
        {
            // The strength of a step is that of the strain before it
            const double slip = element.plasticStrain()*cellSize/0.5;
            element.shear({{0.5, 0, 0, -0.5}}, strainStep);
            if (element.plasticStrain() > 0)
            {
                const double lost =
                    std::min(1.0, std::max(0.0, (slip - 0.01)/0.1));
                const double cNow = c - lost*(c - 3e3);
                const double phiNow = std::atan
                (
                    tangent(phi) - lost*(tangent(phi) - tangent(20))
                );
                const double allowed =
                    cNow*std::cos(phiNow) - (p + pw)*std::sin(phiNow);
                worst = std::max
                (
                    worst,
                    std::fabs(radius(element.stress())/allowed - 1)
                );
                used = std::max(used, lost);
            }
        }
        CHECK(worst < exact);
        CHECK(used == 1);
    }
}


TEST_CASE("Softening: the dilation goes with the strength, and nothing is "
    "lost below the residual")
{
    Softening softening{};
    softening.peakStrain = 0.1;
    softening.perStrain = 1/0.4;
    softening.residualCohesion = 5e3;
    softening.tanPhi = std::tan(degree*35);
    softening.residualTanPhi = std::tan(degree*25);
    softening.tanPsi = std::tan(degree*10);
    softening.residualTanPsi = 0;

    CHECK(softening.lost(0.05) == 0);
    CHECK(softening.lost(0.3) == doctest::Approx(0.5).epsilon(exact));
    CHECK(softening.lost(7.0) == 1);

    const SoftenedStrength<double> half =
        softening.strength(0.3, 9e3, 0.0);
    CHECK(half.cohesionIntercept == doctest::Approx(7e3).epsilon(exact));
    CHECK
    (
        half.sinPhi/half.cosPhi
     == doctest::Approx
        (
            0.5*(std::tan(degree*35) + std::tan(degree*25))
        ).epsilon(exact)
    );
    CHECK
    (
        std::tan(std::asin(half.sinPsi))
     == doctest::Approx(0.5*std::tan(degree*10)).epsilon(exact)
    );
    CHECK(softening.strength(7.0, 4e3, 0.0).cohesionIntercept == 4e3);
}


TEST_CASE("Softening and viscosity out of range are refused by name")
{
    Material material(clay());
    material.viscosity = -1;
    CHECK_THROWS_WITH_AS
    (
        material.validate(),
        "material clay: viscosity = -1 is not allowed: >= 0 [Pa s]",
        std::invalid_argument
    );
    material.viscosity = 0;
    material.druckerPragerFit = "best";
    CHECK_THROWS_AS(material.validate(), std::invalid_argument);
    material.druckerPragerFit = "inner";
    material.softening.length = 1;
    material.softening.peakStrain = 0.1;
    material.softening.residualStrain = 0.1;
    CHECK_THROWS_AS(material.validate(), std::invalid_argument);
    material.softening.residualStrain = 0.2;
    material.validate();
    material.softening.residualFrictionAngle = 90;
    CHECK_THROWS_AS(material.validate(), std::invalid_argument);
}

// ************************************************************************* //
