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

#include "lineReader.H"

#include <fstream>
#include <sstream>

#include <vtkCellArray.h>
#include <vtkDataSetReader.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using runoutPicture::polyline;
using runoutPicture::viewAxes;

//- True if a name ends like this
bool endsLike(const std::string& name, const std::string& ending)
{
    return name.size() > ending.size()
        && name.compare
           (
               name.size() - ending.size(),
               ending.size(),
               ending
           ) == 0;
}


//- The numbers in a row of text; stops if there is anything else
std::vector<double> numbers(std::string row, const std::string& source)
{
    std::replace(row.begin(), row.end(), ',', ' ');
    std::istringstream stream(row);

    std::vector<double> result;
    std::string word;

    while (stream >> word)
    {
        std::size_t used = 0;
        try
        {
            result.push_back(std::stod(word, &used));
        }
        catch (const std::exception&)
        {
            used = 0;
        }

        if (used != word.size())
        {
            throw std::invalid_argument
            (
                "'" + word + "' in " + source + " is not a number"
            );
        }
    }

    return result;
}


//- The lines of a text file
std::vector<polyline> readText(const std::string& file, const viewAxes& view)
{
    std::ifstream stream(file);
    std::vector<polyline> lines(1);
    std::string row;
    int rowNumber = 0;

    while (std::getline(stream, row))
    {
        ++rowNumber;
        if (!row.empty() && row[0] == '#')
        {
            continue;
        }

        const auto x =
            numbers(row, file + " row " + std::to_string(rowNumber));

        if (x.empty())
        {
            lines.emplace_back();
        }
        else if (x.size() == 2)
        {
            lines.back().push_back({x[0], x[1]});
        }
        else if (x.size() == 3)
        {
            lines.back().push_back(view.project(x.data()));
        }
        else
        {
            throw std::invalid_argument
            (
                file + " row " + std::to_string(rowNumber) + " has "
              + std::to_string(x.size()) + " columns; 2 or 3 are expected"
            );
        }
    }

    return lines;
}


//- Add the lines of VTK cells
void addCells
(
    vtkPolyData& data,
    vtkCellArray& cells,
    const bool closed,
    const viewAxes& view,
    std::vector<polyline>& lines
)
{
    vtkNew<vtkIdList> nodes;

    for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i)
    {
        cells.GetCellAtId(i, nodes);
        polyline line;

        for (vtkIdType k = 0; k < nodes->GetNumberOfIds(); ++k)
        {
            double x[3];
            data.GetPoint(nodes->GetId(k), x);
            line.push_back(view.project(x));
        }

        if (closed && !line.empty())
        {
            line.push_back(line.front());
        }

        lines.push_back(line);
    }
}


//- The lines of a VTK file
template<class Reader>
std::vector<polyline> readVTK(const std::string& file, const viewAxes& view)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();

    auto* data = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
    std::vector<polyline> lines;

    if (data)
    {
        addCells(*data, *data->GetLines(), false, view, lines);
        addCells(*data, *data->GetPolys(), true, view, lines);
    }
    if (lines.empty())
    {
        throw std::runtime_error("The file " + file + " holds no lines");
    }

    return lines;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<runoutPicture::polyline> runoutPicture::readLines
(
    const std::string& file,
    const viewAxes& view
)
{
    if (!std::ifstream(file))
    {
        throw std::runtime_error("Cannot read the file " + file);
    }
    if (endsLike(file, ".vtp"))
    {
        return readVTK<vtkXMLPolyDataReader>(file, view);
    }
    if (endsLike(file, ".vtk"))
    {
        return readVTK<vtkDataSetReader>(file, view);
    }

    return readText(file, view);
}


runoutPicture::polyline runoutPicture::parseLine(const std::string& text)
{
    const auto x = numbers(text, "'" + text + "'");

    if (x.size() < 4 || x.size() % 2)
    {
        throw std::invalid_argument
        (
            "The line '" + text + "' needs pairs of numbers, at least two"
        );
    }

    polyline line;
    for (std::size_t i = 0; i < x.size(); i += 2)
    {
        line.push_back({x[i], x[i + 1]});
    }
    return line;
}


// ************************************************************************* //
