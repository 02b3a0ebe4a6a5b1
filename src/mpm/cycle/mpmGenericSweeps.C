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
#include "mpmPointBatch.H"
#include "mpmSleep.H"

using namespace mpm::points;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::addPoints
(
    State<Dim>& state,
    const std::size_t b,
    const bool momentum,
    const double impulseTime
) const
{
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, nPatchNodes, Node{});

    const PointCloud<Dim>& cloud = state.cloud;
    const bool carriesGradient = scheme_.carriesGradient();
    forBatches<Dim, Shape>
    (
        state,
        state.grid[b],
        scheme_.affine(),
        [&](const Batch<Dim, Shape>& batch)
        {
            for (int l = 0; l < batch.count; ++l)
            {
                const std::int32_t p = batch.point[l];
                const Stencil& stencil = batch.stencil[l];
                if (momentum)
                {
                    addMomentum(cloud, p, stencil, carriesGradient, patch);
                }
                if (impulseTime > 0)
                {
                    addStress(state, p, stencil, impulseTime, patch);
                }
            }
        }
    );
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::scatterPoints
(
    State<Dim>& state,
    const std::size_t b,
    const bool momentum,
    const double impulseTime,
    const double recordedShare
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }
    if (block.rest.asleep)
    {
        scatterAsleep
        (
            state.grid, b, momentum, impulseTime,
            [&]() { addPoints(state, b, true, 1); }
        );
    }
    else
    {
        addPoints(state, b, momentum, impulseTime);
    }
    foldPatch(state, b, recordedShare, momentum);
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::updateAndScatter
(
    State<Dim>& state,
    const std::size_t b,
    const StressUpdate<Dim>& stressUpdate,
    const double deltaT
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }
    if (block.rest.asleep)
    {
        scatterPoints(state, b, false, deltaT, 1);
        return;
    }
    alignas(64) Node velocity[nPatchNodes];
    state.grid.template collect<reach>(state.grid.nodes, block, velocity);
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, nPatchNodes, Node{});

    forBatches<Dim, Shape>
    (
        state,
        block,
        scheme_.affine(),
        [&](const Batch<Dim, Shape>& batch)
        {
            updateStress
            (
                state, batch, velocity, stressUpdate, state.reports[b]
            );
            for (int l = 0; l < batch.count; ++l)
            {
                addStress
                (
                    state, batch.point[l], batch.stencil[l], deltaT, patch
                );
            }
        }
    );
    foldPatch(state, b, 1, false);
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::gather
(
    State<Dim>& state,
    const std::size_t b,
    const StressUpdate<Dim>* stressUpdate,
    const bool moves,
    const double deltaT
) const
{
    Block& block = state.grid[b];
    if (block.points.empty() || block.rest.asleep)
    {
        state.reports[b].wave2 = block.rest.wave2;
        return;
    }
    alignas(64) Node after[nPatchNodes];
    alignas(64) Node before[nPatchNodes];
    alignas(64) Node filtered[nPatchNodes];
    const BlockGrid<Dim>& grid = state.grid;
    const bool needsChange = scheme_.needsChange();
    grid.template collect<reach>(grid.nodes, block, after);
    recordMirrors(state, b, after, 1);
    if (needsChange)
    {
        grid.template collect<reach>(before_, block, before);
        recordMirrors(state, b, before, -scheme_.kept(deltaT));
    }
    if (scheme_.filters())
    {
        grid.template collect<reach>(filtered_, block, filtered);
    }

    const Node share = all(scheme_.share(deltaT));
    PointCloud<Dim>& cloud = state.cloud;
    BlockReport<Dim>& report = state.reports[b];
    std::size_t kept = 0;
    forBatches<Dim, Shape>
    (
        state,
        block,
        scheme_.affine(),
        [&](const Batch<Dim, Shape>& batch)
        {
            Node onGrid[laneCount];
            for (int l = 0; l < batch.count; ++l)
            {
                const std::int32_t p = batch.point[l];
                const Stencil& stencil = batch.stencil[l];
                Node v = onGrid[l] = velocityAt(stencil, after);
                if (scheme_.filters())
                {
                    v +=
                        velocityAt(stencil, filtered)
                      - velocityAt(stencil, before);
                }
                else if (needsChange)
                {
                    v +=
                        share
                       *(node<Dim>(cloud.v[p]) - velocityAt(stencil, before));
                }
                for (int d = 0; d < Dim; ++d)
                {
                    cloud.v[p][d] = v[d];
                }

                if (scheme_.carriesGradient())
                {
                    Node gradient[Dim];
                    if (Shape::sized && scheme_.affine())
                    {
                        affineAt(stencil, after, gradient);
                    }
                    else
                    {
                        gradientAt(stencil, after, gradient);
                    }
                    for (int k = 0; k < Dim*Dim; ++k)
                    {
                        cloud.C[p][k] = gradient[k/Dim][k%Dim];
                    }
                }
            }

            if (stressUpdate)
            {
                updateStress(state, batch, after, *stressUpdate, report);
            }
            for (int l = 0; moves && l < batch.count; ++l)
            {
                const std::int32_t p = batch.point[l];
                const bool stays = move
                (
                    state, block, p, batch.stencil[l], after, onGrid[l], deltaT,
                    report
                );
                if (stays)
                {
                    block.points[kept++] = p;
                }
            }
        }
    );
    if (moves)
    {
        block.points.resize(kept);
    }
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::updateAndMove
(
    State<Dim>& state,
    const std::size_t b,
    const StressUpdate<Dim>& stressUpdate,
    const double deltaT
) const
{
    Block& block = state.grid[b];
    if (block.points.empty() || block.rest.asleep)
    {
        state.reports[b].wave2 = block.rest.wave2;
        return;
    }
    alignas(64) Node mapped[nPatchNodes];
    alignas(64) Node after[nPatchNodes];
    state.grid.template collect<reach>(state.grid.nodes, block, mapped);
    state.grid.template collect<reach>(after_, block, after);

    BlockReport<Dim>& report = state.reports[b];
    std::size_t kept = 0;
    forBatches<Dim, Shape>
    (
        state,
        block,
        scheme_.affine(),
        [&](const Batch<Dim, Shape>& batch)
        {
            updateStress(state, batch, mapped, stressUpdate, report);
            for (int l = 0; l < batch.count; ++l)
            {
                const std::int32_t p = batch.point[l];
                const Stencil& stencil = batch.stencil[l];
                const bool stays = move
                (
                    state, block, p, stencil, after, velocityAt(stencil, after),
                    deltaT, report
                );
                if (stays)
                {
                    block.points[kept++] = p;
                }
            }
        }
    );
    block.points.resize(kept);
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::smooth
(
    State<Dim>& state,
    const std::size_t b
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty())
    {
        return;
    }
    alignas(64) Node velocity[nPatchNodes];
    state.grid.template collect<reach>(state.grid.nodes, block, velocity);
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, nPatchNodes, Node{});

    forBatches<Dim, Shape>
    (
        state,
        block,
        scheme_.affine(),
        [&](const Batch<Dim, Shape>& batch)
        {
            for (int l = 0; l < batch.count; ++l)
            {
                const double mass = state.cloud.mass[batch.point[l]];
                Node q = all(mass)*velocityAt(batch.stencil[l], velocity);
                q[massOf] = mass;
                batch.stencil[l].forNodes
                (
                    [&]
                    (
                        const int i,
                        const double w,
                        const Vector<Dim>&,
                        const Vector<Dim>&
                    )
                    {
                        patch[i] += all(w)*q;
                    }
                );
            }
        }
    );
    foldPatch(state, b, 0, false);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim, Shape)                                                \
    template void mpm::GenericCycle<Dim, mpm::Shape>::addPoints                \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        bool,                                                                  \
        double                                                                 \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::scatterPoints            \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        bool,                                                                  \
        double,                                                                \
        double                                                                 \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::updateAndScatter         \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        const StressUpdate<Dim>&,                                              \
        double                                                                 \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::gather                   \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        const StressUpdate<Dim>*,                                              \
        bool,                                                                  \
        double                                                                 \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::updateAndMove            \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t,                                                           \
        const StressUpdate<Dim>&,                                              \
        double                                                                 \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::smooth                   \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t                                                            \
    ) const;

instantiate(2, LinearShape)
instantiate(2, GIMPShape)
instantiate(2, QuadraticBSpline)
instantiate(2, CubicBSpline)
instantiate(3, LinearShape)
instantiate(3, GIMPShape)
instantiate(3, QuadraticBSpline)
instantiate(3, CubicBSpline)

#undef instantiate


// ************************************************************************* //
