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

#include "suctionTable.H"
#include "csvTable.H"
#include "readChecked.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::suctionTable::refuse
(
    const dictionary& dict,
    const label row,
    const string& column,
    const scalar value,
    const string& reason
)
{
    FatalIOErrorInFunction(dict)
        << "Row " << row + 1 << " of the table of " << dict.name() << ": "
        << column.c_str() << " is " << value
        << ", but " << reason.c_str() << nl << exit(FatalIOError);
}


void Foam::suctionTable::readValues(const dictionary& dict)
{
    const List<scalarList> rows(dict.get<List<scalarList>>("values"));
    const label width = rows.empty() ? 0 : rows.first().size();

    if (width < 2 || width > 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'values' of " << dict.name() << " has " << width
            << " columns in its first row; valid are (suction theta) and"
            << " (suction theta kr)" << nl << exit(FatalIOError);
    }

    suction_.resize(rows.size());
    theta_.resize(rows.size());
    kr_.resize(width == 3 ? rows.size() : 0);

    forAll(rows, i)
    {
        if (rows[i].size() != width)
        {
            refuse
            (
                dict,
                i,
                "the number of columns",
                rows[i].size(),
                "that of the first row is " + name(width)
            );
        }

        suction_[i] = rows[i][0];
        theta_[i] = rows[i][1];

        if (width == 3)
        {
            kr_[i] = rows[i][2];
        }
    }
}


void Foam::suctionTable::readFile(const dictionary& dict)
{
    const csvTable table(dict);

    const label suction = table.find("suction");
    const label theta = table.find("theta");
    const label kr = table.find("kr");

    if (suction < 0 || (theta < 0 && kr < 0))
    {
        FatalIOErrorInFunction(dict)
            << "The first line of " << table.file() << " must name the columns"
            << " suction and theta, kr or both" << nl << exit(FatalIOError);
    }

    const auto read = [&](const label column, scalarList& values)
    {
        values.resize(column < 0 ? 0 : table.size());

        forAll(values, row)
        {
            values[row] = table.number(row, column);
        }
    };

    read(suction, suction_);
    read(theta, theta_);
    read(kr, kr_);
}


void Foam::suctionTable::check(const dictionary& dict) const
{
    if (suction_.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "The table in " << dict.name() << " has " << suction_.size()
            << " rows; a curve needs two or more" << nl
            << exit(FatalIOError);
    }

    const auto checkRow = [&]
    (
        const scalarList& values,
        const label i,
        const word& column,
        const bool allowed,
        const string& range,
        const bool ordered,
        const string& order
    )
    {
        if (!allowed)
        {
            refuse(dict, i, column, values[i], range);
        }
        if (i > 0 && !ordered)
        {
            refuse
            (
                dict,
                i,
                column,
                values[i],
                "the row before has " + name(values[i - 1]) + " and " + order
            );
        }
    };

    forAll(suction_, i)
    {
        const scalar s = suction_[i];
        checkRow
        (
            suction_,
            i,
            "suction",
            s >= 0,
            "suctions are not negative",
            i > 0 && s > suction_[i - 1],
            "suctions must rise"
        );
    }

    forAll(theta_, i)
    {
        const scalar theta = theta_[i];
        checkRow
        (
            theta_,
            i,
            "theta",
            theta > 0 && theta <= 1,
            "0 < theta <= 1",
            i > 0 && theta < theta_[i - 1],
            "theta must fall (the first row is the air entry)"
        );
    }

    forAll(kr_, i)
    {
        const scalar kr = kr_[i];
        checkRow
        (
            kr_,
            i,
            "kr",
            kr > 0 && (i == 0 ? mag(kr - 1) < SMALL : kr <= 1),
            i == 0 ? "kr of the first row, at saturation, is 1" : "0 < kr <= 1",
            i > 0 && kr <= kr_[i - 1],
            "kr must not rise"
        );
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::suctionTable::suctionTable(const dictionary& dict)
:
    suction_(),
    theta_(),
    kr_(),
    cubic_(true)
{
    const word interpolation
    (
        dict.getOrDefault<word>("interpolation", "monotoneCubic")
    );
    cubic_ = (interpolation == "monotoneCubic");

    if (!cubic_ && interpolation != "linear")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'interpolation' of " << dict.name() << " is "
            << interpolation << "; valid are monotoneCubic and linear" << nl
            << exit(FatalIOError);
    }

    if (dict.found("values") == dict.found("file"))
    {
        FatalIOErrorInFunction(dict)
            << "A table needs one of the entries 'values' and 'file'; "
            << dict.name() << " has "
            << (dict.found("values") ? "both" : "neither") << nl
            << exit(FatalIOError);
    }

    if (dict.found("file"))
    {
        readFile(dict);
    }
    else
    {
        readValues(dict);
    }

    check(dict);

    const scalar unit = readCheckedOrDefault
    (
        dict,
        "headUnit",
        1,
        [](const scalar x) { return x > 0; },
        "headUnit > 0 [m]"
    );

    for (scalar& s : suction_)
    {
        s *= unit;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::suctionTable::given(const dictionary& dict)
{
    return dict.found("values") || dict.found("file");
}

// ************************************************************************* //
