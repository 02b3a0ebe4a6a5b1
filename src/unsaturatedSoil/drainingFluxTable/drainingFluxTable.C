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

#include "drainingFluxTable.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::drainingFluxTable::logSlope(const soilTable& table)
{
    // By so much the slope between two nodes may exceed that in an interval
    const scalar excess = 1.1;

    const scalarList& head = table.heads();
    const scalarList& K = table.K();
    const label last = table.nNodes() - 1;

    // The least in the interval that begins at a node: at its wet end
    const auto least = [&](const label i)
    {
        return (K[i] - K[i + 1])/(head[i] - head[i + 1])/K[i];
    };

    scalarList slope(last + 1);

    for (label i = 1; i < last; ++i)
    {
        slope[i] = min
        (
            std::log(K[i - 1]/K[i + 1])/(head[i - 1] - head[i + 1]),
            excess*min(least(i - 1), least(i))
        );
    }

    slope[0] = 0;
    slope[last] = least(last - 1);

    return slope;
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::drainingFluxTable::profile
(
    const scalar P,
    const scalar a,
    scalar& f,
    scalar& dfdP,
    scalar& dfda
)
{
    // Below it the series' first terms are exact to 1e-7, above it the
    // differences keep eight digits
    const scalar small = 1e-4;

    if (P < small)
    {
        const scalar b = 1 - a;

        f = a*(1 + P*b*(0.5 + P*(1 - 2*a)/12));
        dfdP = a*b*(0.5 + P*(1 - 2*a)/6);
        dfda = 1 + 0.5*P*(1 - 2*a);
    }
    else
    {
        const scalar whole = -std::expm1(-P);
        const scalar part = -std::expm1(-P*a);

        f = part/whole;
        dfdP = (a*(1 - part)*whole - part*(1 - whole))/sqr(whole);
        dfda = P*(1 - part)/whole;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::drainingFluxTable::drainingFluxTable
(
    const soilTable& table,
    const UList<scalar>& D
)
:
    table_(table),
    decay_(D.size())
{
    const scalarList slope(logSlope(table));
    const scalarList& head = table.heads();

    forAll(decay_, i)
    {
        scalarList& k = decay_[i];
        k.resize(slope.size());
        k[0] = 0;

        for (label j = 1; j < k.size(); ++j)
        {
            const scalar P = k[j - 1]*D[i];
            const scalar steepest = (6 + P*(3 + 1.5*P))/sqr(D[i]);

            k[j] = min(slope[j], k[j - 1] + steepest*(head[j - 1] - head[j]));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::drainingFluxTable::decay
(
    const frontFluxTable::weights& w,
    const soilTable::state& s,
    scalar& k,
    scalar& dk
) const
{
    k = 0;
    dk = 0;

    const label i = w.upper > 0 ? w.lower + 1 : w.lower;

    if (s.interval < 0 || i < 0)
    {
        return;
    }

    const scalarList& decays = decay_[i];

    if (s.interval == decays.size() - 1)
    {
        k = decays.last();
        return;
    }

    const label j = s.interval;
    const scalarList& head = table_.heads();
    const scalar slope = (decays[j + 1] - decays[j])/(head[j + 1] - head[j]);

    k = decays[j] + slope*(s.head - head[j]);
    dk = slope*s.dHead;
}


void Foam::drainingFluxTable::evaluate
(
    const frontFluxTable::weights& w,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower,
    scalar& value,
    scalar& dUpper,
    scalar& dLower
) const
{
    scalar k, dk;
    decay(w, upper, k, dk);

    const scalar a = 1 - (lower.head - upper.head)/drop;
    scalar f, dfdP, dfda;
    profile(k*drop, a, f, dfdP, dfda);

    value = drop*upper.K*f;
    dUpper =
        drop*(upper.dK*f + upper.K*dfdP*drop*dk)
      + upper.K*dfda*upper.dHead;
    dLower = -upper.K*dfda*lower.dHead;
}

// ************************************************************************* //
