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
    seedMaterialPoints

Description
    Writes the material points that a slide would start with, with the strength
    and weight that the water of a time gives them, to
    postProcessing/seedMaterialPoints/<time>/points.<format>, without sliding;
    the corners of terrain walls beside it in wall_<name>.<format>.

Usage
    \b seedMaterialPoints [OPTION]

    Options:
      - \par -time \<ranges\>, -latestTime
        The hydrological times.

      - \par -mpmProperties \<file\>, -soilProperties \<file\>
        Variants of these files in constant.

      - \par -psi \<field\>, -theta \<field\>
        Names of the pressure head and the water content.

      - \par -format \<format\>
        vtp (default), csv or raw.

    Sample run:
    \verbatim
    seedMaterialPoints -time 0
    \endverbatim

See also
    Foam::slidePoints

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "landslideRunout.H"
#include "optionEntries.H"
#include "pointSetWriter.H"
#include "pointTable.H"
#include "selectedTimes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

// Write the corners of the walls that are terrains, for looking at
void writeTerrains
(
    const std::vector<mpm::WallSettings>& walls,
    const slideFrame& frame,
    const fileName& pointsFile,
    const pointSetWriter& writer
)
{
    for (const mpm::WallSettings& wall : walls)
    {
        if (wall.vertices.empty() || !Pstream::master())
        {
            continue;
        }

        pointField vertices(wall.vertices.size());

        forAll(vertices, i)
        {
            const mpm::Point3& v = wall.vertices[i];
            vertices[i] = frame.toSpace(point(v[0], v[1], v[2]));
        }

        writer.write
        (
            pointsFile.path()/("wall_" + wall.name + "." + writer.ext()),
            pointTable(vertices),
            0
        );
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Writes the material points that a slide would start with"
    );

    timeSelector::addOptions();
    argList::addOption("mpmProperties", "file", "Variant of mpmProperties");
    argList::addOption("soilProperties", "file", "Variant of soilProperties");
    argList::addOption("psi", "field", "Name of the pressure head");
    argList::addOption("theta", "field", "Name of the water content");
    argList::addOption("format", "name", "vtp (default), csv or raw");

    #include "addRegionOption.H"
    #include "setRootCase.H"
    #include "createTime.H"

    const dictionary options
    (
        optionEntries
        (
            args,
            {"mpmProperties", "soilProperties", "psi", "theta", "format"}
        )
    );
    const instantList times(selectedTimes(runTime, args));

    #include "createNamedMesh.H"

    const landslideRunout runout(args.executable(), runTime, &mesh, options);
    const autoPtr<pointSetWriter> writer
    (
        pointSetWriter::New(options, "format", "vtp")
    );

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << endl;

        mesh.readUpdate();

        const slidePoints points(runout.points());

        const fileName file
        (
            runTime.globalPath()/functionObject::outputPrefix/args.executable()
           /runTime.timeName()/"points." + writer->ext()
        );

        if (Pstream::master())
        {
            writer->write(file, points.table(), runTime.value());
        }

        writeTerrains(runout.walls(points), points.frame(), file, writer());

        Info<< "    " << points.size() << " points written to "
            << runTime.relativePath(file) << nl << endl;
    }

    Info<< "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
