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
    Properties of the Mohr-Coulomb return over random trial stresses: on the
    surface, flow within the cone of the active planes, nothing left to
    return, the same in effective stresses, in any axes, in lanes.

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

// Trial stresses and the apex are of this size; 1e-10 of it is a few hundred
// roundings
const double tolerance = 1e-10*5*size;

struct Soil
{
    double phi, psi;
};

//- From nearly smooth to very rough; associated, between, not dilating
const Soil soils[] =
{
    {5, 0}, {5, 5}, {20, 0}, {30, 0}, {30, 10}, {30, 30}, {45, 20}, {60, 60}
};

//- f/2 by Eigen's principal values
template<int Dim>
double excess
(
    const SymmetricTensor<Dim, double>& s,
    const MohrCoulomb<double>& soil,
    const double cohesion
)
{
    const Eigen::Vector3d p = principal(s);
    return soil.excess(p[0], p[2], cohesion);
}

//- Check one return; false if the trial stress was elastic
template<int Dim>
bool checkReturn
(
    const SymmetricTensor<Dim, double>& trial,
    const MohrCoulomb<double>& soil,
    const double cohesion
)
{
    SymmetricTensor<Dim, double> s(trial);
    const PlasticIncrement<double> done = soil.returnStress(s, cohesion);
    const double before = excess(trial, soil, cohesion);

    if (done.region == yieldRegion::elastic)
    {
        CHECK(before < tolerance);
        CHECK(difference(s, trial) == 0);
        CHECK(done.equivalentStrain == 0);
        return false;
    }

    CHECK(before > -tolerance);
    CHECK(std::fabs(excess(s, soil, cohesion)) < tolerance);

    // Returning again changes nothing
    SymmetricTensor<Dim, double> again(s);
    soil.returnStress(again, cohesion);
    CHECK(difference(again, s) < tolerance);

    // Plastic strain: on the stress's axes, within the cone of the planes
    // that meet there
    const SymmetricTensor<Dim, double> flow =
        plasticStrain(trial, s, soil.moduli);
    const Eigen::Matrix3d commutator =
        matrix(flow)*matrix(s) - matrix(s)*matrix(flow);
    CHECK(commutator.cwiseAbs().maxCoeff() < tolerance*size/E);

    const Eigen::Vector3d e = principal(flow);
    const double small = tolerance/E;
    const double up = 1 + soil.sinPsi, down = 1 - soil.sinPsi;
    if (done.region == yieldRegion::plane)
    {
        CHECK(e[0] >= -small);
        CHECK(std::fabs(e[1]) < small);
        CHECK(std::fabs(e[0]*down + e[2]*up) < small);
    }
    else if (done.region == yieldRegion::compressionEdge)
    {
        CHECK(e[1] >= -small);
        CHECK(std::fabs((e[0] + e[1])*down + e[2]*up) < small);
    }
    else if (done.region == yieldRegion::extensionEdge)
    {
        CHECK(e[1] <= small);
        CHECK(std::fabs(e[0]*down + (e[1] + e[2])*up) < small);
    }
    else
    {
        REQUIRE(done.region == yieldRegion::apex);
        const double apex = cohesion*soil.cotPhi;
        CHECK(std::fabs(s.xx - apex) < tolerance);
        if (soil.sinPsi == soil.sinPhi)
        {
            // Associated: no work on the way to any other admissible stress,
            // that is against both kinds of edges that leave the apex
            CHECK
            (
                -down*(e[0] + e[1]) - up*e[2] <= small
            );
            CHECK
            (
                -down*e[0] - up*(e[1] + e[2]) <= small
            );
        }
    }

    // Equivalent plastic strain as documented
    const double mean = flow.trace()/3;
    const double deviator =
        std::sqrt(2.0/3.0*(flow.magnitudeSquared() - 3*mean*mean));
    CHECK(std::fabs(done.equivalentStrain - deviator) < 1e-9*size/E);
    return true;
}

//- Put one stress into a lane
void setLane(SymmetricTensor<2, Lanes>& many, const int j, const PlaneStress& s)
{
    setNumber(many.xx, j, s.xx);
    setNumber(many.yy, j, s.yy);
    setNumber(many.zz, j, s.zz);
    setNumber(many.xy, j, s.xy);
}


void setLane(SymmetricTensor<3, Lanes>& many, const int j, const SpaceStress& s)
{
    setNumber(many.xx, j, s.xx);
    setNumber(many.yy, j, s.yy);
    setNumber(many.zz, j, s.zz);
    setNumber(many.xy, j, s.xy);
    setNumber(many.yz, j, s.yz);
    setNumber(many.zx, j, s.zx);
}


//- The stress in a lane
PlaneStress lane(const SymmetricTensor<2, Lanes>& many, const int j)
{
    return {many.xx[j], many.yy[j], many.zz[j], many.xy[j]};
}


SpaceStress lane(const SymmetricTensor<3, Lanes>& many, const int j)
{
    return
    {
        many.xx[j], many.yy[j], many.zz[j],
        many.xy[j], many.yz[j], many.zx[j]
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_CASE("Return: on the surface, within the cone, idempotent; all regions "
    "reached")
{
    Random random(11);
    for (const Soil& angles : soils)
    {
        const MohrCoulomb<double> soil =
            mohrCoulomb(E, nu, angles.phi, angles.psi);
        for (const double cohesion : {8e3, 0.0, -8e3})
        {
            CAPTURE(angles.phi);
            CAPTURE(angles.psi);
            CAPTURE(cohesion);
            const double apex = cohesion*soil.cotPhi;
            int yielding = 0;
            for (int i = 0; i < 400; ++i)
            {
                const double mean = apex + random(-3, 1)*size;
                yielding +=
                    checkReturn(random.plane(mean, size), soil, cohesion);
                yielding +=
                    checkReturn(random.space(mean, size), soil, cohesion);
            }
            CHECK(yielding > 200);
        }
    }
}


TEST_CASE("Return: total stress with cf' = c' - p_w tan(phi) is effective "
    "stress with c', for either sign of p_w")
{
    Random random(12);
    for (const Soil& angles : soils)
    {
        const MohrCoulomb<double> soil =
            mohrCoulomb(E, nu, angles.phi, angles.psi);
        for (int i = 0; i < 500; ++i)
        {
            const double pw = random(-0.5, 1)*size;
            const double cPrime = 5e3;
            const double cf = cPrime - pw*soil.sinPhi/soil.cosPhi;

            PlaneStress effective = random.plane(random(-2, 0.5)*size, size);
            PlaneStress total = effective;
            total.xx -= pw;
            total.yy -= pw;
            total.zz -= pw;

            const auto a = soil.returnStress(effective, cPrime);
            const auto b = soil.returnStress(total, cf);
            effective.xx -= pw;
            effective.yy -= pw;
            effective.zz -= pw;
            CHECK(difference(total, effective) < tolerance);
            CHECK
            (
                std::fabs(a.equivalentStrain - b.equivalentStrain)
              < tolerance/E
            );
        }
    }
}


TEST_CASE("Return: the same in every frame, and a section is a slice of "
    "space")
{
    Random random(13);
    for (const Soil& angles : soils)
    {
        const MohrCoulomb<double> soil =
            mohrCoulomb(E, nu, angles.phi, angles.psi);
        for (int i = 0; i < 500; ++i)
        {
            const double cohesion = random(-1e4, 1e4);
            const PlaneStress trial =
                random.plane(random(-3, 0.5)*size, size);

            PlaneStress inPlane = trial;
            soil.returnStress(inPlane, cohesion);

            const Eigen::Matrix3d Q = random.rotation();
            SpaceStress turned =
                spaceStress(Q*matrix(trial)*Q.transpose());
            soil.returnStress(turned, cohesion);
            const SpaceStress back =
                spaceStress(Q.transpose()*matrix(turned)*Q);

            CHECK(difference(back, spaceStress(matrix(inPlane))) < tolerance);

            // Axes renamed: each of x, y, z carries each principal value
            SpaceStress cycled
            {
                trial.zz, trial.xx, trial.yy, 0, trial.xy, 0
            };
            soil.returnStress(cycled, cohesion);
            CHECK(std::fabs(cycled.xx - inPlane.zz) < tolerance);
            CHECK(std::fabs(cycled.yy - inPlane.xx) < tolerance);
            CHECK(std::fabs(cycled.yz - inPlane.xy) < tolerance);
        }
    }
}


TEST_CASE("Return: the plane-strain check without roots agrees with the "
    "surface in all six orders of the principal values")
{
    Random random(14);
    const MohrCoulomb<double> soil = mohrCoulomb(E, nu, 33, 0);
    const double orders[6][3] =
    {
        {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}
    };
    for (const auto& order : orders)
    {
        for (int i = 0; i < 500; ++i)
        {
            const double cohesion = random(-1e4, 1e4);
            const double apex = cohesion*soil.cotPhi;
            double values[3];
            for (int j = 0; j < 3; ++j)
            {
                values[j] = apex - size + order[j]*random(0.0, 0.6)*size;
            }
            const PlaneStress s{values[0], values[1], values[2], 0};
            const double f = excess(s, soil, cohesion);
            if (std::fabs(f) > tolerance)
            {
                CHECK(soil.yields(s, cohesion) == (f > 0));
            }
        }
    }
}


TEST_CASE_TEMPLATE
(
    "Return: lanes do what one point does, elastic ones untouched",
    Dimension,
    std::integral_constant<int, 2>,
    std::integral_constant<int, 3>
)
{
    constexpr int Dim = Dimension::value;
    typedef SymmetricTensor<Dim, double> One;
    typedef SymmetricTensor<Dim, Lanes> Many;

    Random random(15);
    const MohrCoulomb<double> mixed[laneCount] =
    {
        mohrCoulomb(E, nu, 30, 0),
        mohrCoulomb(2*E, 0.2, 20, 10),
        mohrCoulomb(E, nu, 0, 0),
        mohrCoulomb(E, nu, 45, 45),
        mohrCoulomb(E/2, 0, 38, 5),
        mohrCoulomb(E, 0.45, 30, 30),
        mohrCoulomb(E, nu, 5, 0),
        mohrCoulomb(3*E, 0.1, 60, 20)
    };
    std::array<const MohrCoulomb<double>*, laneCount> soils;
    for (int j = 0; j < laneCount; ++j)
    {
        soils[j] = mixed + j;
    }
    const MohrCoulomb<Lanes> lanes = lanesOf(soils);

    for (int i = 0; i < 2000; ++i)
    {
        One one[laneCount];
        Many many;
        Lanes cohesion(0.0), limit(0.0);
        for (int j = 0; j < laneCount; ++j)
        {
            // Elastic, isotropic and yielding points beside each other
            const double mean = random(-3, 0.5)*size;
            const double off = (i + j) % 3 == 0 ? 0.0 : size;
            if constexpr (Dim == 2)
            {
                one[j] = random.plane(mean, off);
            }
            else
            {
                one[j] = random.space(mean, off);
            }
            setLane(many, j, one[j]);
            setNumber(cohesion, j, random(0, 1e4));
            setNumber(limit, j, random(-1e4, 1e4));
        }

        const bool cut = i % 2;
        const PlasticIncrement<Lanes> done =
            cut
          ? lanes.returnStress(many, cohesion, limit)
          : lanes.returnStress(many, cohesion);
        for (int j = 0; j < laneCount; ++j)
        {
            const PlasticIncrement<double> alone =
                cut
              ? mixed[j].returnStress(one[j], cohesion[j], limit[j])
              : mixed[j].returnStress(one[j], cohesion[j]);
            CHECK(difference(lane(many, j), one[j]) < tolerance);
            CHECK
            (
                std::fabs(done.equivalentStrain[j] - alone.equivalentStrain)
              < tolerance/E
            );
            CHECK(done.region[j] == alone.region);
        }
    }
}

// ************************************************************************* //
