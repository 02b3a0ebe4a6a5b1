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
    Tension cut-off on top of the Mohr-Coulomb surface.

\*---------------------------------------------------------------------------*/

#include "constitutiveTools.H"

#include <doctest/doctest.h>

using namespace mpm;
using namespace constitutiveTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double E = 50e6;
const double nu = 0.3;
const double size = 1e5;

// 1e-10 of the stresses: the elimination behind a corner costs a few roundings
const double tolerance = 1e-10*5*size;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Tension: one, two and three directions cut, closed forms")
{
    // Cutting n directions loses x in each; the others lose lambda (sum of
    // the n multipliers): with multipliers m, 2 mu m + n lambda m = x
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 30, 0);
    const double lambda = soil.moduli.lambda, mu = soil.moduli.mu;
    const double c = 40e3, limit = 5e3, over = 3e3;

    SpaceStress s{limit + over, -2e3, -4e3, 0, 0, 0};
    CHECK(soil.returnStress(s, c, limit).region == yieldRegion::tension);
    const double one = over/(2*mu + lambda);
    CHECK(s.xx == doctest::Approx(limit).epsilon(1e-10));
    CHECK(s.yy == doctest::Approx(-2e3 - lambda*one).epsilon(1e-10));
    CHECK(s.zz == doctest::Approx(-4e3 - lambda*one).epsilon(1e-10));

    s = {limit + over, limit + over, -4e3, 0, 0, 0};
    soil.returnStress(s, c, limit);
    const double two = over/(2*mu + 2*lambda);
    CHECK(s.xx == doctest::Approx(limit).epsilon(1e-10));
    CHECK(s.yy == doctest::Approx(limit).epsilon(1e-10));
    CHECK(s.zz == doctest::Approx(-4e3 - 2*lambda*two).epsilon(1e-10));

    s = {limit + over, limit + over, limit + over, 0, 0, 0};
    soil.returnStress(s, c, limit);
    CHECK(difference(s, SpaceStress{limit, limit, limit, 0, 0, 0})
        < tolerance);
}


TEST_CASE("Tension: where shear and tension meet, both planes hold")
{
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 30, 0);
    const double c = 10e3, limit = 0;

    // s1 far above, s3 far below: (limit, s2, s3 of the surface)
    PlaneStress s{40e3, -60e3, -20e3, 0};
    const PlaneStress trial = s;
    soil.returnStress(s, c, limit);
    const double third = -2*c*soil.cosPhi/(1 - soil.sinPhi);
    CHECK(s.xx == doctest::Approx(limit).epsilon(1e-10));
    CHECK(s.yy == doctest::Approx(third).epsilon(1e-10));

    // Both multipliers positive: 2 mu (1 - sin psi) of the shear's shows in
    // the third strain, the rest of the first is the cut-off's
    const PlaneStress flow = plasticStrain(trial, s, soil.moduli);
    CHECK(flow.yy < 0);
    CHECK(flow.xx > -flow.yy);
    CHECK(std::fabs(flow.zz) < tolerance/E);
}


TEST_CASE("Tension: inside both surfaces, idempotent, no change where the "
    "limit is beyond the apex")
{
    Random random(21);
    for (const double phi : {0.0, 20.0, 30.0, 45.0})
    {
        for (const double share : {0.0, 0.4, 1.0})
        {
            const MohrCoulomb<double> soil =
                mohrCoulomb(E, nu, phi, share*phi);
            for (int i = 0; i < 1000; ++i)
            {
                const double cohesion =
                    phi > 0 ? random(-1e4, 1e4) : random(0, 1e4);
                const double apex = cohesion*soil.cotPhi;
                const double limit = apex - random(0, 1)*2e4;
                const PlaneStress trial =
                    random.plane(limit + random(-2, 1)*size, size);

                PlaneStress s = trial;
                soil.returnStress(s, cohesion, limit);
                const Eigen::Vector3d p = principal(s);
                CHECK(p[0] <= limit + tolerance);
                CHECK(soil.excess(p[0], p[2], cohesion) < tolerance);

                PlaneStress again = s;
                soil.returnStress(again, cohesion, limit);
                CHECK(difference(again, s) < 10*tolerance);

                // A limit out of reach
                if (phi > 0)
                {
                    PlaneStress a = trial, b = trial;
                    soil.returnStress(a, cohesion, apex + 1e3);
                    soil.returnStress(b, cohesion);
                    CHECK(difference(a, b) == 0);
                }

                // Acts on the effective stress: all of it shifts with p_w
                const double pw = 3e4;
                PlaneStress shifted = trial;
                shifted.xx -= pw;
                shifted.yy -= pw;
                shifted.zz -= pw;
                soil.returnStress
                (
                    shifted,
                    cohesion - pw*soil.sinPhi/soil.cosPhi,
                    limit - pw
                );
                shifted.xx += pw;
                shifted.yy += pw;
                shifted.zz += pw;
                CHECK(difference(shifted, s) < 10*tolerance);
            }
        }
    }
}


TEST_CASE("Tension: associated returns are the nearest points in the energy "
    "norm")
{
    // (trial - s) : C : (x - s) <= 0 for every admissible x
    Random random(22);
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 30, 30);
    const double c = 10e3, limit = 4e3;
    for (int i = 0; i < 300; ++i)
    {
        const SpaceStress trial = random.space(random(-1, 0.5)*size, size);
        SpaceStress s = trial;
        soil.returnStress(s, c, limit);
        const SpaceStress flow = plasticStrain(trial, s, soil.moduli);

        for (int j = 0; j < 20; ++j)
        {
            SpaceStress x = random.space(random(-2, 0.2)*size, size);
            soil.returnStress(x, c, limit);
            const double work =
                (matrix(flow).array()*(matrix(x) - matrix(s)).array()).sum();
            CHECK(work < tolerance*size/E);
        }
    }
}

// ************************************************************************* //
