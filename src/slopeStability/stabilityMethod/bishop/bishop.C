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

#include "bishop.H"
#include "rootOf.H"

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

slopeStability::equilibrium slopeStability::bishop::solve
(
    const slipMass& mass
) const
{
    // A mass whose weights all but balance about the centre has no meaningful
    // factor of safety
    if (mass.driving() <= 1e-6*mass.weight())
    {
        return {0, 0, verdict::notDriven};
    }

    const double start = fellenius(mass);
    if (start <= 0)
    {
        return {0, 0, verdict::noStrength};
    }

    const auto resisted = [&](const double F)
    {
        double strength = 0;
        for (const slice& s : mass.slices())
        {
            strength += std::max
            (
                0.0,
                (s.cohesion*s.cosAlpha + s.weight*s.tanPhi)/mAlpha(s, F)
            );
        }
        return strength/mass.driving();
    };

    const double next = resisted(start);
    if (next <= 0)
    {
        return {0, 0, verdict::noStrength};
    }

    const std::optional<double> F = rootOf
    (
        [&](const double value) { return resisted(value) - value; },
        start,
        next,
        0.1*start,
        100*start,
        tolerance*start
    );

    if (!F)
    {
        return {0, 0, verdict::notConverged};
    }

    return
    {
        *F,
        0,
        admissible(mass, *F) ? verdict::converged : verdict::steepExit
    };
}


// ************************************************************************* //
