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

#include "interslice.H"
#include "bishop.H"
#include "rootOf.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

std::vector<double> slopeStability::interslice::inclinations
(
    const slipMass& mass
) const
{
    std::vector<double> f;
    f.reserve(mass.slices().size());
    for (const slice& s : mass.slices())
    {
        f.push_back(inclination(s.lowerSide));
    }

    return f;
}


slopeStability::interslice::imbalance slopeStability::interslice::march
(
    const slipMass& mass,
    const std::vector<double>& f,
    const double F,
    const double lambda
)
{
    // Where inclined forces would push a slice off its base without bound
    const double minDenominator = 0.05;

    double E = 0;
    double X = 0;
    double strength = 0;
    bool unbounded = false;

    for (std::size_t i = 0; i < f.size(); ++i)
    {
        const slice& s = mass.slices()[i];

        double cohesion = s.cohesion/F;
        double friction = s.tanPhi/F;
        double m = mAlpha(s, F);
        const double before = E;
        double shear = 0;

        // A second time without strength if it came out negative
        for (const bool strong : {true, false})
        {
            if (!strong)
            {
                cohesion = 0;
                friction = 0;
                m = s.cosAlpha;
            }
            const double k = (s.sinAlpha - s.cosAlpha*friction)/m;
            const double vertical = s.weight - cohesion*s.sinAlpha + X;

            const double denominator = 1 + k*lambda*f[i];

            E =
                (before + s.thrust - cohesion*s.cosAlpha + k*vertical)
               /std::max(minDenominator, denominator);
            unbounded = unbounded || denominator < minDenominator;

            const double N = (vertical - lambda*f[i]*E)/m;
            shear = cohesion + N*friction;
            if (shear >= 0)
            {
                break;
            }
        }

        X = lambda*f[i]*E;
        strength += std::max(0.0, shear);
    }

    return {E, mass.driving() - strength, unbounded};
}


std::optional<double> slopeStability::interslice::balanced
(
    const slipMass& mass,
    const std::vector<double>& f,
    const double lambda,
    double imbalance::* part,
    const double start,
    const double lowest,
    const double highest
)
{
    return rootOf
    (
        [&](const double F)
        {
            return march(mass, f, F, lambda).*part;
        },
        start,
        1.02*start,
        lowest,
        highest,
        tolerance*start
    );
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

slopeStability::equilibrium slopeStability::interslice::solve
(
    const slipMass& mass
) const
{
    const equilibrium start = bishop().solve(mass);
    if (start.outcome != verdict::converged)
    {
        return start;
    }

    const std::vector<double> f = inclinations(mass);

    // Away from the solution the F of the forces may be far off
    const double lowest = 0.2*start.FOS;
    const double highest = 20*start.FOS;

    // Each lambda starts from the F of the one before
    double moments = start.FOS;
    double forces = start.FOS;
    bool found = true;

    const auto difference = [&](const double lambda)
    {
        const auto balance = [&](double imbalance::* part, const double from)
        {
            return balanced(mass, f, lambda, part, from, lowest, highest);
        };
        const std::optional<double> m = balance(&imbalance::moment, moments);
        const std::optional<double> e = balance(&imbalance::force, forces);

        found = m && e;
        if (!found)
        {
            return 0.0;
        }
        moments = *m;
        forces = *e;

        const double d = forces - moments;
        return std::abs(d) <= 10*tolerance*start.FOS ? 0.0 : d;
    };

    // Forces between slices are not steeper than about 60 deg either way
    const double steepest = 2;
    const std::optional<double> lambda =
        rootOf(difference, 0, 0.3, -steepest, steepest, 1e-12);

    // How far a physical solution may be from Bishop's
    const double apart = 2;

    if
    (
        !found
     || !lambda
     || moments > apart*start.FOS
     || start.FOS > apart*moments
     || march(mass, f, moments, *lambda).unbounded
    )
    {
        return {0, 0, verdict::notConverged};
    }

    return
    {
        moments,
        *lambda,
        admissible(mass, moments) ? verdict::converged : verdict::steepExit
    };
}


// ************************************************************************* //
