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

#include "integralUpwind.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace richardsFluxes
{
    defineTypeNameAndDebug(integralUpwind, 0);
    addToRunTimeSelectionTable(richardsFlux, integralUpwind, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::integralUpwind::downward
(
    const label,
    const frontFluxTable::weights&,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    flux result;
    result.value = drop*upper.K + upper.Phi - lower.Phi;
    result.dFirst = drop*upper.dK + upper.dPhi;
    result.dSecond = -lower.dPhi;
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::richardsFluxes::integralUpwind::integralUpwind
(
    const PtrList<soilTable>& tables
)
:
    richardsFlux(tables)
{}

// ************************************************************************* //
