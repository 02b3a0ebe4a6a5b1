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
#include "mpmBinary.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
std::uint64_t mpm::BlockGrid<Dim>::key(const Coordinates& at)
{
    // 21 bits a direction; coordinates are within +-(2^20)
    constexpr std::int64_t offset = 1 << 20;
    std::uint64_t k = 0;
    for (int d = 0; d < Dim; ++d)
    {
        k = (k << 21) | std::uint64_t(at[d] + offset);
    }
    return k;
}


template<int Dim>
std::int32_t mpm::BlockGrid<Dim>::add
(
    const Coordinates& at,
    Former* former
)
{
    const auto found = index_.find(key(at));
    if (found != index_.end())
    {
        return found->second;
    }

    const std::int32_t mine = std::int32_t(blocks_.size());
    index_[key(at)] = mine;
    blocks_.emplace_back();
    blocks_.back().at = at;

    for (int o = 0; o < nCorners; ++o)
    {
        Coordinates up(at), down(at);
        for (int d = 0; d < Dim; ++d)
        {
            up[d] += (o >> d) & 1;
            down[d] -= (o >> d) & 1;
        }

        const auto above = index_.find(key(up));
        const auto below = index_.find(key(down));
        const bool hasAbove = above != index_.end();
        const bool hasBelow = below != index_.end();

        blocks_[mine].plus[o] = hasAbove ? above->second : -1;
        blocks_[mine].minus[o] = hasBelow ? below->second : -1;
        if (hasAbove)
        {
            blocks_[above->second].minus[o] = mine;
        }
        if (hasBelow)
        {
            blocks_[below->second].plus[o] = mine;
        }
    }

    if (former)
    {
        const auto same = former->index.find(key(at));
        if (same != former->index.end())
        {
            Block& old = former->blocks[same->second];
            blocks_[mine].walls.swap(old.walls);
            blocks_[mine].wallNodes.swap(old.wallNodes);
        }
        else
        {
            findWalls(blocks_[mine]);
        }
    }
    else
    {
        findWalls(blocks_[mine]);
    }

    // Patches of blocks without points stay zero
    nodes.resize(blocks_.size()*nNodes, Node{});
    patches.resize(blocks_.size()*nPatchNodes, Node{});

    return mine;
}


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

        // A node on the wall up to round-off of the coordinates is on it
        const double onWall = 1e-9*cellSize_;
        for (int i = 0; i < nNodes; ++i)
        {
            if (wall.distance(position(block, i), normal) <= onWall)
            {
                block.wallNodes.push_back
                (
                    WallNode{i, std::int32_t(w), normal}
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::BlockGrid<Dim>::BlockGrid
(
    const double cellSize,
    const Vector<Dim>& origin,
    const std::vector<Wall<Dim>>& walls
)
:
    cellSize_(cellSize),
    origin_(origin),
    walls_(&walls)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
mpm::Vector<Dim> mpm::BlockGrid<Dim>::position
(
    const Block& block,
    const int node
) const
{
    Vector<Dim> x;
    for (int d = 0; d < Dim; ++d)
    {
        const int local = (node >> (d*log2Edge)) & (edge - 1);
        x[d] = origin_[d] + cellSize_*(block.at[d]*double(edge) + local);
    }
    return x;
}


template<int Dim>
void mpm::BlockGrid<Dim>::collect
(
    const NodeField& field,
    const Block& block,
    Node* patch
) const
{
    constexpr int depth = Dim == 2 ? 1 : patchEdge;

    for (int z = 0; z < depth; ++z)
    {
        for (int y = 0; y < patchEdge; ++y)
        {
            const int corner =
                ((y >> log2Edge) << 1) | ((z >> log2Edge) << 2);
            const int row =
                edge*((y & (edge - 1)) + edge*(z & (edge - 1)));

            const Node* own =
                field.data() + std::size_t(block.plus[corner])*nNodes + row;
            const Node* next =
                field.data() + std::size_t(block.plus[corner | 1])*nNodes
              + row;

            for (int x = 0; x < edge; ++x)
            {
                *patch++ = own[x];
            }
            *patch++ = next[0];
            *patch++ = next[1];
        }
    }
}


template<int Dim>
void mpm::BlockGrid<Dim>::sum
(
    const NodeField& field,
    const Block& block,
    Node* sums
) const
{
    for (int i = 0; i < nNodes; ++i)
    {
        sums[i] = Node{};
    }

    for (int corner = 0; corner < nCorners; ++corner)
    {
        const std::int32_t from = block.minus[corner];
        if (from < 0 || blocks_[from].points.empty())
        {
            continue;
        }
        const Node* patch =
            field.data() + std::size_t(from)*nPatchNodes;

        // The lower neighbour's patch ends two nodes into this block
        const int xEnd = (corner & 1) ? 2 : edge;
        const int yEnd = (corner & 2) ? 2 : edge;
        const int zEnd = Dim == 2 ? 1 : (corner & 4) ? 2 : edge;
        const int xFrom = (corner & 1) ? edge : 0;
        const int yFrom = (corner & 2) ? edge : 0;
        const int zFrom = (corner & 4) ? edge : 0;

        for (int z = 0; z < zEnd; ++z)
        {
            for (int y = 0; y < yEnd; ++y)
            {
                const Node* source =
                    patch + xFrom
                  + patchEdge*((y + yFrom) + patchEdge*(z + zFrom));
                Node* target = sums + edge*(y + edge*z);
                for (int x = 0; x < xEnd; ++x)
                {
                    target[x] += source[x];
                }
            }
        }
    }
}


template<int Dim>
std::int32_t mpm::BlockGrid<Dim>::find
(
    const Coordinates& at,
    Former* former
)
{
    const std::int32_t mine = add(at, former);
    for (int o = 1; o < nCorners; ++o)
    {
        if (blocks_[mine].plus[o] < 0)
        {
            Coordinates up(at);
            for (int d = 0; d < Dim; ++d)
            {
                up[d] += (o >> d) & 1;
            }
            add(up, former);
        }
    }
    return mine;
}


template<int Dim>
void mpm::BlockGrid<Dim>::rebuild(const std::vector<Coordinates>& places)
{
    Former former;
    former.blocks.swap(blocks_);
    former.index.swap(index_);
    nodes.clear();
    patches.clear();

    for (const Coordinates& at : places)
    {
        find(at, &former);
    }
}


template<int Dim>
std::size_t mpm::BlockGrid<Dim>::bytes() const
{
    std::size_t sum =
        (nodes.capacity() + patches.capacity())*sizeof(Node)
      + blocks_.capacity()*sizeof(Block);
    for (const Block& block : blocks_)
    {
        sum +=
            block.points.capacity()*sizeof(std::int32_t)
          + block.walls.capacity()*sizeof(std::int32_t)
          + block.wallNodes.capacity()*sizeof(WallNode);
    }
    return sum;
}


template<int Dim>
void mpm::BlockGrid<Dim>::write(std::ostream& os) const
{
    writeBinary(os, std::uint64_t(blocks_.size()));
    for (const Block& block : blocks_)
    {
        writeBinary(os, block.at);
        writeBinary(os, block.points);
    }
}


template<int Dim>
void mpm::BlockGrid<Dim>::read(std::istream& is)
{
    rebuild({});
    std::uint64_t n = 0;
    readBinary(is, n);
    for (std::uint64_t i = 0; i < n; ++i)
    {
        Coordinates at;
        readBinary(is, at);
        readBinary(is, blocks_[add(at, nullptr)].points);
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::BlockGrid<2>;
template class mpm::BlockGrid<3>;


// ************************************************************************* //
