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

#include "mpmContactArea.H"
#include "mpmShapeFunctions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
template<class Function>
void mpm::ContactArea<Dim>::forNodes
(
    const Vector<Dim>& place,
    const Function& f
)
{
    constexpr int width = QuadraticBSpline::width;
    double w[Dim][width];
    std::array<int, Dim> base;
    int n = 1;
    for (int d = 0; d < Dim; ++d)
    {
        base[d] = int(QuadraticBSpline::base(place[d]));
        QuadraticBSpline::weights(place[d] - base[d], w[d]);
        n *= width;
    }
    for (int i = 0; i < n; ++i)
    {
        std::array<int, Dim> node;
        double weight = 1;
        int rest = i;
        for (int d = 0; d < Dim; ++d, rest /= width)
        {
            node[d] = base[d] + rest % width;
            weight *= w[d][rest % width];
        }
        f(node, weight);
    }
}


template<int Dim>
int mpm::ContactArea<Dim>::number(const std::array<int, Dim>& node) const
{
    int n = 0;
    for (int d = Dim - 1; d >= 0; --d)
    {
        if (node[d] < 0 || node[d] >= edge_)
        {
            return -1;
        }
        n = n*edge_ + node[d];
    }
    return n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::ContactArea<Dim>::ContactArea
(
    const Wall<Dim>& wall,
    const Vector<Dim>& firstNode,
    const double cellSize,
    const int edge,
    const double onWall
)
:
    edge_(edge)
{
    // Half the width of the bump, in cells: with two places a cell its sum is
    // exact along a direction of the grid. What it moves to nodes of the block
    // comes from within margin cells
    constexpr double half = 1.5;
    constexpr int perCell = 2;
    constexpr int margin = 3;

    const auto at = [&](const Vector<Dim>& place)
    {
        Vector<Dim> x(firstNode);
        for (int d = 0; d < Dim; ++d)
        {
            x[d] += cellSize*place[d];
        }
        return x;
    };
    const auto isWall = [&](const std::array<int, Dim>& node)
    {
        Vector<Dim> place, normal;
        std::copy(node.begin(), node.end(), place.begin());
        return wall.distance(at(place), normal) <= onWall;
    };

    int nNodes = 1, nPlaces = 1;
    const int nEdge = perCell*(edge - 1 + 2*margin);
    double part = 1;
    for (int d = 0; d < Dim; ++d)
    {
        nNodes *= edge;
        nPlaces *= nEdge;
        part *= cellSize/perCell;
    }
    area_.assign(nNodes, 0);
    volume_.assign(nNodes, 0);

    for (int i = 0; i < nPlaces; ++i)
    {
        Vector<Dim> place, normal;
        int rest = i;
        for (int d = 0; d < Dim; ++d, rest /= nEdge)
        {
            place[d] = (rest % nEdge + 0.5)/perCell - margin;
        }
        const double distance = wall.distance(at(place), normal)/cellSize;

        // Share of the part of a cell that is free
        const double free =
            std::min(1.0, std::max(0.0, 0.5 + perCell*distance));
        if (free > 0)
        {
            forNodes
            (
                place,
                [&](const std::array<int, Dim>& node, const double weight)
                {
                    const int n = number(node);
                    if (n >= 0)
                    {
                        volume_[n] += free*part*weight;
                    }
                }
            );
        }
        if (std::fabs(distance) >= half)
        {
            continue;
        }

        constexpr double pi = 3.14159265358979323846;
        const double bump = 0.5*(1 + std::cos(pi*distance/half))/half;
        for (int d = 0; d < Dim; ++d)
        {
            place[d] -= distance*normal[d];
        }
        double sum = 0;
        bool mine = false;
        forNodes
        (
            place,
            [&](const std::array<int, Dim>& node, const double weight)
            {
                if (isWall(node))
                {
                    sum += weight;
                    mine = mine || number(node) >= 0;
                }
            }
        );
        if (!mine || !(sum > 0))
        {
            continue;
        }
        forNodes
        (
            place,
            [&](const std::array<int, Dim>& node, const double weight)
            {
                const int n = number(node);
                if (n >= 0 && isWall(node))
                {
                    area_[n] += bump*part/cellSize*weight/sum;
                }
            }
        );
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::ContactArea<2>;
template class mpm::ContactArea<3>;


// ************************************************************************* //
