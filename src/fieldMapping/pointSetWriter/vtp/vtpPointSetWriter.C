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

#include "vtpPointSetWriter.H"
#include "addToRunTimeSelectionTable.H"
#include "base64Layer.H"
#include "endian.H"
#include "pointTable.H"

#include <cstdint>
#include <iomanip>
#include <limits>
#include <ostream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointSetWriters
{
    defineTypeNameAndDebug(vtpPointSetWriter, 0);
    addToRunTimeSelectionTable(pointSetWriter, vtpPointSetWriter, word);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// One array of the file: its bytes behind their number, as VTK wants them
template<class Type>
static void writeArray
(
    std::ostream& os,
    const std::string& type,
    const std::string& name,
    const label nComponents,
    const UList<Type>& values
)
{
    os  << "<DataArray type='" << type << "' Name='" << name
        << "' NumberOfComponents='" << nComponents << "' format='binary'>\n";

    const std::uint64_t nBytes = values.size()*sizeof(Type);

    base64Layer encoded(os);
    encoded.write(reinterpret_cast<const char*>(&nBytes), sizeof(nBytes));
    encoded.write(reinterpret_cast<const char*>(values.cdata()), nBytes);
    encoded.close();

    os  << "\n</DataArray>\n";
}


// Symmetric tensors: from XX XY XZ YY YZ ZZ to VTK's XX YY ZZ XY YZ XZ
static scalarField vtkOrdered(const pointTable::column& c)
{
    const label n = symmTensor::nComponents;

    if (c.components.size() != n)
    {
        return c.values;
    }

    const FixedList<label, 6> order({0, 3, 5, 1, 4, 2});
    scalarField reordered(c.values.size());

    forAll(reordered, i)
    {
        reordered[i] = c.values[(i/n)*n + order[i % n]];
    }

    return reordered;
}

} // End namespace Foam


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::pointSetWriters::vtpPointSetWriter::writeTo
(
    std::ostream& os,
    const pointTable& table,
    const scalar time
) const
{
    typedef List<std::int64_t> indices;

    #ifdef WM_LITTLE_ENDIAN
    const std::string byteOrder("LittleEndian");
    #else
    const std::string byteOrder("BigEndian");
    #endif

    const label nPoints = table.points().size();

    scalarField positions(3*nPoints);
    indices connectivity(nPoints);
    indices offsets(nPoints);

    forAll(table.points(), pointi)
    {
        for (direction cmpt = 0; cmpt < 3; ++cmpt)
        {
            positions[3*pointi + cmpt] = table.points()[pointi][cmpt];
        }
        connectivity[pointi] = pointi;
        offsets[pointi] = pointi + 1;
    }

    os  << "<?xml version='1.0'?>\n"
        << "<VTKFile type='PolyData' version='1.0' byte_order='" << byteOrder
        << "' header_type='UInt64'>\n"
        << "<PolyData>\n"
        << "<FieldData>\n"
        << "<DataArray type='Float64' Name='TimeValue' NumberOfTuples='1'"
        << " format='ascii'>"
        << std::setprecision(std::numeric_limits<scalar>::max_digits10)
        << time << "</DataArray>\n"
        << "</FieldData>\n"
        << "<Piece NumberOfPoints='" << nPoints << "' NumberOfVerts='"
        << nPoints << "'>\n"
        << "<Points>\n";
    writeArray(os, "Float64", "Points", 3, positions);
    os  << "</Points>\n"
        << "<Verts>\n";
    writeArray(os, "Int64", "connectivity", 1, connectivity);
    writeArray(os, "Int64", "offsets", 1, offsets);
    os  << "</Verts>\n"
        << "<PointData>\n";

    for (const pointTable::column& c : table.columns())
    {
        const scalarField values(vtkOrdered(c));
        writeArray(os, "Float64", c.name, c.components.size(), values);
    }

    os  << "</PointData>\n"
        << "</Piece>\n"
        << "</PolyData>\n"
        << "</VTKFile>\n";
}

// ************************************************************************* //
