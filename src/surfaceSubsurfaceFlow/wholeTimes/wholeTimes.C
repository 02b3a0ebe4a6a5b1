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

#include "wholeTimes.H"
#include "DynamicList.H"
#include "FlatOutput.H"
#include "HashSet.H"
#include "IOstreams.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "argList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Extension of the mark of a time, beside its folder: a file while it is being
// written, a folder of this name is one that was set aside
static const char* const unfinished = "unfinished";


// Wait for all processors
static void meet()
{
    returnReduce(true, andOp<bool>());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::setUnfinishedTimesAside(const argList& args)
{
    List<fileNameList> marked(Pstream::nProcs());
    fileNameList& mine = marked[Pstream::myProcNo()];

    for (const fileName& name : readDir(args.path(), fileName::FILE))
    {
        scalar time;

        if (readScalar(name.lessExt(), time) && name.hasExt(unfinished))
        {
            mine.append(name.lessExt());
        }
    }
    Pstream::gatherList(marked);
    Pstream::scatterList(marked);

    HashSet<fileName> times;
    for (const fileNameList& names : marked)
    {
        times.insert(names);
    }

    for (const fileName& name : times.sortedToc())
    {
        const fileName folder(args.path()/name);
        const fileName aside(folder + "." + unfinished);

        Info<< "Time " << name << " was left half written by a run that was"
            << " stopped: set aside as " << aside.name() << nl << endl;

        if (isFile(aside, false))
        {
            rm(aside);
        }
        rmDir(aside, true);
        if (isDir(folder) && !mv(folder, aside))
        {
            FatalErrorInFunction
                << "Can't rename " << folder << " to " << aside
                << exit(FatalError);
        }
    }
}


void Foam::checkStartTime(const Time& runTime)
{
    // Names of times have 6 digits by default
    const scalar sameTime = 1e-6*max(mag(runTime.value()), scalar(1));

    DynamicList<word> names;

    for (const instant& t : runTime.times())
    {
        if (t.name() != runTime.constant())
        {
            if (mag(t.value() - runTime.value()) <= sameTime)
            {
                return;
            }
            names.append(t.name());
        }
    }

    if (names.size())
    {
        FatalErrorInFunction
            << "The case " << runTime.path() << " has no time "
            << runTime.timeName() << " to start from (startFrom, startTime of"
            << " system/controlDict). Its times: " << flatOutput(names)
            << exit(FatalError);
    }
}


void Foam::writeWhole(Time& runTime)
{
    if (!runTime.writeTime())
    {
        runTime.write();
        return;
    }

    const fileName mark(runTime.timePath() + "." + unfinished);

    rmDir(mark, true);
    {
        OFstream os(mark);
        os << "This time is being written" << endl;
    }
    meet();

    runTime.write();

    meet();
    rm(mark);
}

// ************************************************************************* //
