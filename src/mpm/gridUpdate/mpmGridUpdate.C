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
void mpm::applyWalls(State<Dim>& state, const std::size_t block)
{
    Node* nodes = state.grid.nodesOf(block);
    for (const auto& w : state.grid[block].wallNodes)
    {
        if (nodes[w.node][massOf] > 0)
        {
            state.walls[w.wall].act(w.normal, nodes[w.node]);
        }
    }
}


template<int Dim>
void mpm::applyHoldingWalls(State<Dim>& state, const std::size_t block)
{
    Node* nodes = state.grid.nodesOf(block);
    for (const auto& w : state.grid[block].wallNodes)
    {
        if (nodes[w.node][massOf] > 0 && state.walls[w.wall].holds())
        {
            state.walls[w.wall].act(w.normal, nodes[w.node]);
        }
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
template void mpm::applyWalls(State<2>&, std::size_t);
template void mpm::applyWalls(State<3>&, std::size_t);
template void mpm::applyHoldingWalls(State<2>&, std::size_t);
template void mpm::applyHoldingWalls(State<3>&, std::size_t);


// ************************************************************************* //
