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

#include "mpmBlockGrid.H"
#include "mpmContactArea.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::BlockGrid<Dim>::findWalls(Block& block) const
{
    // The centre of the block's points and nodes, and how far they may be
    // from it; a signed distance changes no faster than the place
    Vector<Dim> centre;
    for (int d = 0; d < Dim; ++d)
    {
        centre[d] =
            origin_[d] + cellSize_*(edge*(block.at[d] + 0.5) + 0.5);
    }
    const double reach = std::sqrt(double(Dim))*cellSize_*(0.5*edge + 1.5);

    for (std::size_t w = 0; w < walls_->size(); ++w)
    {
        const Wall<Dim>& wall = (*walls_)[w];
        Vector<Dim> normal;
        if (wall.distance(centre, normal) > reach)
        {
            continue;
        }
        block.walls.push_back(std::int32_t(w));
        const std::size_t first = block.wallNodes.size();

        for (int i = 0; i < nNodes; ++i)
        {
            std::array<int, Dim> at;
            for (int d = 0; d < Dim; ++d)
            {
                at[d] = (i >> (d*log2Edge)) & (edge - 1);
            }
            if (wall.distance(position(block, at), normal) <= onWall())
            {
                block.wallNodes.push_back
                (
                    WallNode{i, std::int32_t(w), normal, 0, 0}
                );
            }
        }

        if (wall.needsArea() && block.wallNodes.size() > first)
        {
            const ContactArea<Dim> contact
            (
                wall, position(block, {}), cellSize_, edge, onWall()
            );
            for (std::size_t i = first; i < block.wallNodes.size(); ++i)
            {
                WallNode& node = block.wallNodes[i];
                node.area = contact.area(node.node);
                node.volume = contact.volume(node.node);
            }
        }

        for (int i = 0; wall.holds() && i < nPatchNodes(reach_); ++i)
        {
            std::array<int, Dim> at;
            for (int d = 0, rest = i; d < Dim; ++d, rest /= patchEdge())
            {
                at[d] = rest % patchEdge();
            }
            findMirror(block, std::int32_t(w), at);
        }
    }
    findClear(block);
}


template<int Dim>
void mpm::BlockGrid<Dim>::findClear(Block& block) const
{
    bool planes = true;
    for (const std::int32_t w : block.walls)
    {
        planes = planes && (*walls_)[w].isPlane();
    }
    if (planes)
    {
        return;
    }

    // Half the diagonal of a cell, and sqrt(Dim) because a distance that is
    // interpolated changes by as much faster than the place
    const double reach = 0.5*Dim*cellSize_ + onWall();
    const Vector<Dim> first = position(block, {});

    block.clear.assign(power(edge + 1), 1);
    for (std::size_t i = 0; i < block.clear.size(); ++i)
    {
        Vector<Dim> centre(first);
        for (std::size_t d = 0, rest = i; d < Dim; ++d, rest /= edge + 1)
        {
            centre[d] += cellSize_*(rest % (edge + 1) + 0.5);
        }
        for (const std::int32_t w : block.walls)
        {
            Vector<Dim> normal;
            if (!((*walls_)[w].distance(centre, normal) > reach))
            {
                block.clear[i] = 0;
            }
        }
    }
}


template<int Dim>
void mpm::BlockGrid<Dim>::findMirror
(
    Block& block,
    const std::int32_t w,
    const std::array<int, Dim>& at
) const
{
    const Wall<Dim>& wall = (*walls_)[w];
    Vector<Dim> normal;
    if (std::fabs(wall.distance(position(block, at), normal)) > onWall())
    {
        return;
    }

    // Of a terrain the nearest piece counts; a normal within 1e-6 of the
    // direction puts the image off by as little of a cell
    constexpr double across = 1 - 1e-12;
    int node = 0, stride = 1;
    for (int d = 0; d < Dim; ++d)
    {
        node += stride*at[d];
        stride *= patchEdge();
    }
    stride = 1;
    for (int d = 0; d < Dim; ++d)
    {
        if
        (
            std::fabs(normal[d]) > across
         && at[d] > 0
         && at[d] + 1 < patchEdge()
        )
        {
            Mirror m{node, normal[d] > 0 ? stride : -stride, w, {}};
            for (int e = 0; e < Dim; ++e)
            {
                m.sign[e] = wall.holdsAlong() || e == d ? -1 : 1;
            }
            m.sign[massOf] = 1;
            block.mirrors.push_back(m);
            if (wall.record() >= 0 || !block.mirrored.empty())
            {
                block.mirrored.resize(block.mirrors.size(), 0);
            }
        }
        stride *= patchEdge();
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::BlockGrid<2>::findWalls(Block&) const;
template void mpm::BlockGrid<3>::findWalls(Block&) const;


// ************************************************************************* //
