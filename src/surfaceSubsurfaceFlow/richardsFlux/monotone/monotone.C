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
#include "integralMean.H"
#include "DynamicList.H"
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
    const frontFluxTable& table,
    const frontFluxTable::weights& weights,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    flux result;
    result.value =
        drop*upper.K + table.beta(upper, weights) - table.beta(lower, weights);
    result.dFirst = drop*upper.dK + table.B(upper, weights)*upper.dPhi;
    result.dSecond = -table.B(lower, weights)*lower.dPhi;
    return result;
}


void Foam::richardsFluxes::monotone::setWeights
(
    const label soili,
    path& p
) const
{
    p.weights = fronts_[soili].weightsOf(mag(p.drop));
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::monotone::downward
(
    const label soili,
    const frontFluxTable::weights& weights,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    const scalar dh = lower.head - upper.head;

    if (dh <= 0)
    {
        return front(fronts_[soili], weights, drop, upper, lower);
    }

    if (dh >= drop)
    {
        return integralMean::ofIntegral(drop, upper, lower);
    }

    flux result;
    draining_[soili].evaluate
    (
        weights,
        drop,
        upper,
        lower,
        result.value,
        result.dFirst,
        result.dSecond
    );
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::richardsFluxes::monotone::monotone(const PtrList<soilTable>& tables)
:
    richardsFlux(tables),
    fronts_(),
    draining_(),
    interfaces_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::richardsFluxes::monotone::prepare
(
    List<connection>& connections,
    const UList<interface>& interfaces
)
{
    interfaces_ = interfaces;

    DynamicList<scalar> drops(connections.size() + interfaces.size());

    for (const connection& c : connections)
    {
        if (c.interface >= 0)
        {
            drops.append(mag(interfaces_[c.interface].first.drop));
            drops.append(mag(interfaces_[c.interface].second.drop));
        }
        else
        {
            drops.append(mag(c.drop));
        }
    }

    const scalarList nodes(frontFluxTable::nodes(drops));

    fronts_.clear();
    draining_.clear();
    for (const soilTable& table : tables_)
    {
        fronts_.append(new frontFluxTable(table, nodes));
        draining_.append(new drainingFluxTable(table, nodes));
    }

    for (connection& c : connections)
    {
        if (c.interface >= 0)
        {
            setWeights(c.soil1, interfaces_[c.interface].first);
            setWeights(c.soil2, interfaces_[c.interface].second);
        }
        else
        {
            setWeights(c.soil1, c);
        }
    }
}

// ************************************************************************* //
