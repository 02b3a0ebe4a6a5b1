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
    mpmFoam

Description
    Lets a slope slide from the water of a hydrological time of a finished
    case, exactly as the function object landslideRunout does it in the run.

Usage
    \b mpmFoam [OPTION]

    Options:
      - \par -time \<ranges\>, -latestTime
        The hydrological times.

      - \par -name \<label\>
        The label of the output, default landslideRunout.

      - \par -mpmProperties \<file\>, -soilProperties \<file\>
        Variants of these files in constant, for states that differ in strength.

      - \par -stability \<label\>
        Whose factor of safety decides with run whenFactorOfSafetyBelow,
        default slopeStability.

      - \par -psi \<field\>, -theta \<field\>
        Names of the pressure head and the water content.

    With points from a file (see Foam::slidePoints) neither mesh nor fields are
    needed, and the hydrological time is 0 unless -time chooses another. Its
    folder is made, for the states from which a killed slide goes on.

    With -parallel the ranks share the slide. The case is decomposed for as many
    ranks, or not at all; then each of them reads the whole of it.

    Sample runs:
    \verbatim
    mpmFoam -time 0
    mpmFoam -latestTime -name weak -soilProperties soilProperties.weak
    mpirun -np 2 mpmFoam -parallel -time 3600
    \endverbatim

See also
    Foam::landslideRunout

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "landslideRunout.H"
#include "optionEntries.H"
#include "selectedTimes.H"
#include "wholeCase.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The clock of the case: of the whole one, or of this processor's part
autoPtr<Time> newTime(const argList& args, const bool isWhole)
{
    return autoPtr<Time>
    (
        isWhole
      ? new Time
        (
            Time::controlDictName,
            args.rootPath(),
            args.globalCaseName()
        )
      : new Time(Time::controlDictName, args)
    );
}


//- The slide of points from a file
void slideOfPoints
(
    const word& name,
    Time& runTime,
    const argList& args,
    const dictionary& options
)
{
    if (args.found("time"))
    {
        runTime.setTime(selectedTimes(runTime, args).last(), 0);
    }

    // Points from a file need no time folder, but what a killed slide goes on
    // from lies in one
    if (Pstream::master())
    {
        mkDir(runTime.globalPath()/runTime.timeName());
    }

    landslideRunout(name, runTime, nullptr, options).execute(std::nullopt);
}


//- The slides from the water of each selected time
void slidesFromWater
(
    const word& name,
    Time& runTime,
    const argList& args,
    const dictionary& options
)
{
    const instantList times(selectedTimes(runTime, args));

    #include "createNamedMesh.H"

    landslideRunout runout(name, runTime, &mesh, options);

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        mesh.readUpdate();

        runout.execute(runout.writtenFactorOfSafety());
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Lets a slope slide from the water of a time of a finished case"
    );

    timeSelector::addOptions();
    argList::addOption("name", "label", "Label of the output");
    argList::addOption("mpmProperties", "file", "Variant of mpmProperties");
    argList::addOption("soilProperties", "file", "Variant of soilProperties");
    argList::addOption("psi", "field", "Name of the pressure head");
    argList::addOption("theta", "field", "Name of the water content");
    argList::addOption("stability", "label", "Whose factor of safety to ask");

    #include "addRegionOption.H"
    argList::noCheckProcessorDirectories();
    #include "setRootCase.H"

    const bool isWhole = isWholeCase(args);
    const parallelSwitch reading(Pstream::parRun() && !isWhole);

    autoPtr<Time> runTime(newTime(args, isWhole));
    const dictionary options
    (
        optionEntries
        (
            args,
            {"mpmProperties", "soilProperties", "psi", "theta", "stability"}
        )
    );
    const word name
    (
        args.getOrDefault<word>("name", landslideRunout::typeName)
    );

    if (landslideRunout::needsNoMesh(*runTime, options))
    {
        slideOfPoints(name, *runTime, args, options);
    }
    else
    {
        slidesFromWater(name, *runTime, args, options);
    }

    Info<< "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
