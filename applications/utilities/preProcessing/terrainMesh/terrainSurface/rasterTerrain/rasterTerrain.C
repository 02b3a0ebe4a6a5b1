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

#include "rasterTerrain.H"
#include "addToRunTimeSelectionTable.H"
#include "HashTable.H"
#include "stringOps.H"

#include <fstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace terrainSurfaces
{
    defineTypeNameAndDebug(rasterTerrain, 0);
    addToRunTimeSelectionTable(terrainSurface, rasterTerrain, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::terrainSurfaces::rasterTerrain::read(const dictionary& dict)
{
    std::ifstream is(file_);

    if (!is)
    {
        FatalIOErrorInFunction(dict)
            << "Cannot open the elevation grid 'file' = " << file_
            << exit(FatalIOError);
    }

    // Header: pairs of a key and a number until the first line of numbers
    HashTable<scalar> header;
    std::string key;

    while ((is >> std::ws) && std::isalpha(is.peek()))
    {
        scalar number;

        if (!(is >> key >> number))
        {
            FatalIOErrorInFunction(dict)
                << "The header of the elevation grid " << file_
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
                << "The header of the elevation grid " << file_
                << " lacks a positive '" << required << "'"
                << exit(FatalIOError);
        }
    }

    nColumns_ = label(header["ncols"]);
    nRows_ = label(header["nrows"]);
    cellSize_ = header["cellsize"];
    noData_ = header.lookup("nodata_value", -9999);

    if (header.found("xllcenter") && header.found("yllcenter"))
    {
        x0_ = header["xllcenter"];
        y0_ = header["yllcenter"];
    }
    else if (header.found("xllcorner") && header.found("yllcorner"))
    {
        x0_ = header["xllcorner"] + 0.5*cellSize_;
        y0_ = header["yllcorner"] + 0.5*cellSize_;
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "The header of the elevation grid " << file_
            << " has neither xllcorner and yllcorner"
            << " nor xllcenter and yllcenter"
            << exit(FatalIOError);
    }

    values_.resize(nColumns_*nRows_);

    for (label row = nRows_ - 1; row >= 0; --row)
    {
        for (label column = 0; column < nColumns_; ++column)
        {
            if (!(is >> values_[row*nColumns_ + column]))
            {
                FatalIOErrorInFunction(dict)
                    << "The elevation grid " << file_ << " ends or is no"
                    << " number at row " << nRows_ - row << " of " << nRows_
                    << ", column " << column + 1 << " of " << nColumns_
                    << exit(FatalIOError);
            }
        }
    }
}


Foam::scalar Foam::terrainSurfaces::rasterTerrain::cellPosition
(
    const scalar distance,
    const label n,
    const scalar x,
    const scalar y
) const
{
    const scalar position = distance/cellSize_;

    // Half a cell, and round-off of the mesh's coordinates
    const scalar margin = 0.5 + 1e-6;

    if (position < -margin || position > n - 1 + margin)
    {
        FatalErrorInFunction
            << "Terrain surface " << name() << ": the place (" << x << ' '
            << y << ") lies outside the elevation grid " << file_
            << ", x " << x0_ - 0.5*cellSize_ << " .. "
            << x0_ + (nColumns_ - 0.5)*cellSize_
            << ", y " << y0_ - 0.5*cellSize_ << " .. "
            << y0_ + (nRows_ - 0.5)*cellSize_
            << exit(FatalError);
    }

    return min(max(position, scalar(0)), scalar(n - 1));
}


Foam::scalar Foam::terrainSurfaces::rasterTerrain::value
(
    const label row,
    const label column
) const
{
    const scalar z = values_[row*nColumns_ + column];

    if (z == noData_)
    {
        FatalErrorInFunction
            << "Terrain surface " << name() << ": the elevation grid "
            << file_ << " has no data at (" << x0_ + column*cellSize_ << ' '
            << y0_ + row*cellSize_ << "), where the mesh needs it"
            << exit(FatalError);
    }

    return z;
}


Foam::scalar Foam::terrainSurfaces::rasterTerrain::rawElevation
(
    const scalar x,
    const scalar y
) const
{
    const scalar column = cellPosition(x - x0_, nColumns_, x, y);
    const scalar row = cellPosition(y - y0_, nRows_, x, y);

    const label west = min(label(column), max(nColumns_ - 2, 0));
    const label south = min(label(row), max(nRows_ - 2, 0));
    const label east = min(west + 1, nColumns_ - 1);
    const label north = min(south + 1, nRows_ - 1);

    const scalar fx = column - west;
    const scalar fy = row - south;

    return
        (1 - fy)*((1 - fx)*value(south, west) + fx*value(south, east))
      + fy*((1 - fx)*value(north, west) + fx*value(north, east));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::terrainSurfaces::rasterTerrain::rasterTerrain
(
    const word& name,
    const dictionary& dict,
    const fileName& casePath
)
:
    terrainSurface(name, dict),
    file_
    (
        [&]
        {
            fileName file(dict.get<fileName>("file").expand());
            return file.isAbsolute() ? file : casePath/file;
        }()
    )
{
    read(dict);
}


// ************************************************************************* //
