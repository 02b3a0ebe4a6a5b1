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

#include "uniformRain.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::uniformRain::uniformRain
(
    const word& entryName,
    const dictionary& dict
)
:
    rate_(entryName, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::uniformRain::addDepth
(
    const scalar t1,
    const scalar t2,
    UList<scalar>& depths
) const
{
    const scalar added = depth(t1, t2);

    for (scalar& d : depths)
    {
        d += added;
    }
}


Foam::rainfall::record Foam::uniformRain::recorded() const
{
    record result;

    if (const Function1Types::hyetograph* hyetograph = rate_.hyetograph())
    {
        result.given = true;
        result.begin = hyetograph->start();
        result.end = hyetograph->end();
        result.depth = hyetograph->recorded();
    }

    return result;
}

// ************************************************************************* //
