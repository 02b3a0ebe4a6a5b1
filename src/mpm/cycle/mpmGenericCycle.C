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
#include "mpmStencil.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::balance
(
    State<Dim>& state,
    const std::size_t b,
    const double deltaT
)
{
    Node* nodes = state.grid.nodesOf(b);
    const Node* forces = forces_.data() + b*BlockGrid<Dim>::nNodes;
    const Node* before = before_.data() + b*BlockGrid<Dim>::nNodes;

    for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
    {
        nodes[i] = before[i];
        const double m = nodes[i][massOf];
        for (int d = 0; m > 0 && d < Dim; ++d)
        {
            nodes[i][d] += deltaT*(forces[i][d]/m + state.gravity[d]);
        }
    }
    applyWalls(state, b);
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::updateStress
(
    State<Dim>& state,
    const std::size_t b,
    const NodeField& velocity,
    const StressUpdate<Dim>& stressUpdate
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }

    alignas(64) Node patch[BlockGrid<Dim>::nPatchNodes];
    state.grid.collect(velocity, block, patch);

    Stencil<Dim, Shape> stencil(state.grid.cellSize(), affine_);
    for (std::size_t i = 0; i < block.points.size(); i += stencil.size)
    {
        stencil.take(state.cloud.x, state.grid, block, i);
        for (int first = 0; first < stencil.count(); first += laneCount)
        {
            Lanes L[Dim*Dim];
            for (int k = 0; k < Dim*Dim; ++k)
            {
                L[k] = Lanes(0.0);
            }
            for (int l = 0; l < laneCount; ++l)
            {
                stencil.forNodes
                (
                    first + l,
                    [&]
                    (
                        const int node,
                        const double,
                        const Vector<Dim>& gradient,
                        const Vector<Dim>&
                    )
                    {
                        for (int k = 0; k < Dim*Dim; ++k)
                        {
                            L[k].v[l] += patch[node][k%Dim]*gradient[k/Dim];
                        }
                    }
                );
            }

            const int count = std::min(laneCount, stencil.count() - first);
            const Lanes wave2 = stressUpdate.update
            (
                state.cloud, stencil.points() + first, count, L
            );
            for (int l = 0; l < count; ++l)
            {
                BlockReport<Dim>& report = state.reports[b];
                report.wave2 = std::max(report.wave2, wave2.v[l]);
                if (!(wave2.v[l] > 0))
                {
                    report.broken = stencil.points()[first + l];
                }
            }
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
void mpm::GenericCycle<Dim, Shape>::gather
(
    State<Dim>& state,
    const std::size_t b,
    const double deltaT
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }

    alignas(64) Node after[BlockGrid<Dim>::nPatchNodes];
    alignas(64) Node before[BlockGrid<Dim>::nPatchNodes];
    state.grid.collect(after_, block, after);
    state.grid.collect(before_, block, before);

    const Settings& settings = state.settings;
    const double share =
        affine_ ? 0
      : settings.flipBlend >= 0 ? settings.flipBlend
      : std::exp(-deltaT/settings.flipTime);

    PointCloud<Dim>& cloud = state.cloud;
    Stencil<Dim, Shape> stencil(state.grid.cellSize(), affine_);
    for (std::size_t i = 0; i < block.points.size(); i += stencil.size)
    {
        stencil.take(cloud.x, state.grid, block, i);
        for (int l = 0; l < stencil.count(); ++l)
        {
            const std::int32_t p = stencil.points()[l];
            Vector<Dim> v{}, change{};
            Tensor<Dim> C{};
            stencil.forNodes
            (
                l,
                [&]
                (
                    const int node,
                    const double weight,
                    const Vector<Dim>& gradient,
                    const Vector<Dim>&
                )
                {
                    for (int r = 0; r < Dim; ++r)
                    {
                        v[r] += weight*after[node][r];
                        change[r] +=
                            weight*(after[node][r] - before[node][r]);
                        for (int c = 0; c < Dim; ++c)
                        {
                            C[c*Dim + r] += after[node][r]*gradient[c];
                        }
                    }
                }
            );

            for (int d = 0; d < Dim; ++d)
            {
                cloud.v[p][d] =
                    share*(cloud.v[p][d] + change[d]) + (1 - share)*v[d];
            }
            if (affine_)
            {
                cloud.C[p] = C;
            }
        }
    }
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::move
(
    State<Dim>& state,
    const std::size_t b,
    const double deltaT
) const
{
    Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }

    alignas(64) Node after[BlockGrid<Dim>::nPatchNodes];
    state.grid.collect(after_, block, after);

    PointCloud<Dim>& cloud = state.cloud;
    BlockReport<Dim>& report = state.reports[b];
    Stencil<Dim, Shape> stencil(state.grid.cellSize(), affine_);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < block.points.size(); i += stencil.size)
    {
        stencil.take(cloud.x, state.grid, block, i);
        for (int l = 0; l < stencil.count(); ++l)
        {
            Vector<Dim> dx{};
            stencil.forNodes
            (
                l,
                [&]
                (
                    const int node,
                    const double weight,
                    const Vector<Dim>&,
                    const Vector<Dim>&
                )
                {
                    for (int d = 0; d < Dim; ++d)
                    {
                        dx[d] += deltaT*weight*after[node][d];
                    }
                }
            );

            const std::int32_t p = stencil.points()[l];
            double speed2 = 0;
            for (int d = 0; d < Dim; ++d)
            {
                cloud.x[p][d] += dx[d];
                cloud.displacement[p][d] += dx[d];
                speed2 += cloud.v[p][d]*cloud.v[p][d];
            }
            report.speed2 = std::max(report.speed2, speed2);
            report.kineticEnergy += 0.5*cloud.mass[p]*speed2;

            project(state, block, p, report);
            if (belongs<Dim, Shape>(state, block, p, report))
            {
                block.points[kept++] = p;
            }
        }
    }
    block.points.resize(kept);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim, class Shape>
mpm::GenericCycle<Dim, Shape>::GenericCycle(const Settings& settings)
:
    affine_(settings.transferScheme == "APIC"),
    stressFirst_(settings.stressUpdate == "first")
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

    BlockGrid<Dim>& grid = state.grid;
    before_.resize(grid.nodes.size());
    after_.resize(grid.nodes.size());
    forces_.resize(grid.nodes.size());

    const StressUpdate<Dim> stress(state.laws, deltaT, state.elastic);

    state.forBlocks
    (
        [&](Index b)
        {
            state.reports[b].reset();
            scatterMomentum(state, b);
        }
    );
    state.forBlocks
    (
        [&](Index b)
        {
            sumVelocities(state, b);
            keep(state, b, before_);
            if (stressFirst_)
            {
                applyWalls(state, b);
            }
        }
    );

    if (stressFirst_)
    {
        state.forBlocks
        (
            [&](Index b) { updateStress(state, b, grid.nodes, stress); }
        );
    }
    state.forBlocks([&](Index b) { scatterForces(state, b); });
    state.forBlocks
    (
        [&](Index b)
        {
            sumForces(state, b);
            balance(state, b, deltaT);
            keep(state, b, after_);
        }
    );
    state.forBlocks([&](Index b) { gather(state, b, deltaT); });

    if (!stressFirst_ && !affine_)
    {
        state.forBlocks([&](Index b) { scatterMomentum(state, b); });
        state.forBlocks
        (
            [&](Index b)
            {
                sumVelocities(state, b);
                applyWalls(state, b);
            }
        );
    }
    if (!stressFirst_)
    {
        state.forBlocks
        (
            [&](Index b) { updateStress(state, b, grid.nodes, stress); }
        );
    }
    state.forBlocks([&](Index b) { move(state, b, deltaT); });
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::scatter
(
    State<Dim>& state,
    const double deltaT
)
{
    typedef const std::size_t Index;

    BlockGrid<Dim>& grid = state.grid;
    forces_.resize(grid.nodes.size());

    state.forBlocks([&](Index b) { scatterForces(state, b); });
    state.forBlocks([&](Index b) { sumForces(state, b); });
    state.forBlocks([&](Index b) { scatterMomentum(state, b); });
    state.forBlocks
    (
        [&](Index b)
        {
            Node* nodes = grid.nodesOf(b);
            const Node* forces =
                forces_.data() + b*BlockGrid<Dim>::nNodes;
            grid.sum(grid.patches, grid[b], nodes);
            for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
            {
                for (int d = 0; d < Dim; ++d)
                {
                    nodes[i][d] += deltaT*forces[i][d];
                }
            }
        }
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::GenericCycle<2, mpm::QuadraticBSpline>;
template class mpm::GenericCycle<3, mpm::QuadraticBSpline>;
template class mpm::GenericCycle<2, mpm::LinearShape>;
template class mpm::GenericCycle<3, mpm::LinearShape>;


// ************************************************************************* //
