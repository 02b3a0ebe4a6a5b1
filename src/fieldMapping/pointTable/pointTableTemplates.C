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

#include "pointTable.H"
#include "error.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::pointTable::add(const word& name, const UList<Type>& values)
{
    if (values.size() != points_.size())
    {
        FatalErrorInFunction
            << "Column " << name << " has " << values.size()
            << " values for " << points_.size() << " points"
            << exit(FatalError);
    }

    const direction nComponents = pTraits<Type>::nComponents;

    column c;
    c.name = name;
    c.components.setSize(nComponents);
    c.values.setSize(nComponents*values.size());

    for (direction cmpt = 0; cmpt < nComponents; ++cmpt)
    {
        if (nComponents > 1)
        {
            c.components[cmpt] = pTraits<Type>::componentNames[cmpt];
        }

        forAll(values, pointi)
        {
            c.values[pointi*nComponents + cmpt] =
                component(values[pointi], cmpt);
        }
    }

    columns_.append(c);
}

// ************************************************************************* //
