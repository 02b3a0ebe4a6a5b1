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

#include "csvTable.H"
#include "argList.H"
#include "byteOrderMark.H"
#include "DynamicList.H"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::caseFile(const fileName& name)
{
    fileName file(name);
    file.expand();

    return file.isAbsolute() ? file : argList::envGlobalPath()/file;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

char Foam::csvTable::separatorOf(const std::string& line)
{
    for (const char separator : {';', '\t'})
    {
        if (line.find(separator) != std::string::npos)
        {
            return separator;
        }
    }

    return ',';
}


Foam::stringList Foam::csvTable::fields
(
    const std::string& line,
    const char separator
)
{
    const std::string around(" \t\r\"");

    DynamicList<string> result;
    std::string::size_type begin = 0;

    while (begin != std::string::npos)
    {
        const auto end = line.find(separator, begin);
        const std::string field
        (
            line.substr
            (
                begin,
                end == std::string::npos ? end : end - begin
            )
        );
        const auto first = field.find_first_not_of(around);

        result.append
        (
            first == std::string::npos
          ? string()
          : string
            (
                field.substr(first, field.find_last_not_of(around) - first + 1)
            )
        );

        begin = (end == std::string::npos ? end : end + 1);
    }

    return stringList(std::move(result));
}


bool Foam::csvTable::parse(string text, scalar& value)
{
    // Where a comma does not separate fields it stands for the decimal point
    std::replace(text.begin(), text.end(), ',', '.');

    // Unlike OpenFOAM's own reading this raises no floating-point exception
    // for nan and the like
    const char* const end = text.data() + text.size();
    const std::from_chars_result result =
        std::from_chars(text.data(), end, value);

    return
        result.ec == std::errc()
     && result.ptr == end
     && std::isfinite(value);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::csvTable::csvTable(const dictionary& dict)
:
    dict_(dict),
    file_(caseFile(dict.get<fileName>("file"))),
    names_(),
    rows_(),
    lines_()
{
    // If it is not given the names of the columns show it
    string separator;

    if (dict.readIfPresent("separator", separator) && separator.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'separator' is \"" << separator.c_str()
            << "\"; it must be one character" << exit(FatalIOError);
    }

    std::ifstream is(file_);

    if (!is)
    {
        FatalIOErrorInFunction(dict)
            << "Cannot open the file " << file_ << exit(FatalIOError);
    }

    skipByteOrderMark(is);

    DynamicList<stringList> rows;
    DynamicList<label> lines;
    std::string line;

    for (label lineNo = 1; std::getline(is, line); ++lineNo)
    {
        const auto first = line.find_first_not_of(" \t\r");

        if (first == std::string::npos || line[first] == '#')
        {
            continue;
        }

        if (separator.empty())
        {
            separator.push_back(separatorOf(line));
        }

        const stringList row(fields(line, separator[0]));

        if (names_.empty())
        {
            names_ = row;
            continue;
        }

        rows.append(row);
        lines.append(lineNo);

        if (row.size() != names_.size())
        {
            FatalIOErrorInFunction(dict)
                << "File " << file_ << ", line " << lineNo << " has "
                << row.size() << " fields; the first line names "
                << names_.size() << " columns" << exit(FatalIOError);
        }
    }

    rows_.transfer(rows);
    lines_.transfer(lines);

    if (rows_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "File " << file_ << " holds no row below a line with the names"
            << " of its columns" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::csvTable::column
(
    const word& key,
    const label position
) const
{
    label result = position;

    string name("(not given)");

    if (dict_.found(key))
    {
        const token& given = dict_.lookup(key).first();

        name =
            given.isWord()
          ? string(given.wordToken())
          : dict_.get<string>(key);
        result = names_.find(name);
    }

    if (result < 0 || result >= names_.size())
    {
        FatalIOErrorInFunction(dict_)
            << "File " << file_ << " has no column for '" << key << "' = "
            << name.c_str() << "; its columns are " << names_
            << exit(FatalIOError);
    }

    return result;
}


const Foam::string& Foam::csvTable::text
(
    const label row,
    const label column
) const
{
    return rows_[row][column];
}


bool Foam::csvTable::isNumber(const label row, const label column) const
{
    scalar value;

    return parse(text(row, column), value);
}


Foam::scalar Foam::csvTable::number
(
    const label row,
    const label column
) const
{
    scalar value = 0;

    if (!parse(text(row, column), value))
    {
        stop(row, "\"" + text(row, column) + "\" is no number");
    }

    return value;
}


void Foam::csvTable::stop(const label row, const string& message) const
{
    FatalIOErrorInFunction(dict_)
        << "File " << file_ << ", line " << lines_[row] << ": "
        << message.c_str() << exit(FatalIOError);
}

// ************************************************************************* //
