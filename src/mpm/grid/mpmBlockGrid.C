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
            blocks_[mine].clear.swap(old.clear);
            blocks_[mine].wallNodes.swap(old.wallNodes);
            blocks_[mine].mirrors.swap(old.mirrors);
            blocks_[mine].mirrored.swap(old.mirrored);
            blocks_[mine].rest = old.rest;
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
    patches.resize(blocks_.size()*nPatchNodes(reach_), Node{});

    return mine;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim>
mpm::BlockGrid<Dim>::BlockGrid
(
    const double cellSize,
    const Vector<Dim>& origin,
    const int reach,
    const std::vector<Wall<Dim>>& walls
)
:
    cellSize_(cellSize),
    origin_(origin),
    reach_(reach),
    walls_(&walls)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
mpm::Vector<Dim> mpm::BlockGrid<Dim>::position
(
    const Block& block,
    const std::array<int, Dim>& at
) const
{
    Vector<Dim> x;
    for (int d = 0; d < Dim; ++d)
    {
        x[d] = origin_[d] + cellSize_*(block.at[d]*double(edge) + at[d]);
    }
    return x;
}


template<int Dim>
bool mpm::BlockGrid<Dim>::isOwn(const Block& block, const int node) const
{
    for (int corner = 0; corner < nCorners; ++corner)
    {
        const std::int32_t from = block.minus[corner];
        bool covers = from >= 0 && blocks_[from].adds();
        for (int d = 0; d < Dim; ++d)
        {
            const int local = (node >> (d*log2Edge)) & (edge - 1);
            covers =
                covers && (!((corner >> d) & 1) || local < reach_);
        }
        if (covers)
        {
            return !blocks_[from].ghost;
        }
    }
    return true;
}


template<int Dim>
template<int Reach>
void mpm::BlockGrid<Dim>::collect
(
    const NodeField& field,
    const Block& block,
    Node* const patch
) const
{
    constexpr int patchEdge = edge + Reach;
    constexpr int depth = Dim == 2 ? 1 : patchEdge;
    Node* target = patch;

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
                *target++ = own[x];
            }
            for (int x = 0; x < Reach; ++x)
            {
                *target++ = next[x];
            }
        }
    }

    for (const Mirror& m : block.mirrors)
    {
        patch[m.node - m.step] = m.sign*patch[m.node + m.step];
    }
}


template<int Dim>
template<int Reach>
void mpm::BlockGrid<Dim>::sum
(
    const NodeField& field,
    const Block& block,
    Node* sums
) const
{
    constexpr int patchEdge = edge + Reach;

    for (int i = 0; i < nNodes; ++i)
    {
        sums[i] = Node{};
    }

    for (int corner = 0; corner < nCorners; ++corner)
    {
        const std::int32_t from = block.minus[corner];
        if (from < 0 || !blocks_[from].adds())
        {
            continue;
        }
        const Node* patch =
            field.data() + std::size_t(from)*nPatchNodes(Reach);

        // The lower neighbour's patch reaches into this block
        const int xEnd = (corner & 1) ? Reach : edge;
        const int yEnd = (corner & 2) ? Reach : edge;
        const int zEnd = Dim == 2 ? 1 : (corner & 4) ? Reach : edge;
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
std::int32_t mpm::BlockGrid<Dim>::lookUp(const Coordinates& at) const
{
    const auto found = index_.find(key(at));
    return found == index_.end() ? -1 : found->second;
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
          + block.wallNodes.capacity()*sizeof(WallNode)
          + block.mirrors.capacity()*sizeof(Mirror)
          + block.mirrored.capacity()*sizeof(double)

          + block.still.capacity()*sizeof(Node);
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
        writeBinary(os, block.rest);
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
        Block& block = blocks_[add(at, nullptr)];
        readBinary(is, block.rest);
        readBinary(is, block.points);
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::BlockGrid<2>;
template class mpm::BlockGrid<3>;

#define instantiate(Dim, Reach)                                                \
    template void mpm::BlockGrid<Dim>::collect<Reach>                          \
    (                                                                          \
        const NodeField&,                                                      \
        const Block&,                                                          \
        Node*                                                                  \
    ) const;                                                                   \
    template void mpm::BlockGrid<Dim>::sum<Reach>                              \
    (                                                                          \
        const NodeField&,                                                      \
        const Block&,                                                          \
        Node*                                                                  \
    ) const;

instantiate(2, 1)
instantiate(2, 2)
instantiate(2, 3)
instantiate(3, 1)
instantiate(3, 2)
instantiate(3, 3)

#undef instantiate


// ************************************************************************* //
