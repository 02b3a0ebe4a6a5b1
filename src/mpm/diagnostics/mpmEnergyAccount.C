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

#include "mpmEnergyAccount.H"
#include "mpmReduce.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

template<int Dim, class A, class B>
double product(const A& a, const B& b)
{
    double sum = 0;
    for (int d = 0; d < Dim; ++d)
    {
        sum += a[d]*b[d];
    }
    return sum;
}


//- Make n orthogonal to the axes and of unit length, and add it to them; false
//  if nothing is left of it
template<int Dim>
bool addAxis(Vector<Dim> n, Vector<Dim>* axes, int& nAxes)
{
    for (int a = 0; a < nAxes; ++a)
    {
        const double along = product<Dim>(n, axes[a]);
        for (int d = 0; d < Dim; ++d)
        {
            n[d] -= along*axes[a][d];
        }
    }
    constexpr double least = 1e-6;
    const double square = product<Dim>(n, n);
    if (nAxes == Dim || square < least)
    {
        return false;
    }
    for (double& c : n)
    {
        c /= std::sqrt(square);
    }
    axes[nAxes++] = n;
    return true;
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
double mpm::EnergyAccount<Dim>::ofNode(const Node& node)
{
    return 0.5*node[massOf]*product<Dim>(node, node);
}


template<int Dim>
void mpm::EnergyAccount<Dim>::divide
(
    const State<Dim>& state,
    NodeField& nodes
)
{
    const double least = state.settings.massCutOff*state.maxMass;
    for (Node& node : nodes)
    {
        if (!(node[massOf] > least))
        {
            node = Node{};
        }
        for (int d = 0; node[massOf] > 0 && d < Dim; ++d)
        {
            node[d] /= node[massOf];
        }
    }
}


template<int Dim>
void mpm::EnergyAccount<Dim>::keepOwn
(
    const State<Dim>& state,
    NodeField& nodes
)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const auto& block = state.grid[i/BlockGrid<Dim>::nNodes];
        if (!state.grid.isOwn(block, int(i % BlockGrid<Dim>::nNodes)))
        {
            nodes[i] = Node{};
        }
    }
}


template<int Dim>
void mpm::EnergyAccount<Dim>::addPoints
(
    const State<Dim>& state,
    const Cycle<Dim>& cycle,
    const double sign
)
{
    const double h = state.settings.cellSize;
    const double secondMoment = cycle.secondMoment()*h*h;
    const PointCloud<Dim>& cloud = state.cloud;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const double square = product<Dim>(cloud.v[i], cloud.v[i]);
        const double affine = product<Dim*Dim>(cloud.C[i], cloud.C[i]);
        transfers_.add(sign*0.5*cloud.mass[i]*(square + secondMoment*affine));
    }
}


template<int Dim>
void mpm::EnergyAccount<Dim>::addWalls
(
    const State<Dim>& state,
    const std::size_t block
)
{
    const std::size_t first = block*BlockGrid<Dim>::nNodes;

    // Walls of one node side by side
    auto wallNodes = state.grid[block].wallNodes;
    std::stable_sort
    (
        wallNodes.begin(),
        wallNodes.end(),
        [](const auto& a, const auto& b) { return a.node < b.node; }
    );
    for (std::size_t w = 0; w < wallNodes.size();)
    {
        const std::int32_t i = wallNodes[w].node;
        const Node& before = before_[first + i];
        const Node& after = state.grid.nodes[first + i];
        const Node impulse = before[massOf]*(after - unwalled_[first + i]);
        const Node mean = 0.5*(after + before);

        // Along the normals of all its walls, and across them
        Vector<Dim> axes[Dim];
        int nAxes = 0;
        double normalWork = 0;
        for (; w < wallNodes.size() && wallNodes[w].node == i; ++w)
        {
            if (addAxis<Dim>(wallNodes[w].normal, axes, nAxes))
            {
                const Vector<Dim>& n = axes[nAxes - 1];
                normalWork += product<Dim>(impulse, n)*product<Dim>(mean, n);
            }
        }
        impact_.add(-normalWork);
        friction_.add(normalWork - product<Dim>(impulse, mean));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::EnergyAccount<Dim>::begin
(
    State<Dim>& state,
    Cycle<Dim>& cycle,
    const double deltaT
)
{
    friction_ = impact_ = transfers_ = integration_ = ExactSum();

    cycle.scatter(state, 0);
    before_ = state.grid.nodes;
    divide(state, before_);

    // The step may empty blocks, on which ownership depends
    keepOwn(state, before_);

    cycle.scatter(state, deltaT);
    unwalled_ = state.grid.nodes;
    divide(state, unwalled_);
    for (Node& node : unwalled_)
    {
        for (int d = 0; d < Dim; ++d)
        {
            node[d] += deltaT*state.gravity[d];
        }
    }

    addPoints(state, cycle, 1);
    for (const Node& node : before_)
    {
        transfers_.add(-ofNode(node));
    }
}


template<int Dim>
void mpm::EnergyAccount<Dim>::end
(
    const State<Dim>& state,
    const Cycle<Dim>& cycle,
    EnergyLosses& losses
)
{
    const std::size_t nBlocks = before_.size()/BlockGrid<Dim>::nNodes;
    for (std::size_t b = 0; b < nBlocks; ++b)
    {
        addWalls(state, b);
    }
    for (std::size_t i = 0; i < before_.size(); ++i)
    {
        const Node& before = before_[i];
        const Node& after = state.grid.nodes[i];
        if (before[massOf] > 0)
        {
            transfers_.add(ofNode(after));
            const Node impulse = before[massOf]*(unwalled_[i] - before);
            integration_.add(0.5*product<Dim>(impulse, after - before));
        }
    }
    addPoints(state, cycle, -1);

    std::vector<double> nothing;
    std::vector<ExactSum> sums{friction_, impact_, transfers_, integration_};
    reduceExact(*state.communicator, nothing, sums);
    losses.friction += sums[0].value();
    losses.impact += sums[1].value();
    losses.transfers += sums[2].value();
    losses.integration += sums[3].value();
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::EnergyAccount<2>;
template class mpm::EnergyAccount<3>;


// ************************************************************************* //
