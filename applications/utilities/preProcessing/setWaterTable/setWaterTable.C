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
    setWaterTable

Group
    grpPreProcessingUtilities

Description
    Sets the pressure head psi of still water: psi + z = elevation of the water
    table, with z measured against gravity (constant/g) from the origin. Above
    the table psi is the suction of hydrostatic equilibrium.

    psi must exist in the start time; its patch types and their entries are
    kept, and patches of type fixedValue and uniformFixedValue keep their
    values. The water content theta that belongs to psi is written beside it.

Usage
    \b setWaterTable [OPTION]

    Options:
      - \par -level \<elevation\>
        A level water table at this elevation [m]; no dictionary is read.

      - \par -depthBelowGround \<depth\>
        A water table this far [m] below the patch 'ground'; no dictionary is
        read.

      - \par -dict \<file\>
        Another dictionary than system/setWaterTableDict, which holds
    \verbatim
        type        level;              // level | depthBelowGround | surface
        level       4.5;                // level: elevation [m]

        depth       5.5;                // depthBelowGround: [m], >= 0
        groundPatch ground;             // depthBelowGround: default ground

        file        "waterTable.stl";   // surface: in constant/triSurface
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "gravityMeshObject.H"
#include "uniformFixedValueFvPatchFields.H"
#include "unsaturatedSoils.H"
#include "waterTable.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The dictionary of the water table, from the options or from the file
static dictionary tableDictionary(const argList& args, const Time& runTime)
{
    dictionary dict;

    if (args.found("level") && args.found("depthBelowGround"))
    {
        FatalErrorInFunction
            << "Give one of the options -level and -depthBelowGround"
            << exit(FatalError);
    }

    if (args.found("level"))
    {
        dict.set("type", word("level"));
        dict.set("level", args.get<scalar>("level"));
    }
    else if (args.found("depthBelowGround"))
    {
        dict.set("type", word("depthBelowGround"));
        dict.set("depth", args.get<scalar>("depthBelowGround"));
    }

    if (!dict.empty())
    {
        dict.name() = "options";
        return dict;
    }

    const word dictName("setWaterTableDict");
    #include "setSystemRunTimeDictionaryIO.H"

    Info<< "Reading " << dictIO.name() << endl;

    return IOdictionary(dictIO);
}


//- Unit vector against gravity
static vector upward(const Time& runTime)
{
    const vector g(meshObjects::gravity::New(runTime).value());

    if (mag(g) < SMALL)
    {
        FatalErrorInFunction
            << "constant/g is " << g << ": without gravity there is no water"
            << " table" << exit(FatalError);
    }

    return -g/mag(g);
}


//- Hydrostatic heads below and above a water table
static scalarField hydrostatic
(
    const waterTable& table,
    const vector& up,
    const UList<point>& points
)
{
    return table.elevation(points) - (Field<point>(points) & up);
}


//- Whether a patch's values are the user's
static bool prescribesHead(const fvPatchScalarField& patch)
{
    return
        patch.type() == fixedValueFvPatchScalarField::typeName
     || patch.type() == uniformFixedValueFvPatchScalarField::typeName;
}


//- Warn where water would stand on faces that look up, and how high
static void reportPonding
(
    const waterTable& table,
    const vector& up,
    const fvMesh& mesh
)
{
    // Steeper faces are walls, not ground
    const scalar leastSlope = 0.1;

    label nFaces = 0;
    label nPonded = 0;
    scalar highest = 0;

    for (const fvPatch& patch : mesh.boundary())
    {
        if (patch.coupled() || !patch.size())
        {
            continue;
        }

        const scalarField slope(patch.nf() & up);
        const scalarField head(hydrostatic(table, up, patch.Cf()));

        forAll(head, facei)
        {
            if (slope[facei] > leastSlope)
            {
                ++nFaces;
                nPonded += head[facei] > 0;
                highest = max(highest, head[facei]);
            }
        }
    }

    reduce(nFaces, sumOp<label>());
    reduce(nPonded, sumOp<label>());
    reduce(highest, maxOp<scalar>());

    if (nPonded)
    {
        WarningInFunction
            << "The water table lies above the ground at " << nPonded << " of "
            << nFaces << " faces that look up, by up to " << highest << " m"
            << endl;
    }
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Set the pressure head of still water below and above a water table"
    );
    argList::addOption
    (
        "level",
        "elevation",
        "A level water table at this elevation [m]"
    );
    argList::addOption
    (
        "depthBelowGround",
        "depth",
        "A water table this far [m] below the patch 'ground'"
    );
    argList::addOption
    (
        "dict",
        "file",
        "Read this dictionary instead of system/setWaterTableDict"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const vector up(upward(runTime));
    const unsaturatedSoils soils(mesh);
    const dictionary dict(tableDictionary(args, runTime));
    const autoPtr<waterTable> table(waterTable::New(dict, mesh, up));

    volScalarField psi
    (
        IOobject
        (
            "psi",
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    );

    psi.primitiveFieldRef() = hydrostatic(*table, up, mesh.cellCentres());

    forAll(psi.boundaryFieldRef(), patchi)
    {
        fvPatchScalarField& ppsi = psi.boundaryFieldRef()[patchi];

        if (ppsi.size() && !ppsi.coupled() && !prescribesHead(ppsi))
        {
            ppsi == hydrostatic(*table, up, ppsi.patch().Cf());
        }
    }

    const tmp<volScalarField> theta(soils.theta(psi));

    const dimensionedScalar saturatedVolume
    (
        "saturatedVolume",
        dimVolume,
        gSum(mesh.V()*pos0(psi.primitiveField()))
    );

    Info<< "psi in the cells: " << gMin(psi.primitiveField()) << " to "
        << gMax(psi.primitiveField()) << " m; "
        << 100*saturatedVolume.value()/gSum(mesh.V())
        << " % of the volume lies below the water table" << endl;
    reportPonding(*table, up, mesh);

    Info<< "Writing psi and theta in " << runTime.timeName() << nl << endl;

    if (!psi.write() || !theta().write())
    {
        FatalErrorInFunction
            << "Cannot write psi and theta in " << runTime.timePath()
            << exit(FatalError);
    }

    Info<< "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
