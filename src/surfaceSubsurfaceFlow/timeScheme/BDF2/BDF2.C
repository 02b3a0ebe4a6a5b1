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

#include "BDF2.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace timeSchemes
{
    defineTypeNameAndDebug(BDF2, 0);
    addToRunTimeSelectionTable(timeScheme, BDF2, dictionary);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::timeSchemes::BDF2::carry(const scalar ratio) const
{
    return sqr(ratio)/(1 + 2*ratio);
}


Foam::FixedList<Foam::scalar, 3> Foam::timeSchemes::BDF2::errorWeights
(
    const FixedList<scalar, 3>& lengths
) const
{
    const scalar dt = lengths[0];
    const scalar r = dt/lengths[1];

    // Third divided difference of W, a sixth of the third derivative
    const scalar all = dt + lengths[1] + lengths[2];
    const scalar first = 1/(all*(dt + lengths[1]));
    const scalar second = 1/(all*(lengths[1] + lengths[2]));

    const scalar w = pow3(dt)*sqr(1 + r)/(r*(1 + 2*r));

    return FixedList<scalar, 3>
    (
        {w*first, -w*(first + second), w*second}
    );
}

// ************************************************************************* //
