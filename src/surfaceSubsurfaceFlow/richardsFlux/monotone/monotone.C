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
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace richardsFluxes
{
    defineTypeNameAndDebug(monotone, 0);
    addToRunTimeSelectionTable(richardsFlux, monotone, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::monotone::front
(
    const connection& c,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    const frontFluxTable& table = fronts_[c.soil1];

    flux result;
    result.value =
        drop*upper.K + table.beta(upper, c.weights)
      - table.beta(lower, c.weights);
    result.dFirst = drop*upper.dK + table.B(upper, c.weights)*upper.dPhi;
    result.dSecond = -table.B(lower, c.weights)*lower.dPhi;
    return result;
}


Foam::richardsFlux::flux Foam::richardsFluxes::monotone::draining
(
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    const scalar dH = drop + upper.head - lower.head;

    flux result;
    result.value = upper.K*dH;
    result.dFirst = upper.dK*dH + upper.K*upper.dHead;
    result.dSecond = -upper.K*lower.dHead;
    return result;
}


Foam::richardsFlux::flux Foam::richardsFluxes::monotone::rising
(
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    // Below this relative difference of the heads the quotient of the
    // differences has lost half its digits
    const scalar cancellation = 1e-5;

    const scalar dh = lower.head - upper.head;
    const scalar dH = drop - dh;

    flux result;

    if (dh > cancellation*(mag(lower.head) + mag(upper.head)))
    {
        const scalar K = (lower.Phi - upper.Phi)/dh;

        result.value = K*dH;
        result.dFirst = upper.dPhi + drop*(K - upper.K)*upper.dHead/dh;
        result.dSecond = -lower.dPhi + drop*(lower.K - K)*lower.dHead/dh;
    }
    else
    {
        const scalar K = 0.5*(lower.K + upper.K);

        result.value = K*dH;
        result.dFirst = K*upper.dHead + 0.5*upper.dK*dH;
        result.dSecond = -K*lower.dHead + 0.5*lower.dK*dH;
    }

    return result;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::monotone::downward
(
    const connection& c,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    const scalar dh = lower.head - upper.head;

    if (dh <= 0)
    {
        return front(c, drop, upper, lower);
    }

    return dh < drop ? draining(drop, upper, lower)
                     : rising(drop, upper, lower);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::richardsFluxes::monotone::monotone(const PtrList<soilTable>& tables)
:
    richardsFlux(tables),
    fronts_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::richardsFluxes::monotone::prepare(List<connection>& connections)
{
    scalarList drops(connections.size());
    forAll(connections, i)
    {
        drops[i] = mag(connections[i].drop);
    }

    const scalarList nodes(frontFluxTable::nodes(drops));

    fronts_.clear();
    for (const soilTable& table : tables_)
    {
        fronts_.append(new frontFluxTable(table, nodes));
    }

    forAll(connections, i)
    {
        connection& c = connections[i];
        c.weights = fronts_[c.soil1].weightsOf(drops[i]);
    }
}

// ************************************************************************* //
