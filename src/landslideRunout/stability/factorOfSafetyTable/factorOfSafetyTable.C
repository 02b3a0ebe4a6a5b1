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

#include "factorOfSafetyTable.H"
#include "clock.H"
#include "error.H"
#include "OSspecific.H"
#include "outputFolder.H"

#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// How far apart two times may be that are the same: those in the file have 12
// digits
static scalar sameTime(const scalar time)
{
    return 1e-10*max(scalar(1), mag(time));
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::factorOfSafetyTable::read()
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
            if (line != header_)
            {
                return;
            }
            known = true;
            continue;
        }

        scalar time;
        if (readScalar(line.substr(0, line.find('\t')), time))
        {
            rows_[time].push_back(line);
        }
    }
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::factorOfSafetyTable::factorOfSafetyTable
(
    const fileName& file,
    const std::string& header
)
:
    file_(file),
    header_(header),
    rows_()
{
    makeOutputFolder(file_.path());
    read();
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::factorOfSafetyTable::set
(
    const scalar time,
    const std::vector<std::string>& rows
)
{
    rows_.erase(rows_.lower_bound(time - sameTime(time)), rows_.end());
    rows_[time] = rows;
}


std::optional<Foam::scalar> Foam::factorOfSafetyTable::firstValue
(
    const fileName& file,
    const scalar time
)
{
    std::ifstream is(file);
    std::string line;

    while (std::getline(is, line))
    {
        std::istringstream row(line);
        std::string timeText, method, fosText;

        std::getline(row, timeText, '\t');
        std::getline(row, method, '\t');
        std::getline(row, fosText, '\t');

        scalar rowTime, fos;

        if
        (
            readScalar(timeText, rowTime)
         && readScalar(fosText, fos)
         && mag(rowTime - time) <= sameTime(time)
        )
        {
            return fos;
        }
    }

    return std::nullopt;
}


void Foam::factorOfSafetyTable::write() const
{
    const fileName unfinished(file_ + ".unfinished");

    {
        std::ofstream os(unfinished);

        os  << "# " << hostName() << ", " << clock::dateTime() << '\n'
            << header_ << '\n';

        for (const auto& time : rows_)
        {
            for (const std::string& row : time.second)
            {
                os  << row << '\n';
            }
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
