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

#include "linearReconstruction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::List<Type> Foam::linearReconstruction::distributed
(
    const UList<Type>& cellValues
) const
{
    List<Type> values(map_->constructSize(), Zero);

    forAll(cellValues, celli)
    {
        values[celli] = cellValues[celli];
    }

    map_->distribute(values);

    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::linearReconstruction::values
(
    const UList<Type>& cellValues,
    const labelUList& cellIndex,
    const UList<vector>& displacement
) const
{
    const List<Type> all(distributed(cellValues));

    auto tresult = tmp<Field<Type>>::New(cellIndex.size(), Zero);
    auto& result = tresult.ref();

    forAll(result, pointi)
    {
        const label i = cellIndex[pointi];
        const Type& own = cellValues[cells_[i]];

        result[pointi] = own;

        forAll(neighbours_[i], j)
        {
            result[pointi] +=
                (coefficients_[i][j] & displacement[pointi])
               *(all[neighbours_[i][j]] - own);
        }
    }

    return tresult;
}

// ************************************************************************* //
