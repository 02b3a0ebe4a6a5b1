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

#include "slideState.H"
#include "DynamicList.H"
#include "IFstream.H"
#include "ListOps.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"
#include "dictionary.H"
#include "outputFolder.H"
#include "slideControl.H"
#include "slideRecord.H"
#include "mpmRun.H"

#include <fstream>
#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::slideState::times() const
{
    DynamicList<scalar> result;

    for (const fileName& name : readDir(folder_, fileName::DIRECTORY))
    {
        scalar time;

        if
        (
            readScalar(name, time)
         && isFile(folder_/name/"run")
         && isFile(folder_/name/"state")
        )
        {
            result.append(time);
        }
    }

    sort(result, std::greater<scalar>());

    return scalarList(std::move(result));
}


Foam::fileName Foam::slideState::folder(const scalar time) const
{
    return folder_/timeTable::text(time);
}


Foam::fileName Foam::slideState::findFolder
(
    const Time& time,
    const word& name
)
{
    // A decomposed case: that of the first processor, unless the case itself
    // has this time and there are no states yet
    const fileName whole(time.globalPath()/time.timeName());
    fileName found;

    if (Pstream::master())
    {
        found =
            isDir(time.timePath()/name) || !isDir(whole)
          ? time.timePath()
          : whole;

        found = isDir(found) ? found/name : fileName();
    }
    Pstream::scatter(found);

    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideState::slideState
(
    const Time& time,
    const word& name,
    const word& digest
)
:
    folder_(findFolder(time, name)),
    digest_(digest),
    row_(0),
    lookTime_(0),
    lowest_(0),
    highest_(0),
    lookEnergy_(0),
    energy_(0),
    missed_(GREAT),
    atRest_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::slideState::restore
(
    mpm::Run& run,
    const slideControl& control,
    const slideRecord& record
)
{
    // The master looks
    scalar found = -1;

    if (Pstream::master() && kept() && isDir(folder_))
    {
        for (const scalar time : times())
        {
            IFstream is(folder(time)/"state");
            const dictionary dict(is);

            if
            (
                dict.get<word>("digest") == digest_
             && time <= timeTable::rounded(control.endTime())
             && record.reaches(time)
            )
            {
                found = time;
                lookTime_ = dict.get<scalar>("lookTime");
                lowest_ = dict.get<scalar>("lowest");
                highest_ = dict.get<scalar>("highest");
                lookEnergy_ = dict.get<scalar>("lookEnergy");
                energy_ = dict.get<scalar>("energy");
                missed_ = dict.get<scalar>("missed");
                atRest_ = dict.get<bool>("atRest");
                break;
            }
        }
    }
    Pstream::scatter(found);

    if (found < 0)
    {
        return false;
    }

    Pstream::scatter(lookTime_);
    Pstream::scatter(lowest_);
    Pstream::scatter(highest_);
    Pstream::scatter(lookEnergy_);
    Pstream::scatter(energy_);
    Pstream::scatter(missed_);
    Pstream::scatter(atRest_);

    std::ifstream runStream;
    if (Pstream::master())
    {
        runStream.open(folder(found)/"run", std::ios::binary);
    }
    run.restore(runStream);
    row_ = control.rowAt(run.time());

    return true;
}


void Foam::slideState::lookForRest
(
    const slideControl& control,
    const mpm::Diagnostics& now,
    const scalar leastDisplacement
)
{
    energy_ = max(energy_, scalar(now.kineticEnergy));
    lowest_ = min(lowest_, scalar(now.maxDisplacement));
    highest_ = max(highest_, scalar(now.maxDisplacement));

    if (control.looksForRest(now.time, lookTime_))
    {
        missed_ = control.missedDisplacement
        (
            now.time,
            highest_ - lowest_,
            lookEnergy_,
            energy_
        );
        atRest_ =
            control.atRest(missed_, now.maxDisplacement, leastDisplacement);
        lookEnergy_ = energy_;
        energy_ = 0;
        lookTime_ = now.time;
        lowest_ = highest_ = now.maxDisplacement;
    }
}


void Foam::slideState::save(const mpm::Run& run) const
{
    if (!kept())
    {
        return;
    }

    const fileName complete(folder(run.time()));
    const fileName unfinished(complete + ".unfinished");

    std::ofstream runStream;
    if (Pstream::master())
    {
        makeOutputFolder(unfinished);
        runStream.open(unfinished/"run", std::ios::binary);
    }
    run.save(runStream);

    if (!Pstream::master())
    {
        return;
    }

    if (!runStream.flush())
    {
        throw std::runtime_error
        (
            "can't write the file " + unfinished + "/run"
        );
    }
    runStream.close();

    {
        OFstream os(unfinished/"state");
        os.precision(std::numeric_limits<scalar>::max_digits10);

        os.writeEntry("digest", digest_);
        os.writeEntry("lookTime", lookTime_);
        os.writeEntry("lowest", lowest_);
        os.writeEntry("highest", highest_);
        os.writeEntry("lookEnergy", lookEnergy_);
        os.writeEntry("energy", energy_);
        os.writeEntry("missed", missed_);
        os.writeEntry("atRest", atRest_);
    }

    replaceByComplete(unfinished, complete);
}

// ************************************************************************* //
