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

#include "rainRecord.H"
#include "rainUnit.H"
#include "readChoice.H"
#include "readChecked.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Days from 1970-01-01 to a date of the Gregorian calendar
static label daysSince1970(const label year, const label month, const label day)
{
    // Years that begin in March have their leap day at the end
    const label y = (month > 2 ? year : year - 1);
    const label m = (month > 2 ? month - 3 : month + 9);
    const label leapDays = y/4 - y/100 + y/400;

    return 365*y + leapDays + (153*m + 2)/5 + day - 1 - 719468;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::rainRecord::seconds
(
    const string& date,
    const label row
) const
{
    int year, month, day, hour, minute;
    double second = 0;
    char between;

    const int found = std::sscanf
    (
        date.c_str(),
        "%d%*[-/]%d%*[-/]%d%c%d:%d:%lf",
        &year,
        &month,
        &day,
        &between,
        &hour,
        &minute,
        &second
    );

    if
    (
        found < 6
     || month < 1 || month > 12
     || day < 1 || day > 31
     || hour < 0 || hour > 24
     || minute < 0 || minute > 59
     || second < 0 || second >= 60
    )
    {
        const string message
        (
            "\"" + date + "\" is no date of the form YYYY-MM-DD hh:mm[:ss]"
        );

        if (row >= 0)
        {
            table_.stop(row, message);
        }

        FatalIOErrorInFunction(dict_)
            << "Entry 'origin': " << message.c_str() << exit(FatalIOError);
    }

    return
        86400.0*daysSince1970(year, month, day)
      + 3600*hour + 60*minute + second;
}


Foam::scalarList Foam::rainRecord::readTimes() const
{
    const word unit
    (
        readChoiceOrDefault
        (
            dict_,
            "timeUnit",
            "s",
            {"s", "min", "h", "d", "date"}
        )
    );
    const label column = table_.column("timeColumn", 0);
    const scalar scale =
        unit == "min" ? 60 : unit == "h" ? 3600 : unit == "d" ? 86400 : 1;
    const scalar origin =
        unit == "date" ? seconds(dict_.get<string>("origin"), -1) : 0;

    scalarList times(table_.size());

    forAll(times, row)
    {
        times[row] =
            unit == "date"
          ? seconds(table_.text(row, column), row) - origin
          : scale*table_.number(row, column);

        if (row > 0 && times[row] <= times[row - 1])
        {
            table_.stop(row, "the time is not after that of the row before");
        }
    }

    return times;
}


Foam::scalar Foam::rainRecord::readInterval(const scalarList& times) const
{
    if (dict_.found("interval"))
    {
        const token& first = dict_.lookup("interval").first();

        if (first.isWord() && first.wordToken() == "variable")
        {
            return 0;
        }

        return readChecked
        (
            dict_,
            "interval",
            [](const scalar length) { return length > 0; },
            "> 0 s, or variable"
        );
    }

    if (times.size() < 2)
    {
        FatalIOErrorInFunction(dict_)
            << "File " << table_.file() << " has one row: the entry 'interval'"
            << " must say how long it counts" << exit(FatalIOError);
    }

    scalar shortest = GREAT;
    for (label row = 1; row < times.size(); ++row)
    {
        shortest = min(shortest, times[row] - times[row - 1]);
    }

    return shortest;
}


Foam::scalar Foam::rainRecord::readRain(const label row) const
{
    const label column = table_.column("rainColumn", 1);

    if (!table_.isNumber(row, column))
    {
        return -1;
    }

    const scalar rain = table_.number(row, column);

    if (rain == dict_.getOrDefault<scalar>("missing", -9999))
    {
        return -1;
    }

    if (rain < 0)
    {
        table_.stop
        (
            row,
            "rain is " + table_.text(row, column) + "; it must be >= 0"
        );
    }

    return rain;
}


void Foam::rainRecord::append
(
    const scalar begin,
    const scalar end,
    const scalar rain
)
{
    // Distances below this share of an interval are round-off of the file
    const scalar roundOff = 1e-6;

    const auto add = [&](const scalar to, const scalar known)
    {
        const scalar before = rates_.empty() ? -1 : rates_.last();

        times_.append(to);
        rates_.append
        (
            known >= 0 ? known
          : gapPolicy_ == "zero" ? 0
          : gapPolicy_ == "hold" ? before
          : -1
        );
    };

    if (times_.empty())
    {
        times_.append(begin);
    }
    else if (begin > times_.last() + roundOff*(end - begin))
    {
        add(begin, -1);
    }

    add(end, rain >= 0 ? rainRate(dict_, rain, end - begin) : -1);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rainRecord::rainRecord(const dictionary& dict)
:
    dict_(dict),
    table_(dict),
    gapPolicy_
    (
        readChoiceOrDefault
        (
            dict,
            "gapPolicy",
            "error",
            {"error", "zero", "hold"}
        )
    ),
    times_(),
    rates_()
{
    const bool atEnd =
        readChoiceOrDefault(dict, "stamp", "end", {"begin", "end"}) == "end";
    const scalarList times(readTimes());
    const scalar interval = readInterval(times);

    // Distances below this share of an interval are round-off of the file
    const scalar roundOff = 1e-6;

    forAll(times, row)
    {
        if (interval > 0)
        {
            if
            (
                row > 0
             && times[row] - times[row - 1] < (1 - roundOff)*interval
            )
            {
                table_.stop
                (
                    row,
                    "the interval overlaps that of the row before"
                );
            }

            append
            (
                atEnd ? times[row] - interval : times[row],
                atEnd ? times[row] : times[row] + interval,
                readRain(row)
            );
        }
        else if (atEnd && row > 0)
        {
            append(times[row - 1], times[row], readRain(row));
        }
        else if (!atEnd && row + 1 < times.size())
        {
            append(times[row], times[row + 1], readRain(row));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rainRecord::rateBefore() const
{
    return gapPolicy_ == "zero" ? 0 : -1;
}


Foam::scalar Foam::rainRecord::rateAfter() const
{
    return
        gapPolicy_ == "zero" ? 0
      : gapPolicy_ == "hold" && rates_.size() ? rates_.last()
      : -1;
}


void Foam::rainRecord::stopAtGap(const scalar begin, const scalar end) const
{
    FatalIOErrorInFunction(dict_)
        << "The run needs the rain from t = " << begin << " s ";

    if (end < times_.last())
    {
        FatalIOError<< "to " << end << " s";
    }
    else
    {
        FatalIOError<< "on";
    }

    FatalIOError
        << ", which the file " << table_.file() << " does not know: it"
        << " reaches from " << times_.first() << " s to " << times_.last()
        << " s, its times being read in the timeUnit "
        << dict_.getOrDefault<word>("timeUnit", "s")
        << ", and this is a gap. Entry 'gapPolicy' can say what to take"
        << " there: zero, or hold for the last known rate"
        << exit(FatalIOError);
}

// ************************************************************************* //
