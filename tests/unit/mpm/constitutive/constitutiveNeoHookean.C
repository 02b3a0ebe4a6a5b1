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
    Neo-Hookean elasticity against closed forms and Eigen.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"
#include "neoHookean.H"

#include <doctest/doctest.h>

using namespace mpm;
using namespace constitutiveTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const ElasticModuli<double> rubber = elasticModuli(1e6, 0.3);

// Closed forms: a few 1e-16 of the largest number for each operation
const double roundOff = 1e-13;


SpaceStress ofStretches(const double a, const double b, const double c)
{
    return {a*a, b*b, c*c, 0, 0, 0};
}


//- Some deformation with a positive determinant
Eigen::Matrix3d deformation(Random& random)
{
    const Eigen::Vector3d stretches
    (
        random(0.5, 2), random(0.5, 2), random(0.5, 2)
    );
    return random.rotation()*stretches.asDiagonal()*random.rotation();
}


//- F - I as the laws take it: column by column
std::array<double, 9> increment(const Eigen::Matrix3d& F)
{
    std::array<double, 9> g;
    Eigen::Map<Eigen::Matrix3d>(g.data()) = F - Eigen::Matrix3d::Identity();
    return g;
}


//- Energy a reference volume of a deformation
double energy(const Eigen::Matrix3d& F)
{
    return
        F.determinant()
       *neoHookeanEnergyDensity(spaceStress(F*F.transpose()), rubber);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_CASE("Neo-Hookean: triaxial stretch and simple shear")
{
    const double a = 1.7, b = 0.6, c = 1.1, J = a*b*c;
    const SpaceStress s = neoHookeanStress(ofStretches(a, b, c), rubber);
    const double volumetric = rubber.lambda*std::log(J);
    const auto stress = [&](const double stretch)
    {
        return (volumetric + rubber.mu*(stretch*stretch - 1))/J;
    };
    CHECK(s.xx == doctest::Approx(stress(a)).epsilon(roundOff));
    CHECK(s.yy == doctest::Approx(stress(b)).epsilon(roundOff));
    CHECK(s.zz == doctest::Approx(stress(c)).epsilon(roundOff));

    // x += shear y: mu shear, and a normal stress mu shear^2
    const double shear = 0.8;
    PlaneStress b2{1, 1, 1, 0};
    const double g[4] = {0, 0, shear, 0};
    CHECK(deform(b2, g) == 1);
    const PlaneStress t = neoHookeanStress(b2, rubber);
    CHECK(t.xy == doctest::Approx(rubber.mu*shear).epsilon(roundOff));
    CHECK(t.xx == doctest::Approx(rubber.mu*shear*shear).epsilon(roundOff));
    CHECK(std::fabs(t.yy) < roundOff*rubber.mu);
    CHECK(std::fabs(t.zz) < roundOff*rubber.mu);
}


TEST_CASE("Neo-Hookean: small strains are linear elasticity")
{
    const PlaneStress strain{2e-7, -1e-7, 0, 3e-7};
    PlaneStress b{1, 1, 1, 0};
    const double g[4] = {strain.xx, strain.xy, strain.xy, strain.yy};
    deform(b, g);
    PlaneStress linear{0, 0, 0, 0};
    addElasticStress(linear, strain, rubber);

    // What is left is of the order of strain^2 E
    CHECK
    (
        difference(neoHookeanStress(b, rubber), linear)
      < 10*3e-7*3e-7*1e6
    );
}


TEST_CASE("Neo-Hookean: steps of deformation multiply, in plane and space")
{
    Random random(1);
    for (int i = 0; i < 200; ++i)
    {
        SpaceStress b{1, 1, 1, 0, 0, 0};
        Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
        double J = 1;
        for (int k = 0; k < 3; ++k)
        {
            const Eigen::Matrix3d step = deformation(random);
            J *= deform(b, increment(step).data());
            F = step*F;
        }
        const double size = (F*F.transpose()).norm();
        CHECK(difference(b, spaceStress(F*F.transpose())) < 1e-13*size);
        CHECK(J == doctest::Approx(F.determinant()).epsilon(1e-12));

        const double g[4] = {0.3, -0.2, 0.7, 0.1};
        Eigen::Matrix3d plane = Eigen::Matrix3d::Identity();
        plane(0, 0) += g[0];
        plane(1, 0) += g[1];
        plane(0, 1) += g[2];
        plane(1, 1) += g[3];
        PlaneStress b2 = random.plane(3, 1);
        const PlaneStress expected =
            planeStress(plane*matrix(b2)*plane.transpose());
        CHECK
        (
            deform(b2, g)
         == doctest::Approx(plane.determinant()).epsilon(roundOff)
        );
        CHECK(difference(b2, expected) < roundOff*10);
    }
}


TEST_CASE("Neo-Hookean: the stress turns with the body, and its power is the "
    "rate of the energy")
{
    Random random(2);
    for (int i = 0; i < 200; ++i)
    {
        const Eigen::Matrix3d F = deformation(random);
        const Eigen::Matrix3d Q = random.rotation();
        const SpaceStress s =
            neoHookeanStress(spaceStress(F*F.transpose()), rubber);
        const double size = matrix(s).norm() + rubber.mu;

        const Eigen::Matrix3d QF = Q*F;
        CHECK
        (
            difference
            (
                neoHookeanStress(spaceStress(QF*QF.transpose()), rubber),
                spaceStress(Q*matrix(s)*Q.transpose())
            ) < 1e-12*size
        );

        // Central difference of step 1e-6: error of the order of 1e-12
        // relative from the step, 1e-10 from round-off
        Eigen::Matrix3d L;
        for (int k = 0; k < 9; ++k)
        {
            L(k) = random(-1, 1);
        }
        const double step = 1e-6;
        const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
        const double rate =
            (energy((I + step*L)*F) - energy((I - step*L)*F))/(2*step);
        const double power =
            F.determinant()*(matrix(s).cwiseProduct(L)).sum();
        CHECK(std::fabs(rate - power) < 1e-8*size);
    }
}


TEST_CASE("Neo-Hookean: no wave is faster than said, and one along the "
    "largest stretch is as fast")
{
    // rho c^2 along a principal direction: stretch dP/d(stretch) stretch/J of
    // the nominal stress P = J sigma/stretch
    const auto stiffness = [](const double a, const double b, const double c)
    {
        const double step = 1e-6;
        const auto nominal = [&](const double stretch)
        {
            return
                b*c*neoHookeanStress(ofStretches(stretch, b, c), rubber).xx;
        };
        return
            (nominal(a + step) - nominal(a - step))/(2*step)*a*a/(a*b*c);
    };

    Random random(3);
    for (int i = 0; i < 200; ++i)
    {
        // Beyond J = e the bound is that of transverse waves
        const double a = random(0.6, 1.39);
        const double b = random(0.6, 1.39);
        const double c = random(0.6, 1.39);
        const double said =
            neoHookeanStiffness(ofStretches(a, b, c), rubber);
        const double x = stiffness(a, b, c);
        const double y = stiffness(b, a, c);
        const double z = stiffness(c, a, b);
        CHECK
        (
            said == doctest::Approx(std::max({x, y, z})).epsilon(1e-7)
        );
    }
    CHECK
    (
        neoHookeanStiffness(ofStretches(1, 1, 1), rubber)
     == doctest::Approx(rubber.constrained()).epsilon(roundOff)
    );
}


TEST_CASE("Neo-Hookean: points side by side give what each gives alone")
{
    Random random(4);
    SymmetricTensor<3, Lanes> b;
    SpaceStress alone[laneCount];
    for (int l = 0; l < laneCount; ++l)
    {
        const Eigen::Matrix3d F = deformation(random);
        alone[l] = spaceStress(F*F.transpose());
        setNumber(b.xx, l, alone[l].xx);
        setNumber(b.yy, l, alone[l].yy);
        setNumber(b.zz, l, alone[l].zz);
        setNumber(b.xy, l, alone[l].xy);
        setNumber(b.yz, l, alone[l].yz);
        setNumber(b.zx, l, alone[l].zx);
    }
    const ElasticModuli<Lanes> moduli
    {
        Lanes(rubber.lambda), Lanes(rubber.mu)
    };
    const SymmetricTensor<3, Lanes> s = neoHookeanStress(b, moduli);
    const Lanes energies = neoHookeanEnergyDensity(b, moduli);
    for (int l = 0; l < laneCount; ++l)
    {
        const SpaceStress expected = neoHookeanStress(alone[l], rubber);
        CHECK
        (
            difference
            (
                SpaceStress
                {
                    s.xx[l], s.yy[l], s.zz[l], s.xy[l], s.yz[l], s.zx[l]
                },
                expected
            ) < 1e-12*rubber.mu
        );
        CHECK
        (
            energies[l]
         == doctest::Approx(neoHookeanEnergyDensity(alone[l], rubber))
           .epsilon(1e-12)
        );
    }
}

// ************************************************************************* //
