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

#include "isolines.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<runoutPicture::segment> runoutPicture::isoline
(
    const triangleSet& mesh,
    const std::vector<double>& nodeValues,
    const double level
)
{
    std::vector<segment> pieces;

    for (const auto& triangle : mesh.triangles)
    {
        segment piece;
        int found = 0;

        for (int k = 0; k < 3 && found < 2; ++k)
        {
            const int a = triangle[k];
            const int b = triangle[(k + 1) % 3];

            // A node at the level counts as above it: no edge is met twice
            if ((nodeValues[a] < level) == (nodeValues[b] < level))
            {
                continue;
            }

            const double share =
                (level - nodeValues[a])/(nodeValues[b] - nodeValues[a]);

            for (int d = 0; d < 2; ++d)
            {
                piece[found][d] =
                    (1 - share)*mesh.nodes[a][d] + share*mesh.nodes[b][d];
            }
            ++found;
        }

        if (found == 2)
        {
            pieces.push_back(piece);
        }
    }

    return pieces;
}


std::vector<double> runoutPicture::valuesAtNodes(const triangleSet& mesh)
{
    if (!mesh.nodeValues.empty())
    {
        return mesh.nodeValues;
    }

    std::vector<double> sum(mesh.nodes.size(), 0);
    std::vector<int> count(mesh.nodes.size(), 0);

    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        for (const int node : mesh.triangles[i])
        {
            sum[node] += mesh.triangleValues[i];
            ++count[node];
        }
    }

    for (std::size_t i = 0; i < sum.size(); ++i)
    {
        sum[i] /= std::max(1, count[i]);
    }

    return sum;
}


// ************************************************************************* //
