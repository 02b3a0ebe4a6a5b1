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
    compareFields

Description
    Compares vol and area fields with a reference on the same mesh: norms
    weighted by cell volume or face area, the worst cell or face with both
    values, and tolerances per field.

    The exit code is 1 if a field is outside its tolerance.

Usage
    \b compareFields [OPTION]

    The reference is another case, one time folder of a case, or any folder
    that holds fields. In parallel it is a case (or folder) with the same
    processor folders. Fields and tolerances come from
    \c system/compareFieldsDict,
    \verbatim
    reference   "../serial";

    fields
    {
        psi     { Linf 1e-8; }
        h       { relativeL2 1e-6; Linf 1e-9; }
    }
    \endverbatim
    or from the command line:
    \verbatim
    compareFields -reference ../serial -fields '(psi h)' -tolerance '(1e-8)'
    \endverbatim

    Without a time option the last time is compared.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "timeSelector.H"
#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"
#include "faMesh.H"
#include "areaFields.H"
#include "fieldTolerance.H"
#include "readChecked.H"
#include "selectedTimes.H"
#include "storedField.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- What -help lists
void addOptions()
{
    timeSelector::addOptions(false, false);
    argList::addOption
    (
        "dict",
        "file",
        "Read this dictionary instead of system/compareFieldsDict"
    );
    argList::addOption
    (
        "reference",
        "dir",
        "Another case, or a folder with fields (relative to the case)"
    );
    argList::addOption
    (
        "fields",
        "wordList",
        "The fields, for example '(psi theta)', instead of the dictionary's"
    );
    argList::addOption
    (
        "tolerance",
        "scalarList",
        "With -fields: one tolerance for all or one for each"
    );
    argList::addOption
    (
        "measure",
        "word",
        "With -fields: L1, L2, Linf (default), relativeL1, relativeL2 or"
        " relativeLinf"
    );
}


//- The dictionary; an empty one if the options say it all
IOdictionary readDictionary(const argList& args, const Time& runTime)
{
    const word dictName("compareFieldsDict");
    #include "setSystemRunTimeDictionaryIO.H"

    if (args.found("fields"))
    {
        dictIO.readOpt() = IOobject::NO_READ;

        if (!args.found("reference") || !args.found("tolerance"))
        {
            FatalErrorInFunction
                << "Option -fields needs -reference and -tolerance"
                << exit(FatalError);
        }
    }

    return IOdictionary(dictIO);
}


//- Path of the reference, from the option or from the dictionary
fileName readReference
(
    const argList& args,
    const dictionary& dict,
    const Time& runTime
)
{
    fileName reference
    (
        args.found("reference")
      ? args.get<fileName>("reference")
      : dict.get<fileName>("reference")
    );
    reference.expand();

    if (!reference.isAbsolute())
    {
        reference = runTime.globalPath()/reference;
    }

    reference.clean();

    return reference;
}


//- The times that the options select, the last one without an option
instantList comparedTimes(const argList& args, Time& runTime)
{
    const instantList times(selectedTimes(runTime, args));

    const bool all =
        args.found("time") || args.found("latestTime") || args.found("noZero");

    return all ? times : instantList(1, times.last());
}


//- The tolerance of each field, from the options or from the dictionary
HashTable<fieldTolerance> readTolerances
(
    const argList& args,
    const dictionary& dict
)
{
    HashTable<fieldTolerance> tolerances;

    if (!args.found("fields"))
    {
        for (const entry& e : dict.subDict("fields"))
        {
            tolerances.insert(e.keyword(), fieldTolerance(e.dict()));
        }

        return tolerances;
    }

    const wordList names(args.getList<word>("fields"));
    const scalarList limits(args.getList<scalar>("tolerance"));

    const word measureName
    (
        args.getOrDefault<word>
        (
            "measure",
            fieldDifference::measureNames[fieldDifference::Linf]
        )
    );

    if (limits.size() != 1 && limits.size() != names.size())
    {
        FatalErrorInFunction
            << "Option -tolerance has " << limits.size()
            << " values for " << names.size()
            << " fields; give one for all or one for each"
            << exit(FatalError);
    }

    if (!fieldDifference::measureNames.found(measureName))
    {
        FatalErrorInFunction
            << "Unknown measure " << measureName << nl
            << "    Valid measures: "
            << flatOutput(fieldDifference::measureNames.sortedToc())
            << exit(FatalError);
    }

    forAll(names, i)
    {
        tolerances.insert
        (
            names[i],
            fieldTolerance
            (
                fieldDifference::measureNames[measureName],
                limits[limits.size() == 1 ? 0 : i]
            )
        );
    }

    return tolerances;
}


//- The folder with the reference's fields of a time
fileName referenceFolder(const fileName& reference, const instant& time)
{
    fileName top(reference);

    if (Pstream::parRun())
    {
        top = top/("processor" + Foam::name(Pstream::myProcNo()));
    }

    if (!isDir(top))
    {
        FatalErrorInFunction
            << "There is no folder " << top << " with reference fields"
            << exit(FatalError);
    }

    // A case: the time of the same value, however its name is written
    const scalar tolerance = max(mag(time.value()), scalar(1))*ROOTSMALL;

    for (const instant& stored : Time::findTimes(top))
    {
        if
        (
            stored.name() != "constant"
         && mag(stored.value() - time.value()) < tolerance
        )
        {
            return top/stored.name();
        }
    }

    return top;
}


//- Compare if the fields are of this type, which sets compared
template<class GeoField>
void compareType
(
    const storedField& field,
    const storedField& reference,
    const scalarField& weights,
    const vectorField& centres,
    const word& element,
    autoPtr<fieldDifference>& difference
)
{
    if (field.className() == GeoField::typeName)
    {
        typedef typename GeoField::value_type Type;

        difference.reset
        (
            new fieldDifference
            (
                field.values<Type>(weights.size()),
                reference.values<Type>(weights.size()),
                weights,
                centres,
                element
            )
        );
    }
}


//- Compare one field of the mesh
autoPtr<fieldDifference> compare
(
    const fvMesh& mesh,
    autoPtr<faMesh>& aMesh,
    const storedField& field,
    const storedField& reference
)
{
    if (field.className() != reference.className())
    {
        FatalErrorInFunction
            << field.path() << " is a " << field.className() << ", "
            << reference.path() << " is a " << reference.className()
            << exit(FatalError);
    }

    if (field.dimensions() != reference.dimensions())
    {
        FatalErrorInFunction
            << field.path() << " has dimensions " << field.dimensions()
            << ", " << reference.path() << " has "
            << reference.dimensions()
            << exit(FatalError);
    }

    autoPtr<fieldDifference> difference;

    if (field.className().startsWith("area"))
    {
        if (!aMesh.valid())
        {
            aMesh.reset(new faMesh(mesh));
        }

        const scalarField areas(aMesh->S().field());
        const vectorField centres(aMesh->areaCentres().primitiveField());

        #define compareArea(Type)                                             \
            compareType<area##Type##Field>                                    \
            (field, reference, areas, centres, "face", difference)

        compareArea(Scalar);
        compareArea(Vector);
        compareArea(SphericalTensor);
        compareArea(SymmTensor);
        compareArea(Tensor);

        #undef compareArea
    }
    else
    {
        const scalarField volumes(mesh.V().field());
        const vectorField centres(mesh.C().primitiveField());

        #define compareVolume(Type)                                           \
            compareType<vol##Type##Field>                                     \
            (field, reference, volumes, centres, "cell", difference)

        compareVolume(Scalar);
        compareVolume(Vector);
        compareVolume(SphericalTensor);
        compareVolume(SymmTensor);
        compareVolume(Tensor);

        #undef compareVolume
    }

    if (!difference.valid())
    {
        FatalErrorInFunction
            << field.path() << " is a " << field.className()
            << "; only vol and area fields can be compared"
            << exit(FatalError);
    }

    return difference;
}


//- Print how far a field is from the reference, and whether that is accepted
bool accepted
(
    const word& name,
    const fieldDifference& difference,
    const fieldTolerance& tolerance
)
{
    OStringStream exceeded;
    const bool isAccepted = tolerance.accepts(difference, exceeded);

    Info<< "    " << name << ':';
    for (const word& m : fieldDifference::measureNames.names())
    {
        Info<< ' ' << m << ' '
            << difference[fieldDifference::measureNames[m]];
    }
    Info<< nl
        << "        worst " << difference.worst().c_str() << nl
        << exceeded.str().c_str()
        << "        " << (isAccepted ? "accepted" : "OUTSIDE") << nl;

    return isAccepted;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Compare vol and area fields with a reference on the same mesh.\n"
        "Exit code 1 if one is outside its tolerance.\n"
        "Without a time option the last time is compared."
    );
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    const IOdictionary dict(readDictionary(args, runTime));
    checkKeys(dict, {"reference"}, {"FoamFile", "fields"});

    const fileName reference(readReference(args, dict, runTime));
    const HashTable<fieldTolerance> tolerances(readTolerances(args, dict));
    const instantList times(comparedTimes(args, runTime));

    #include "createNamedMesh.H"
    autoPtr<faMesh> aMesh;

    label nOutside = 0;

    for (const instant& time : times)
    {
        runTime.setTime(time, 0);
        Info<< "Time = " << runTime.timeName() << nl;

        const fileName folder(runTime.path()/runTime.timeName());
        const fileName refFolder(referenceFolder(reference, time));

        for (const word& name : tolerances.sortedToc())
        {
            const autoPtr<fieldDifference> difference
            (
                compare
                (
                    mesh,
                    aMesh,
                    storedField(name, folder, mesh),
                    storedField(name, refFolder, mesh)
                )
            );

            nOutside += !accepted(name, *difference, tolerances[name]);
        }
    }

    Info<< nl << nOutside << " of " << times.size()*tolerances.size()
        << " comparisons outside their tolerance" << nl
        << nl << "End" << nl << endl;

    // The destructor of argList would end the run with exit code 0
    if (nOutside)
    {
        Pstream::exit(1);
    }

    return 0;
}


// ************************************************************************* //
