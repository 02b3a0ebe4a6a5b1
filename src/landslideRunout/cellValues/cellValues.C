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

#include "cellValues.H"
#include "localIOdictionary.H"
#include "Time.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::cellValues(const fvMesh& mesh, const word& name)
{
    if (mesh.foundObject<volScalarField>(name))
    {
        return mesh.lookupObject<volScalarField>(name).primitiveField();
    }

    IOobject io
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!returnReduce(io.typeHeaderOk<volScalarField>(true), andOp<bool>()))
    {
        FatalErrorInFunction
            << "The scalar field " << name
            << " is neither registered nor in the file "
            << mesh.time().timePath()/name << nl
            << "    Fields of the mesh: "
            << flatOutput(mesh.sortedNames<volScalarField>())
            << exit(FatalError);
    }

    const localIOdictionary dict(io, volScalarField::typeName);

    return scalarField("internalField", dict, mesh.nCells());
}

// ************************************************************************* //
