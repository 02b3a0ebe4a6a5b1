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
    Strength reduction of an infinite slope with a cohesion intercept cf' for
    each point, which is the local shear strength method itself:

        FS = cf'/(gamma d sin b) + tan(phi)/tan(b),  at normal depth d.

    Associated flow fails on planes parallel to the ground, where this holds.
    Without dilation the shearing layer has its principal stresses at 45
    degrees to it, and its strength is c cos(phi) + sigma_n sin(phi)
    (E.H. Davis 1968): FS is less by the cosine of the reduced friction angle.

    The ground water may be absent, or its table inside the slope: then cf' =
    c' - p_w tan(phi) is positive above and negative at the slip surface. A
    code that clamps cf' at zero finds a safety factor a third too high.

    Axes along and out of the ground. c' grows smoothly off the depth of the
    slip surface, which so lies inside the soil: next to a wall or to firm
    ground the cells that both share hold the first row back. The slab is long
    and held at its ends; its middle is watched for a time in which no wave
    from there arrives. Soil of strength reduced by F > FS accelerates above
    the slip surface, with g sin(b) (1 - FS/F) at first order: FS is where the
    accelerations at two values of F extrapolate to rest.

\*---------------------------------------------------------------------------*/

#include "verification.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double rho = 2000;

//- Depth of the soil and of the slip surface in it [m]
const double depth = 7.5;
const double slip = 5;

//- Growth of c' off the slip surface: this times (distance/slip)^2 [Pa]
const double firming = 120e3;

struct Slope
{
    std::string name;

    //- Inclination, friction angle [deg], cohesion at the slip surface [Pa]
    double beta, phi, cohesion;

    //- Normal depth of the water table [m]; the water flows along the ground
    bool wet;
    double table;

    //- p_w at a normal depth; suction acts fully above the table
    double porePressure(const double d) const
    {
        const double rhoWater = 1000;
        return
            wet
          ? rhoWater*verification::gravity*(d - table)
           *std::cos(verification::degree*beta)
          : 0;
    }

    double tanPhi() const
    {
        return std::tan(verification::degree*phi);
    }

    //- Zhu2022 Eq. 6
    double intercept(const double d) const
    {
        const double off = (d - slip)/slip;
        return cohesion + firming*off*off - porePressure(d)*tanPhi();
    }

    //- Depth of the lowest safety factor [m]
    double criticalDepth() const
    {
        double critical = slip;
        const double step = 1e-3;
        for (double d = 0.5*slip; d < depth; d += step)
        {
            critical = planeFactor(d) < planeFactor(critical) ? d : critical;
        }
        return critical;
    }

    //- Safety factor of a plane at a normal depth
    double planeFactor(const double d) const
    {
        const double weight = rho*verification::gravity*d;
        const double b = verification::degree*beta;
        return intercept(d)/(weight*std::sin(b)) + tanPhi()/std::tan(b);
    }

    //- The same without dilation: F cos(atan(tan(phi)/F)) is F's own root
    double planeFactorWithoutDilation(const double d) const
    {
        // F = P cos(atan(t/F)) = P F/sqrt(F^2 + t^2), so F^2 = P^2 - t^2
        const double P = planeFactor(d);
        return std::sqrt(P*P - tanPhi()*tanPhi());
    }
};


//- Mean velocity of the middle over g sin(b) t, for strength divided by F
double acceleration
(
    const Slope& slope,
    const bool associated,
    const double F,
    const int cells
)
{
    using namespace verification;

    const double b = degree*slope.beta;
    const double length = 28*slip;

    mpm::Settings settings;
    settings.cellSize = slip/cells;
    settings.gravity = {{gravity*std::sin(b), -gravity*std::cos(b), 0}};

    mpm::PointData points = seed
    (
        2,
        settings.cellSize,
        2,
        {{-0.5*length, 0, 0}},
        {{0.5*length, depth, 0}},
        [](const mpm::Point3&) { return true; },
        rho
    );

    const double reducedPhi = std::atan(slope.tanPhi()/F);
    for (const mpm::Point3& x : points.position)
    {
        const double d = depth - x[1];
        const double normal = rho*gravity*d*std::cos(b);
        const double shear = rho*gravity*d*std::sin(b);
        const double cf = slope.intercept(d);

        // Compression along the ground: Mohr's circle touches its envelope
        // where the ground's direction is (associated), or is centred on the
        // normal stress (without dilation), so that F = FS is just reached
        const double apex = cf/slope.tanPhi();
        const double along =
            associated ? normal + 2*shear*shear/(normal + apex) : normal;

        points.cohesionIntercept.push_back(cf/F);
        points.frictionAngle.push_back(reducedPhi/degree);
        points.porePressure.push_back(slope.porePressure(d));
        points.sigma.push_back
        (
            {{-along, -normal, -0.5*(along + normal), shear, 0, 0}}
        );
    }

    mpm::Material soil;
    soil.E = 5e6;
    soil.nu = 0.3;
    soil.dilationAngle = associated ? reducedPhi/degree : 0;

    auto run = mpm::Run::New
    (
        2,
        settings,
        points,
        {soil},
        {
            plane("base", "rough", {{0, 0, 0}}, {{0, 1, 0}}),
            plane("upper", "rough", {{-0.5*length, 0, 0}}, {{1, 0, 0}}),
            plane("lower", "rough", {{0.5*length, 0, 0}}, {{-1, 0, 0}})
        }
    );

    // Waves from the ends reach the watched middle fifth later
    const double waveSpeed = std::sqrt(soil.constrainedModulus()/rho);
    const double endTime = 0.9*0.4*length/waveSpeed;
    run->advance(endTime);

    const std::vector<double> velocity = run->field("velocity");
    double sum = 0;
    long n = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const mpm::Point3& x = points.position[i];
        if (std::fabs(x[0]) < 0.1*length && depth - x[1] < slip)
        {
            sum += velocity[3*i];
            ++n;
        }
    }
    return sum/n/(gravity*std::sin(b)*endTime);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void verification::infiniteSlope(Checks& checks, const bool longVersion)
{
    const Slope slopes[] =
    {
        {"dry", 30, 25, 12e3, false, 0},
        {"table inside", 25, 35, 6e3, true, 1.5}
    };
    const int cells = longVersion ? 32 : 16;

    for (const Slope& slope : slopes)
    {
        for (const bool associated : {true, false})
        {
            const double critical = slope.criticalDepth();
            const double exact =
                associated
              ? slope.planeFactor(critical)
              : slope.planeFactorWithoutDilation(critical);
            const std::string name =
                slope.name
              + (associated ? ", associated: " : ", without dilation: ");

            if (slope.wet)
            {
                checks.within
                (
                    name + "cf' at the slip surface [Pa]",
                    slope.intercept(critical),
                    -1e5,
                    -1e4,
                    "negative: the case must see its sign"
                );
                checks.report
                (
                    name + "FS if cf' were clamped at 0, associated",
                    slope.tanPhi()/std::tan(degree*slope.beta)
                );
            }

            checks.less
            (
                name + "acceleration over g sin(b) at F = 0.98 FS",
                acceleration(slope, associated, 0.98*exact, cells),
                5e-3,
                "stands: elastic waves of the start's equilibrium of nodes"
            );

            const double F1 = 1.02*exact, F2 = 1.05*exact;
            const double a1 = acceleration(slope, associated, F1, cells);
            const double a2 = acceleration(slope, associated, F2, cells);
            checks.within
            (
                name + "acceleration over g sin(b) at F = 1.05 FS",
                a2,
                0.02,
                0.05,
                "1 - 1/1.05 = 0.048 if the slip surface were sharp"
            );
            checks.less
            (
                name + "relative error of FS = " + std::to_string(exact),
                (F1 - a1*(F2 - F1)/(a2 - a1))/exact - 1,
                0.02,
                "the slip layer is some cells of 1/16 of the depth thick, in "
                "which the plane's factor varies by 2 %"
            );
        }
    }
}

// ************************************************************************* //
