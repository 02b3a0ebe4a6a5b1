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

#include "richardsFlux.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(richardsFlux, 0);
    defineRunTimeSelectionTable(richardsFlux, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFlux::acrossSoils
(
    const connection& c,
    const soilTable::state& first,
    const soilTable::state& second
) const
{
    const scalar dH = c.drop + first.head - second.head;
    const bool forward = (dH >= 0);
    const soilTable::state& upwind = forward ? first : second;
    const scalar factor =
        c.transmissibility/tables_[forward ? c.soil1 : c.soil2].Ks();

    flux result
    (
        ofMean
        (
            factor*upwind.K,
            forward ? factor*upwind.dK : 0,
            forward ? 0 : factor*upwind.dK,
            c.drop,
            first,
            second
        )
    );

    // The conductivity alone acts on the heads
    result.scale =
        factor*upwind.K*mag(c.drop)
      + mag(result.dFirst)*reach(first)
      + mag(result.dSecond)*reach(second);

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::richardsFlux::richardsFlux(const PtrList<soilTable>& tables)
:
    tables_(tables)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::richardsFlux::prepare(List<connection>&, const UList<interface>&)
{}


Foam::richardsFlux::flux Foam::richardsFlux::operator()
(
    const connection& c,
    const soilTable::state& first,
    const soilTable::state& second
) const
{
    return
        c.soil1 == c.soil2
      ? along(c.soil1, c, first, second)
      : acrossSoils(c, first, second);
}

// ************************************************************************* //
