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

#include "monotone.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::richardsFluxes::monotone::faceState::excess() const
{
    return to.value - from.value;
}


Foam::scalar Foam::richardsFluxes::monotone::faceState::dExcess() const
{
    return to.dSecond/first.dHead - from.dFirst/second.dHead;
}


void Foam::richardsFluxes::monotone::evaluate
(
    const connection& c,
    const soilTable::state& first,
    const soilTable::state& second,
    const bool bySecond,
    const scalar tau,
    faceState& face
) const
{
    const soilTable& table1 = tables_[c.soil1];
    const soilTable& table2 = tables_[c.soil2];

    if (bySecond)
    {
        table2.evaluate(tau, face.second);
        table1.evaluate(table1.tauOfHead(face.second.head), face.first);
    }
    else
    {
        table1.evaluate(tau, face.first);
        table2.evaluate(table2.tauOfHead(face.first.head), face.second);
    }

    const interface& sides = interfaces_[c.interface];

    face.to = along(c.soil1, sides.first, first, face.first);
    face.from = along(c.soil2, sides.second, face.second, second);
}


void Foam::richardsFluxes::monotone::solve
(
    const connection& c,
    const soilTable::state& first,
    const soilTable::state& second,
    faceState& face
) const
{
    const label maxIterations = 200;

    // A few roundings of each of the parts
    const scalar roundOff = 8*std::numeric_limits<scalar>::epsilon();

    const interface& sides = interfaces_[c.interface];

    // K of the soil below the face acts on gravity there: in its unknown the
    // excess is the smoother function
    const bool bySecond = c.drop >= 0;
    const soilTable& table = tables_[bySecond ? c.soil2 : c.soil1];

    // Between the heads at rest with either side the excess changes its sign
    const scalar h1 = first.head + sides.first.drop;
    const scalar h2 = second.head - sides.second.drop;
    scalar dry = table.tauOfHead(min(h1, h2));
    scalar wet = table.tauOfHead(max(h1, h2));

    const scalar T1 = sides.first.transmissibility*first.K;
    const scalar T2 = sides.second.transmissibility*second.K;
    const scalar share = T1/max(T1 + T2, VSMALL);

    scalar tau = table.tauOfHead(share*h1 + (1 - share)*h2);
    scalar lastExcess = GREAT;
    bool newton = true;

    for (label iteration = 0; iteration < maxIterations; ++iteration)
    {
        evaluate(c, first, second, bySecond, tau, face);

        const scalar excess = face.excess();

        if (mag(excess) <= roundOff*(face.to.scale + face.from.scale))
        {
            return;
        }

        (excess > 0 ? dry : wet) = tau;

        // Newton's step while it stays inside and converges, else the middle
        const scalar slope =
            face.dExcess()*(bySecond ? face.second : face.first).dHead;
        const bool slow = newton && mag(excess) > 0.5*lastExcess;

        scalar next = tau - excess/min(slope, -VSMALL);
        newton = next > dry && next < wet && !slow;

        if (!newton)
        {
            next = 0.5*(dry + wet);
        }

        // Nothing lies between
        if (next == tau || next == dry || next == wet)
        {
            return;
        }

        lastExcess = mag(excess);
        tau = next;
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::monotone::acrossSoils
(
    const connection& c,
    const soilTable::state& first,
    const soilTable::state& second
) const
{
    faceState face;
    solve(c, first, second, face);

    // Conductances of both sides to the head on the face
    const scalar to = -face.to.dSecond/face.first.dHead;
    const scalar from = face.from.dFirst/face.second.dHead;
    const scalar sum = to + from;

    flux result;

    if (sum > VSMALL)
    {
        // As after one more iteration of Newton's method
        const scalar share = from/sum;

        result.value = share*face.to.value + (1 - share)*face.from.value;
        result.dFirst = share*face.to.dFirst;
        result.dSecond = (1 - share)*face.from.dSecond;
        result.scale = share*face.to.scale + (1 - share)*face.from.scale;
    }

    return result;
}

// ************************************************************************* //
