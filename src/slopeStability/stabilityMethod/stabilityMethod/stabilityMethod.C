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

#include "stabilityMethod.H"

#include <algorithm>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

const char* slopeStability::verdictName(const verdict v)
{
    switch (v)
    {
        case verdict::converged:
            return "converged";
        case verdict::notDriven:
            return "notDriven";
        case verdict::noStrength:
            return "noStrength";
        case verdict::steepExit:
            return "steepExit";
        default:
            return "notConverged";
    }
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

double slopeStability::stabilityMethod::mAlpha(const slice& s, const double F)
{
    const double m = s.cosAlpha + s.sinAlpha*s.tanPhi/F;

    return s.sinAlpha < 0 ? std::max(m, minMAlpha) : m;
}


bool slopeStability::stabilityMethod::admissible
(
    const slipMass& mass,
    const double F
)
{
    for (const slice& s : mass.slices())
    {
        if
        (
            s.sinAlpha < 0
         && s.cosAlpha + s.sinAlpha*s.tanPhi/F < minMAlpha
        )
        {
            return false;
        }
    }

    return true;
}


double slopeStability::stabilityMethod::fellenius(const slipMass& mass)
{
    double strength = 0;
    for (const slice& s : mass.slices())
    {
        const double N = s.weight*s.cosAlpha - s.thrust*s.sinAlpha;
        strength += std::max(0.0, s.cohesion + N*s.tanPhi);
    }

    return strength/mass.driving();
}


// ************************************************************************* //
