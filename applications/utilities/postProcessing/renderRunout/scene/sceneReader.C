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

#include "sceneReader.H"

#include <fstream>
#include <limits>
#include <map>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkCutter.h>
#include <vtkDataSetReader.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using runoutPicture::position;

//- The ending of a file name with its dot
std::string ending(const std::string& file)
{
    const auto dot = file.rfind('.');
    return dot == std::string::npos ? "" : file.substr(dot);
}


//- Median distance to the nearest neighbour, over at most 400 of the points:
//  each is compared with all others
double typicalSpacing(const std::vector<position>& nodes)
{
    if (nodes.size() < 2)
    {
        return 0;
    }

    const std::size_t stride = std::max<std::size_t>(1, nodes.size()/400);
    std::vector<double> nearest;

    for (std::size_t i = 0; i < nodes.size(); i += stride)
    {
        double smallest = std::numeric_limits<double>::max();

        for (std::size_t j = 0; j < nodes.size(); ++j)
        {
            const double dx = nodes[j][0] - nodes[i][0];
            const double dy = nodes[j][1] - nodes[i][1];

            if (j != i)
            {
                smallest = std::min(smallest, dx*dx + dy*dy);
            }
        }

        nearest.push_back(std::sqrt(smallest));
    }

    const auto middle = nearest.begin() + nearest.size()/2;
    std::nth_element(nearest.begin(), middle, nearest.end());
    return *middle;
}


//- The arrays of one kind, as " a b c"
std::string arrayNames(vtkDataSetAttributes& data)
{
    std::string names;
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
        if (const char* name = data.GetArrayName(i))
        {
            names += std::string(" ") + name;
        }
    }
    return names.empty() ? " (none)" : names;
}


//- Stops with VTK's reason when a reader met an error
template<class Reader>
vtkSmartPointer<vtkDataSet> readWith(const std::string& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();

    vtkSmartPointer<vtkDataSet> data
    (
        vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0))
    );

    if (!data || data->GetNumberOfPoints() == 0)
    {
        throw std::runtime_error
        (
            "The file " + file + " holds no points or is not a VTK file"
        );
    }

    return data;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

vtkSmartPointer<vtkDataSet>
runoutPicture::sceneReader::read(const std::string& file)
{
    if (!std::ifstream(file))
    {
        throw std::runtime_error("Cannot read the file " + file);
    }

    const std::string type(ending(file));

    if (type == ".vtp")
    {
        return readWith<vtkXMLPolyDataReader>(file);
    }
    if (type == ".vtu")
    {
        return readWith<vtkXMLUnstructuredGridReader>(file);
    }
    if (type == ".vtk")
    {
        return readWith<vtkDataSetReader>(file);
    }

    throw std::invalid_argument
    (
        "The file " + file + " has an unknown ending\n"
        "    Valid endings: .vtp .vtu .vtk"
    );
}


std::vector<double>
runoutPicture::sceneReader::values(vtkDataArray* array) const
{
    const int n = array->GetNumberOfComponents();
    const int wanted =
        array_.component.empty() ? -1 : array_.component[0] - 'x';

    if
    (
       !array_.component.empty()
     && (array_.component.size() > 1 || wanted < 0 || wanted >= n)
    )
    {
        throw std::invalid_argument
        (
            "Array " + array_.name + " has no component " + array_.component
          + "; it has " + std::to_string(n) + " component(s), named x y z"
        );
    }

    std::vector<double> result(array->GetNumberOfTuples());

    for (std::size_t i = 0; i < result.size(); ++i)
    {
        double value = array->GetComponent(i, std::max(0, wanted));

        if (wanted < 0 && n > 1)
        {
            double sum = 0;
            for (int k = 0; k < n; ++k)
            {
                const double part = array->GetComponent(i, k);
                sum += part*part;
            }
            value = std::sqrt(sum);
        }

        result[i] = array_.factor*value;
    }

    return result;
}


void runoutPicture::sceneReader::stopWithoutArray
(
    const std::string& file,
    vtkDataSet& data
) const
{
    throw std::runtime_error
    (
        "The file " + file + " has no array " + array_.name
      + "\n    Arrays of its points:" + arrayNames(*data.GetPointData())
      + "\n    Arrays of its cells:" + arrayNames(*data.GetCellData())
    );
}


vtkSmartPointer<vtkPolyData> runoutPicture::sceneReader::surface
(
    vtkDataSet& data,
    const std::optional<double>& slice
) const
{
    if (auto* poly = vtkPolyData::SafeDownCast(&data))
    {
        return poly;
    }

    const int k = view_.depthIndex();
    double bounds[6];
    data.GetBounds(bounds);
    const double place =
        slice ? *slice : 0.5*(bounds[2*k] + bounds[2*k + 1]);

    if (place < bounds[2*k] || place > bounds[2*k + 1])
    {
        throw std::invalid_argument
        (
            "The slice at " + std::to_string(place)
          + " is outside the mesh, which goes from "
          + std::to_string(bounds[2*k]) + " to "
          + std::to_string(bounds[2*k + 1])
        );
    }

    double origin[3] = {0, 0, 0};
    double normal[3] = {0, 0, 0};
    origin[k] = place;
    normal[k] = 1;

    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin);
    plane->SetNormal(normal);

    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(&data);
    cutter->SetCutFunction(plane);
    cutter->GenerateTrianglesOff();
    cutter->Update();

    return cutter->GetOutput();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

runoutPicture::sceneReader::sceneReader
(
    const viewAxes& view,
    const arrayChoice& array
)
:
    view_(view),
    array_(array)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

runoutPicture::pointSet
runoutPicture::sceneReader::points(const std::string& file) const
{
    const auto data = read(file);
    pointSet result;

    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
        double x[3];
        data->GetPoint(i, x);
        result.nodes.push_back(view_.project(x));
    }

    if (!array_.name.empty())
    {
        auto* array = data->GetPointData()->GetArray(array_.name.c_str());
        if (!array)
        {
            stopWithoutArray(file, *data);
        }
        result.values = values(array);
    }

    result.spacing = typicalSpacing(result.nodes);
    return result;
}


runoutPicture::triangleSet runoutPicture::sceneReader::mesh
(
    const std::string& file,
    const std::optional<double>& slice,
    const bool smooth,
    const bool flat
) const
{
    const auto data = read(file);
    const auto section = surface(*data, slice);
    triangleSet result;

    // The polygons' edges, before they are cut into triangles
    std::map<std::array<int, 2>, int> count;
    vtkNew<vtkIdList> corners;
    auto* polygons = section->GetPolys();
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
        polygons->GetCellAtId(i, corners);
        const vtkIdType n = corners->GetNumberOfIds();

        for (vtkIdType k = 0; k < n; ++k)
        {
            const int a = int(corners->GetId(k));
            const int b = int(corners->GetId((k + 1) % n));
            ++count[{std::min(a, b), std::max(a, b)}];
        }
    }

    for (const auto& [edge, n] : count)
    {
        result.edges.push_back(edge);
        if (n == 1)
        {
            result.outline.push_back(edge);
        }
    }

    vtkNew<vtkTriangleFilter> triangulation;
    triangulation->SetInputData(section);
    triangulation->PassLinesOff();
    triangulation->PassVertsOff();
    triangulation->Update();
    vtkSmartPointer<vtkPolyData> surface(triangulation->GetOutput());

    const char* name = array_.name.c_str();
    const bool inCells = surface->GetCellData()->GetArray(name);

    if (inCells && smooth)
    {
        vtkNew<vtkCellDataToPointData> average;
        average->SetInputData(surface);
        average->Update();
        surface = average->GetPolyDataOutput();
    }

    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
        double x[3];
        surface->GetPoint(i, x);
        result.nodes.push_back(view_.project(x));
        result.depth.push_back(view_.depth(x));
    }

    auto* triangles = surface->GetPolys();
    for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
    {
        triangles->GetCellAtId(i, corners);
        result.triangles.push_back
        ({
            int(corners->GetId(0)),
            int(corners->GetId(1)),
            int(corners->GetId(2))
        });
    }

    if (!array_.name.empty())
    {
        auto* nodal = surface->GetPointData()->GetArray(name);
        auto* cellular = surface->GetCellData()->GetArray(name);

        if (nodal)
        {
            result.nodeValues = values(nodal);
        }
        if (cellular && (flat || !nodal))
        {
            result.triangleValues = values(cellular);
        }
        if (!nodal && !cellular)
        {
            stopWithoutArray(file, *data);
        }
    }

    return result;
}


// ************************************************************************* //
