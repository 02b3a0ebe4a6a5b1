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
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::storedField::storedField
(
    const word& name,
    const fileName& folder,
    const objectRegistry& registry
)
:
    path_(folder/name)
{
    IOobject io
    (
        name,
        folder,
        registry,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    // Any vol or area field is looked for in the same, local way
    if (!io.typeHeaderOk<volScalarField>(false))
    {
        FatalErrorInFunction
            << "Cannot read field " << name << ": there is no readable file "
            << path_ << nl
            << "    Files in that folder: "
            << flatOutput(readDir(folder, fileName::FILE))
            << exit(FatalError);
    }

    className_ = io.headerClassName();
    dict_.reset(new localIOdictionary(io, className_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dimensionSet Foam::storedField::dimensions() const
{
    return dimensionSet(dict_->lookup("dimensions"));
}


// ************************************************************************* //
