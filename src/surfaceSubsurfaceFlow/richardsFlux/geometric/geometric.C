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

#include "geometric.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace richardsFluxes
{
    defineTypeNameAndDebug(geometric, 0);
    addToRunTimeSelectionTable(richardsFlux, geometric, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::richardsFlux::flux Foam::richardsFluxes::geometric::downward
(
    const label,
    const frontFluxTable::weights&,
    const scalar drop,
    const soilTable::state& upper,
    const soilTable::state& lower
) const
{
    const scalar K = std::sqrt(upper.K*lower.K);

    return ofMean
    (
        K,
        0.5*K*upper.dK/upper.K,
        0.5*K*lower.dK/lower.K,
        drop,
        upper,
        lower
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::richardsFluxes::geometric::geometric(const PtrList<soilTable>& tables)
:
    richardsFlux(tables)
{}

// ************************************************************************* //
