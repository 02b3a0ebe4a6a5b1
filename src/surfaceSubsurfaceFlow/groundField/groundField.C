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

#include "groundField.H"
#include "readChecked.H"
#include "areaFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The entry is the word field
static bool isField(const dictionary& dict, const word& key)
{
    ITstream& is = dict.lookup(key);

    return is.size() == 1 && is.first().isWord()
     && is.first().wordToken() == "field";
}


//- The area field of a name, from the newest time that has it
static tmp<scalarField> storedField
(
    const faMesh& aMesh,
    const dictionary& dict,
    const word& key,
    const std::function<bool(scalar)>& valid,
    const string& range
)
{
    const areaScalarField field
    (
        IOobject
        (
            key,
            aMesh.time().findInstance(fileName::null, key),
            aMesh.thisDb(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        aMesh
    );

    forAll(field, i)
    {
        if (!std::isfinite(field[i]) || !valid(field[i]))
        {
            FatalIOErrorInFunction(dict)
                << "Area field " << field.objectPath() << " is " << field[i]
                << " at " << aMesh.areaCentres()[i]
                << ", outside its range: " << range.c_str()
                << exit(FatalIOError);
        }
    }

    return tmp<scalarField>::New(field.primitiveField());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::facesInZone
(
    const polyMesh& mesh,
    const labelUList& faces,
    const word& zoneName,
    const dictionary& dict
)
{
    const label faceZonei = mesh.faceZones().findZoneID(zoneName);
    const label cellZonei = mesh.cellZones().findZoneID(zoneName);

    if (faceZonei < 0 && cellZonei < 0)
    {
        FatalIOErrorInFunction(dict)
            << "No faceZone or cellZone " << zoneName
            << "; the mesh has the faceZones " << mesh.faceZones().names()
            << " and the cellZones " << mesh.cellZones().names()
            << exit(FatalIOError);
    }

    boolList inside(faces.size());

    forAll(faces, i)
    {
        inside[i] =
            faceZonei >= 0
          ? mesh.faceZones()[faceZonei].whichFace(faces[i]) >= 0
          : mesh.cellZones()[cellZonei].whichCell
            (
                mesh.faceOwner()[faces[i]]
            ) >= 0;
    }

    return inside;
}


Foam::tmp<Foam::scalarField> Foam::readGroundField
(
    const faMesh& aMesh,
    const dictionary& dict,
    const word& key,
    const std::function<bool(scalar)>& valid,
    const string& range
)
{
    auto tfield =
        isField(dict, key)
      ? storedField(aMesh, dict, key, valid, range)
      : tmp<scalarField>::New
        (
            aMesh.nFaces(),
            readChecked(dict, key, valid, range)
        );

    const dictionary& zones = dict.subOrEmptyDict(key + "Zones");

    for (const word& zoneName : zones.toc())
    {
        const scalar value = readChecked(zones, zoneName, valid, range);
        const boolList inside
        (
            facesInZone(aMesh.mesh(), aMesh.faceLabels(), zoneName, zones)
        );

        forAll(inside, i)
        {
            if (inside[i])
            {
                tfield.ref()[i] = value;
            }
        }
    }

    return tfield;
}

// ************************************************************************* //
