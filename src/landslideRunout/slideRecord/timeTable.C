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

#include "timeTable.H"
#include "clock.H"
#include "error.H"
#include "OSspecific.H"
#include "outputFolder.H"

#include <fstream>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::timeTable::read()
{
    std::ifstream is(file_);
    std::string line;
    bool known = false;

    while (std::getline(is, line))
    {
        if (line.empty() || line[0] == '#')
        {
            continue;
        }
        if (!known)
        {
            // A file of other columns is replaced
            if (line != header())
            {
                return;
            }
            known = true;
            continue;
        }

        const auto tab = line.find('\t');

        if (tab != std::string::npos)
        {
            rows_[std::stod(line.substr(0, tab))] = line.substr(tab);
        }
    }
}


std::string Foam::timeTable::header() const
{
    std::string line(columns_.first());

    for (label i = 1; i < columns_.size(); ++i)
    {
        line += "\t" + columns_[i];
    }

    return line;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeTable::timeTable(const fileName& file, const wordList& columns)
:
    file_(file),
    columns_(columns),
    rows_()
{
    makeOutputFolder(file_.path());
    read();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::timeTable::text(const scalar value)
{
    // Enough to see a change that matters, too few to show rounding
    const int nDigits = 12;

    std::ostringstream os;
    os << std::setprecision(nDigits) << value;

    return os.str();
}


Foam::scalar Foam::timeTable::rounded(const scalar value)
{
    return std::stod(text(value));
}


void Foam::timeTable::removeAfter(const scalar time)
{
    rows_.erase(rows_.upper_bound(rounded(time)), rows_.end());
}


void Foam::timeTable::set(const scalar time, const stringList& values)
{
    std::string line;

    for (const string& value : values)
    {
        line += "\t" + value;
    }

    rows_[rounded(time)] = line;
}


void Foam::timeTable::write() const
{
    const fileName unfinished(file_ + ".unfinished");

    {
        std::ofstream os(unfinished);

        os  << "# " << hostName() << ", " << clock::dateTime() << '\n'
            << header() << '\n';

        for (const auto& row : rows_)
        {
            os  << text(row.first) << row.second << '\n';
        }

        if (!os.flush())
        {
            FatalErrorInFunction
                << "Can't write the file " << unfinished
                << exit(FatalError);
        }
    }

    replaceByComplete(unfinished, file_);
}

// ************************************************************************* //
