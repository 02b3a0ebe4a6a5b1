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

#include "mpmGenericCycle.H"
#include "mpmGridUpdate.H"
#include "mpmSleep.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::addImpulse
(
    State<Dim>& state,
    const std::size_t b,
    const double deltaT
) const
{
    Node* nodes = state.grid.nodesOf(b);
    const Node* before = before_.data() + b*BlockGrid<Dim>::nNodes;
    state.grid.template sum<reach>(state.grid.patches, state.grid[b], nodes);

    for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
    {
        const Node impulse = nodes[i];
        nodes[i] = before[i];
        const double m = before[i][massOf];
        for (int d = 0; m > 0 && d < Dim; ++d)
        {
            nodes[i][d] += impulse[d]/m + deltaT*state.gravity[d];
        }
    }
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::keep
(
    State<Dim>& state,
    const std::size_t b,
    NodeField& field
)
{
    std::copy_n
    (
        state.grid.nodesOf(b),
        BlockGrid<Dim>::nNodes,
        field.data() + b*BlockGrid<Dim>::nNodes
    );
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::balance
(
    State<Dim>& state,
    const StressUpdate<Dim>& stress,
    const double deltaT
)
{
    typedef const std::size_t Index;

    const bool stressFirst = scheme_.update() == Scheme::Update::USF;
    if (!stressFirst && !scheme_.needsChange())
    {
        Vector<Dim> dv;
        for (int d = 0; d < Dim; ++d)
        {
            dv[d] = deltaT*state.gravity[d];
        }
        state.forBlocks
        (
            [&](Index b) { scatterPoints(state, b, true, deltaT, 1); }
        );
        state.completePatches();
        state.forBlocks
        (
            [&](Index b)
            {
                sumVelocities<Dim, reach>(state, b);
                accelerate<Dim>(state, b, dv);
                applyWalls(state, b, deltaT);
            }
        );
        return;
    }

    // What walls take from the velocities before reaches the points in part
    const double share = 1 - scheme_.kept(deltaT);
    before_.resize(state.grid.nodes.size());
    state.forBlocks
    (
        [&](Index b) { scatterPoints(state, b, true, 0, share); }
    );
    state.completePatches();
    state.forBlocks
    (
        [&](Index b)
        {
            sumVelocities<Dim, reach>(state, b);
            applyHoldingWalls(state, b, share);
            keep(state, b, before_);
            if (stressFirst)
            {
                applyWalls(state, b, 0);
            }
        }
    );
    if (stressFirst)
    {
        average(state, deltaT);
    }
    state.forBlocks
    (
        [&](Index b)
        {
            if (stressFirst)
            {
                updateAndScatter(state, b, stress, deltaT);
            }
            else
            {
                scatterPoints(state, b, false, deltaT, 1);
            }
        }
    );
    state.completePatches();
    state.forBlocks
    (
        [&](Index b)
        {
            addImpulse(state, b, deltaT);
            applyWalls(state, b, deltaT);
        }
    );
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::filter(State<Dim>& state)
{
    typedef const std::size_t Index;

    // I - (I - A)^m = A (sum over k < m of c_k A^k) with A from nodes to
    // points and back: the sum acts on the nodes, c_k = (-1)^k m!/(k+1)!/(m-k-1)!
    const std::size_t n = state.grid.nodes.size();
    double c = scheme_.order();
    filtered_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        filtered_[i] = c*before_[i];
    }
    state.grid.nodes = before_;
    for (int k = 1; k < scheme_.order(); ++k)
    {
        c *= -double(scheme_.order() - k)/(k + 1);
        state.forBlocks([&](Index b) { smooth(state, b); });
        state.completePatches();
        state.forBlocks
        (
            [&](Index b)
            {
                sumVelocities<Dim, reach>(state, b);
                applyHoldingWalls(state, b, 0);
            }
        );
        for (std::size_t i = 0; i < n; ++i)
        {
            filtered_[i] += c*state.grid.nodes[i];
        }
    }
    state.grid.nodes = after_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim, class Shape>
mpm::GenericCycle<Dim, Shape>::GenericCycle(const Settings& settings)
:
    average_(VolumeAverage<Dim, reach>::New(settings)),
    scheme_(settings)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::step
(
    State<Dim>& state,
    const double deltaT
)
{
    typedef const std::size_t Index;

    for (BlockReport<Dim>& report : state.reports)
    {
        report.reset();
    }
    if (average_)
    {
        average_->rates(state);
    }
    const StressUpdate<Dim> stress
    (
        state.laws,
        deltaT,
        state.elastic,
        state.axisymmetric,
        average_ ? average_->changes() : nullptr
    );
    balance(state, stress, deltaT);

    const bool mapsTwice = scheme_.update() == Scheme::Update::MUSL;
    if (mapsTwice || scheme_.filters())
    {
        after_ = state.grid.nodes;
    }
    if (scheme_.filters())
    {
        filter(state);
    }

    const bool stressLast = scheme_.update() == Scheme::Update::USL;
    if (stressLast)
    {
        average(state, deltaT);
    }
    state.forBlocks
    (
        [&](Index b)
        {
            gather
            (
                state, b, stressLast ? &stress : nullptr, !mapsTwice, deltaT
            );
        }
    );

    if (mapsTwice)
    {
        state.forBlocks
        (
            [&](Index b) { scatterPoints(state, b, true, 0, 0); }
        );
        state.completePatches();
        state.forBlocks
        (
            [&](Index b)
            {
                sumVelocities<Dim, reach>(state, b);
                applyWalls(state, b, 0);
            }
        );
        average(state, deltaT);
        state.forBlocks
        (
            [&](Index b) { updateAndMove(state, b, stress, deltaT); }
        );
    }
    state.forBlocks([&](Index b) { watch<Dim, reach>(state, b, deltaT); });
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::scatter
(
    State<Dim>& state,
    const double deltaT
)
{
    typedef const std::size_t Index;

    state.forBlocks
    (
        [&](Index b) { scatterPoints(state, b, true, deltaT, 0); }
    );
    state.completePatches();
    state.forBlocks
    (
        [&](Index b)
        {
            state.grid.template sum<reach>
            (
                state.grid.patches, state.grid[b], state.grid.nodesOf(b)
            );
        }
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::GenericCycle<2, mpm::LinearShape>;
template class mpm::GenericCycle<2, mpm::GIMPShape>;
template class mpm::GenericCycle<2, mpm::QuadraticBSpline>;
template class mpm::GenericCycle<2, mpm::CubicBSpline>;
template class mpm::GenericCycle<3, mpm::LinearShape>;
template class mpm::GenericCycle<3, mpm::GIMPShape>;
template class mpm::GenericCycle<3, mpm::QuadraticBSpline>;
template class mpm::GenericCycle<3, mpm::CubicBSpline>;


// ************************************************************************* //
