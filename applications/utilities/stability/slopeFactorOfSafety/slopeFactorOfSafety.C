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
    slopeFactorOfSafety

Group
    grpSlideFoamUtilities

Description
    The factor of safety of a section through the slope at times of a finished
    case, exactly as the function object slopeStability finds it in the run.

Usage
    \b slopeFactorOfSafety [OPTION]

    Options:
      - \par -time \<ranges\>, -latestTime
        The times, default all.

      - \par -name \<label\>
        The label of the output, default slopeStability.

      - \par -dict \<file\>
        Settings, default system/slopeStabilityDict; a one-layer mesh with a
        patch ground needs none.

      - \par -soilProperties \<file\>
        A variant of constant/soilProperties, for states that differ in
        strength.

      - \par -psi \<field\>, -theta \<field\>
        Names of the pressure head and the water content.

    Sample runs:
    \verbatim
    slopeFactorOfSafety
    slopeFactorOfSafety -latestTime -name weak -soilProperties soilProperties.weak
    mpirun -np 2 slopeFactorOfSafety -parallel -time 3600
    \endverbatim

See also
    Foam::slopeSafety

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "optionEntries.H"
#include "selectedTimes.H"
#include "slopeSafety.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "The factor of safety of a section through the slope by limit"
        " equilibrium"
    );

    timeSelector::addOptions();
    argList::addOption("name", "label", "Label of the output");
    argList::addOption("dict", "file", "Use this slopeStabilityDict");
    argList::addOption("soilProperties", "file", "Variant of soilProperties");
    argList::addOption("psi", "field", "Name of the pressure head");
    argList::addOption("theta", "field", "Name of the water content");

    #include "addRegionOption.H"
    #include "setRootCase.H"
    #include "createTime.H"

    const instantList times(selectedTimes(runTime, args));

    #include "createNamedMesh.H"

    dictionary settings(optionEntries(args, {"psi", "theta"}));
    if (args.found("soilProperties"))
    {
        // A file in constant, with or without its path
        settings.add
        (
            "soilProperties",
            word(args.get<fileName>("soilProperties").name())
        );
    }

    slopeSafety safety
    (
        args.getOrDefault<word>("name", "slopeStability"),
        mesh,
        settings,
        args.getOrDefault<fileName>("dict", fileName::null)
    );

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        mesh.readUpdate();

        safety.execute(times.first().name());
    }

    Info<< "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
