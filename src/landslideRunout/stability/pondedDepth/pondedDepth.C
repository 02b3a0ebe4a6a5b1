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

#include "pondedDepth.H"
#include "areaFields.H"
#include "fvMesh.H"
#include "localIOdictionary.H"
#include "Time.H"

// * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * * //

namespace Foam
{

static Map<scalar> byFace(const labelUList& faces, const UList<scalar>& values)
{
    Map<scalar> result(2*faces.size());
    forAll(faces, i)
    {
        result.insert(faces[i], values[i]);
    }

    return result;
}

} // End namespace Foam

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::Map<Foam::scalar> Foam::pondedDepth
(
    const fvMesh& mesh,
    const word& name
)
{
    if (mesh.foundObject<areaScalarField>(name))
    {
        const areaScalarField& h = mesh.lookupObject<areaScalarField>(name);

        return byFace(h.mesh().faceLabels(), h);
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

    if (!returnReduce(io.typeHeaderOk<areaScalarField>(true), andOp<bool>()))
    {
        return Map<scalar>();
    }

    const faMesh aMesh(mesh);
    const localIOdictionary dict(io, areaScalarField::typeName);

    return byFace
    (
        aMesh.faceLabels(),
        scalarField("internalField", dict, aMesh.nFaces())
    );
}

// ************************************************************************* //
