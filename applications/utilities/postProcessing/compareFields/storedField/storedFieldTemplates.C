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

#include "storedField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::Field<Type> Foam::storedField::values(const label size) const
{
    const token first(dict_->lookup("internalField").first());
    const bool uniform = first.isWord() && first.wordToken() == "uniform";

    if (!uniform)
    {
        // How many there are, before a constructor complains in general terms
        ITstream& stream = dict_->lookup("internalField");
        label stored = -1;

        if
        (
            stream.size() > 1
         && stream[1].isCompound()
        )
        {
            stored = stream[1].compoundToken().size();
        }

        if (stored != size)
        {
            FatalIOErrorInFunction(*dict_)
                << "The file " << path_ << " holds " << stored
                << " values, the mesh has " << size << " elements"
                << exit(FatalIOError);
        }
    }

    return Field<Type>("internalField", *dict_, size);
}


// ************************************************************************* //
