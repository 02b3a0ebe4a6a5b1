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

#include "selectedTimes.H"
#include "argList.H"
#include "scalarRanges.H"
#include "timeSelector.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::instantList Foam::selectedTimes(Time& runTime, const argList& args)
{
    // Names of times have 6 digits by default
    const scalar sameTime = 1e-6;

    const instantList times(timeSelector::select0(runTime, args));

    // What is asked for without naming a value must be there as well
    bool found = times.size();
    string wanted("of this choice");

    if (args.found("time"))
    {
        wanted = args["time"];

        for (const scalarRange& range : scalarRanges(args["time"]))
        {
            bool thisFound = !range.single();

            for (const instant& t : times)
            {
                if (range.single())
                {
                    thisFound = thisFound
                     || mag(t.value() - range.value())
                     <= sameTime*max(scalar(1), mag(range.value()));
                }
            }

            found = found && thisFound;
        }
    }

    if (!found)
    {
        wordList names;
        for (const instant& t : runTime.times())
        {
            if (t.name() != runTime.constant())
            {
                names.append(t.name());
            }
        }

        FatalErrorInFunction
            << "The case has no time " << wanted.c_str() << ". Its times: "
            << flatOutput(names)
            << exit(FatalError);
    }

    return times;
}

// ************************************************************************* //
