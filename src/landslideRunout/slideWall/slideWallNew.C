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

#include "slideWall.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::slideWall> Foam::slideWall::New
(
    const word& name,
    const dictionary& dict
)
{
    if (dict.isDict("type"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' of " << dict.name()
            << " is a dictionary, and has to be a value"
            << exit(FatalIOError);
    }

    const word type(dict.get<word>("type"));

    const auto it = dictionaryConstructorTablePtr_->cfind(type);

    if (!it.good())
    {
        FatalIOErrorInLookup
        (
            dict,
            "slideWall",
            type,
            *dictionaryConstructorTablePtr_
        )   << exit(FatalIOError);
    }

    return autoPtr<slideWall>(it.val()(name, dict));
}

// ************************************************************************* //
