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

#include "asciiGrid.H"
#include "byteOrderMark.H"
#include "HashTable.H"
#include "stringOps.H"

#include <fstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::asciiGrid::asciiGrid(const fileName& file, const dictionary& dict)
:
    file_(file)
{
    std::ifstream is(file_);

    if (!is)
    {
        FatalIOErrorInFunction(dict)
            << "Cannot open the grid 'file' = " << file_
            << exit(FatalIOError);
    }

    skipByteOrderMark(is);

    // Header: pairs of a key and a number until the first line of numbers
    HashTable<scalar> header;
    std::string key;

    while ((is >> std::ws) && std::isalpha(is.peek()))
    {
        scalar number;

        if (!(is >> key >> number))
        {
            FatalIOErrorInFunction(dict)
                << "The header of the grid " << file_
                << " has no number after '" << key.c_str() << "'"
                << exit(FatalIOError);
        }

        header.set(word(stringOps::lower(key)), number);
    }

    for (const word required : {"ncols", "nrows", "cellsize"})
    {
        if (header.lookup(required, 0) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "The header of the grid " << file_
                << " lacks a positive '" << required << "'"
                << exit(FatalIOError);
        }
    }

    nColumns_ = label(header["ncols"]);
    nRows_ = label(header["nrows"]);
    cellSize_ = header["cellsize"];
    noData_ = header.lookup("nodata_value", -9999);

    if (header.found("xllcorner") && header.found("yllcorner"))
    {
        west_ = header["xllcorner"];
        south_ = header["yllcorner"];
    }
    else if (header.found("xllcenter") && header.found("yllcenter"))
    {
        west_ = header["xllcenter"] - 0.5*cellSize_;
        south_ = header["yllcenter"] - 0.5*cellSize_;
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "The header of the grid " << file_
            << " has neither xllcorner and yllcorner"
            << " nor xllcenter and yllcenter"
            << exit(FatalIOError);
    }

    values_.resize(nColumns_*nRows_);

    for (label row = nRows_ - 1; row >= 0; --row)
    {
        for (label column = 0; column < nColumns_; ++column)
        {
            if (!(is >> values_[cell(row, column)]))
            {
                FatalIOErrorInFunction(dict)
                    << "The grid " << file_ << " ends or is no"
                    << " number at row " << nRows_ - row << " of " << nRows_
                    << ", column " << column + 1 << " of " << nColumns_
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::asciiGrid::interpolate
(
    const scalar x,
    const scalar y,
    scalar& result
) const
{
    // Share of a cell that is round-off of a place
    const scalar roundOff = 1e-9;

    // In cells from the middle of the south-western one
    const scalar column = (x - west_)/cellSize_ - 0.5;
    const scalar row = (y - south_)/cellSize_ - 0.5;

    if
    (
        column < -roundOff || column > nColumns_ - 1 + roundOff
     || row < -roundOff || row > nRows_ - 1 + roundOff
    )
    {
        return false;
    }

    // A place on the rim belongs to the last pair; a grid may be one cell wide
    const label west = max(min(label(column), nColumns_ - 2), label(0));
    const label south = max(min(label(row), nRows_ - 2), label(0));
    const scalar s = column - west;
    const scalar t = row - south;

    result = 0;
    for (label j = 0; j < min(nRows_, label(2)); ++j)
    {
        for (label i = 0; i < min(nColumns_, label(2)); ++i)
        {
            const label celli = cell(south + j, west + i);

            if (!hasData(celli))
            {
                return false;
            }
            result += (i ? s : 1 - s)*(j ? t : 1 - t)*value(celli);
        }
    }

    return true;
}


bool Foam::asciiGrid::matches(const asciiGrid& other) const
{
    // Share of a cell that is round-off of the headers
    const scalar roundOff = 1e-6;

    return
        nColumns_ == other.nColumns_
     && nRows_ == other.nRows_
     && mag(cellSize_ - other.cellSize_) < roundOff*cellSize_/nColumns_
     && mag(west_ - other.west_) < roundOff*cellSize_
     && mag(south_ - other.south_) < roundOff*cellSize_;
}

// ************************************************************************* //
