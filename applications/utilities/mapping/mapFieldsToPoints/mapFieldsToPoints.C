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

Application
    mapFieldsToPoints

Description
    Writes the values of volume fields at the points of a section or a cloud to
    postProcessing/mapFieldsToPoints/<time>/points.<format>, for the times that
    are selected. Fields that are linear in space are reproduced exactly.

Usage
    \b mapFieldsToPoints [OPTION]

    From \c system/mapFieldsToPointsDict:
    \verbatim
    fields          (psi theta);

    points
    {
        type            section;    // or cloud
        section
        {
            origin          (0 0 0);
            direction       (1 0 0);
        }
        spacing         0.5;
    }

    outside         error;          // or nearest, value
    outsideValues
    {
        psi             -10;        // with outside value: of every field
        theta           0.1;
    }

    format          vtp;            // or csv, raw
    \endverbatim

    Sample runs:
    \verbatim
    mapFieldsToPoints -latestTime
    mpirun -np 2 mapFieldsToPoints -parallel -time 3600
    mapFieldsToPoints -dict system/gauges
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "fieldToPointMapping.H"
#include "pointSetWriter.H"
#include "pointSource.H"
#include "pointTable.H"
#include "readChecked.H"
#include "selectedTimes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

// Add the field to the table if it is of this type and there
template<class Type>
bool addField
(
    const IOobject& io,
    const fvMesh& mesh,
    const fieldToPointMapping& mapping,
    const dictionary& dict,
    const outsidePolicy& policy,
    pointTable& table
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    if (io.headerClassName() != fieldType::typeName)
    {
        return false;
    }

    const fieldType field(io, mesh);

    Type outsideValue(Zero);
    if (policy.is(outsidePolicy::VALUE))
    {
        outsideValue = dict.subDict("outsideValues").get<Type>(io.name());
    }

    const tmp<Field<Type>> values(mapping.map(field, outsideValue));
    table.add(io.name(), values());

    return true;
}


// Add the field to the table whatever its type
void addField
(
    const word& name,
    const fvMesh& mesh,
    const fieldToPointMapping& mapping,
    const dictionary& dict,
    const outsidePolicy& policy,
    pointTable& table
)
{
    IOobject io
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!returnReduce(io.typeHeaderOk<regIOobject>(false), andOp<bool>()))
    {
        FatalIOErrorInFunction(dict)
            << "fields: there is no field " << name << " at time "
            << mesh.time().timeName()
            << exit(FatalIOError);
    }

    const bool added =
        addField<scalar>(io, mesh, mapping, dict, policy, table)
     || addField<vector>(io, mesh, mapping, dict, policy, table)
     || addField<sphericalTensor>(io, mesh, mapping, dict, policy, table)
     || addField<symmTensor>(io, mesh, mapping, dict, policy, table)
     || addField<tensor>(io, mesh, mapping, dict, policy, table);

    if (!added)
    {
        FatalIOErrorInFunction(dict)
            << "fields: " << name << " is a " << io.headerClassName()
            << ", not a volume field"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Values of volume fields at the points of a section or a cloud"
    );

    timeSelector::addOptions();
    #include "addDictOption.H"
    #include "addRegionOption.H"
    #include "setRootCase.H"
    #include "createTime.H"

    const instantList times(selectedTimes(runTime, args));

    #include "createNamedMesh.H"

    const word dictName("mapFieldsToPointsDict");
    #include "setSystemMeshDictionaryIO.H"
    const IOdictionary dict(dictIO);
    checkKeys
    (
        dict,
        {"fields", "outside", "format"},
        {"FoamFile", "points", "outsideValues"}
    );

    const wordList fieldNames(dict.get<wordList>("fields"));
    const outsidePolicy policy(dict);
    const autoPtr<pointSource> source(pointSource::New(dict.subDict("points")));
    const autoPtr<pointSetWriter> writer
    (
        pointSetWriter::New(dict, "format", "vtp")
    );

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << endl;

        mesh.readUpdate();

        const pointField points(source->points(mesh));
        const fieldToPointMapping mapping(mesh, points, policy);

        Info<< "    " << points.size() << " points, "
            << mapping.outside().count() << " outside the mesh" << endl;

        pointTable table(points);

        for (const word& name : fieldNames)
        {
            addField(name, mesh, mapping, dict, policy, table);
        }

        const fileName file
        (
            runTime.globalPath()/functionObject::outputPrefix/args.executable()
           /runTime.timeName()/"points." + writer->ext()
        );

        if (Pstream::master())
        {
            writer->write(file, table, runTime.value());
        }

        Info<< "    Written " << runTime.relativePath(file) << nl << endl;
    }

    Info<< "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
