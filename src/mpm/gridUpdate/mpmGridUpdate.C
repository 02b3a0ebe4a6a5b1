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

#include "mpmGridUpdate.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Record a share of the momentum that a wall gave to a node, if it is to be
//  and no other rank does
template<int Dim>
inline void recordNode
(
    State<Dim>& state,
    const std::size_t block,
    const typename BlockGrid<Dim>::WallNode& w,
    const double share,
    const Node& before,
    const Node& after
)
{
    const int record = state.walls[w.wall].record();
    if
    (
        record >= 0 && share != 0
     && state.grid.isOwn(state.grid[block], w.node)
    )
    {
        const double m = share*after[massOf];
        state.reports[block].push(record, Node{m, m, m, m}*(after - before));
    }
}


//- Let an absorbing side act on a node
template<int Dim>
inline void absorb
(
    State<Dim>& state,
    const std::size_t block,
    const typename BlockGrid<Dim>::WallNode& w,
    const double deltaT
)
{
    const auto* side = state.sides.find
    (
        BlockGrid<Dim>::key(state.grid[block].at), w.node, w.wall
    );
    if (!side)
    {
        return;
    }
    Node& node = state.grid.nodesOf(block)[w.node];
    const Node before = node;
    const double mass =
        std::max(node[massOf], state.leastDensity*w.volume);
    const double perImpedance = deltaT*w.area/mass;
    Wall<Dim>::absorb
    (
        w.normal,
        deltaT*side->force/node[massOf],
        perImpedance*side->pressureImpedance,
        perImpedance*side->shearImpedance,
        node
    );
    recordNode(state, block, w, 1, before, node);
}


//- Record a share of what the image of a momentum has more than it
template<int Dim>
inline void recordMirror
(
    State<Dim>& state,
    const std::size_t block,
    const typename BlockGrid<Dim>::Mirror& m,
    const double share,
    const Node& momentum
)
{
    const int record = state.walls[m.wall].record();
    if (record >= 0 && share != 0)
    {
        const Node one{1, 1, 1, 1};
        const Node shares{share, share, share, share};
        state.reports[block].push(record, shares*(m.sign - one)*momentum);
    }
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim, int Reach>
void mpm::sumVelocities(State<Dim>& state, const std::size_t block)
{
    BlockGrid<Dim>& grid = state.grid;
    Node* nodes = grid.nodesOf(block);
    grid.template sum<Reach>(grid.patches, grid[block], nodes);

    const double least = state.settings.massCutOff*state.maxMass;
    for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
    {
        const double m = nodes[i][massOf];
        if (m > least)
        {
            const double perMass = 1/m;
            nodes[i] *= Node{perMass, perMass, perMass, perMass};
            nodes[i][massOf] = m;
        }
        else
        {
            nodes[i] = Node{};
        }
    }
}


template<int Dim>
void mpm::accelerate
(
    State<Dim>& state,
    const std::size_t block,
    const Vector<Dim>& dv
)
{
    Node increment{};
    for (int d = 0; d < Dim; ++d)
    {
        increment[d] = dv[d];
    }

    Node* nodes = state.grid.nodesOf(block);
    for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
    {
        nodes[i] += increment;
    }
}


template<int Dim>
void mpm::applyWalls
(
    State<Dim>& state,
    const std::size_t block,
    const double deltaT
)
{
    Node* nodes = state.grid.nodesOf(block);
    for (const auto& w : state.grid[block].wallNodes)
    {
        Node& node = nodes[w.node];
        if (!(node[massOf] > 0))
        {
            continue;
        }
        const Wall<Dim>& wall = state.walls[w.wall];
        if (wall.absorbs() && !state.starting)
        {
            absorb(state, block, w, deltaT);
            continue;
        }
        if (wall.isPlain() || !(deltaT > 0))
        {
            wall.act(w.normal, node);
            continue;
        }

        // A node without its whole mass of soil has not its whole area
        const Node before = node;
        const double wholeMass = state.leastDensity*w.volume;
        wall.act
        (
            w.normal,
            node,
            deltaT*wall.adhesion()*w.area/std::max(node[massOf], wholeMass)
        );
        recordNode(state, block, w, 1, before, node);
    }
}


template<int Dim>
void mpm::applyHoldingWalls
(
    State<Dim>& state,
    const std::size_t block,
    const double share
)
{
    Node* nodes = state.grid.nodesOf(block);
    for (const auto& w : state.grid[block].wallNodes)
    {
        Node& node = nodes[w.node];
        if (node[massOf] > 0 && state.walls[w.wall].holds())
        {
            const Node before = node;
            state.walls[w.wall].act(w.normal, node);
            recordNode(state, block, w, share, before, node);
        }
    }
}


template<int Dim>
void mpm::foldPatch
(
    State<Dim>& state,
    const std::size_t b,
    const double share,
    const bool momentum
)
{
    BlockGrid<Dim>& grid = state.grid;
    auto& block = grid[b];
    if (block.mirrored.empty())
    {
        grid.fold(block, grid.patchOf(b), [](std::size_t, const Node&) {});
        return;
    }
    grid.fold
    (
        block,
        grid.patchOf(b),
        [&](const std::size_t i, const Node& behind)
        {
            recordMirror(state, b, block.mirrors[i], share, behind);
            if (momentum)
            {
                block.mirrored[i] = behind[massOf];
            }
        }
    );
}


template<int Dim>
void mpm::recordMirrors
(
    State<Dim>& state,
    const std::size_t b,
    const Node* velocities,
    const double share
)
{
    const auto& block = state.grid[b];
    for (std::size_t i = 0; i < block.mirrored.size(); ++i)
    {
        const auto& m = block.mirrors[i];
        const double mass = block.mirrored[i];
        recordMirror
        (
            state,
            b,
            m,
            share,
            Node{mass, mass, mass, mass}*velocities[m.node + m.step]
        );
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim, Reach)                                                \
    template void mpm::sumVelocities<Dim, Reach>(State<Dim>&, std::size_t);

instantiate(2, 1)
instantiate(2, 2)
instantiate(2, 3)
instantiate(3, 1)
instantiate(3, 2)
instantiate(3, 3)

#undef instantiate

template void mpm::accelerate<2>(State<2>&, std::size_t, const Vector<2>&);
template void mpm::accelerate<3>(State<3>&, std::size_t, const Vector<3>&);

#define instantiate(Dim)                                                       \
    template void mpm::applyWalls(State<Dim>&, std::size_t, double);           \
    template void mpm::applyHoldingWalls(State<Dim>&, std::size_t, double);    \
    template void mpm::foldPatch(State<Dim>&, std::size_t, double, bool);      \
    template void mpm::recordMirrors                                           \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        const Node*,                                                           \
        double                                                                 \
    );

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
