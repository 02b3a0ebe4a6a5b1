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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Column c of a symmetric tensor
inline Node column(const Stress<2>& s, const int c)
{
    return c == 0 ? Node{s[0], s[3], 0, 0} : Node{s[3], s[1], 0, 0};
}


inline Node column(const Stress<3>& s, const int c)
{
    return
        c == 0 ? Node{s[0], s[3], s[5], 0}
      : c == 1 ? Node{s[3], s[1], s[4], 0}
      : Node{s[5], s[4], s[2], 0};
}


inline Node all(const double a)
{
    return Node{a, a, a, a};
}


template<int Dim>
inline Node node(const Vector<Dim>& v)
{
    Node n{};
    for (int d = 0; d < Dim; ++d)
    {
        n[d] = v[d];
    }
    return n;
}


//- As many points at once as the stress update takes
template<int Dim, class Shape>
class Batch
{
public:

    Stencil<Dim, Shape> stencil[laneCount];
    std::int32_t point[laneCount];

    //- How many count; the last one is repeated
    int count;

    void take
    (
        const State<Dim>& state,
        const typename BlockGrid<Dim>::Block& block,
        const std::size_t first,
        const bool affine
    )
    {
        count = int
        (
            std::min(std::size_t(laneCount), block.points.size() - first)
        );
        for (int l = 0; l < laneCount; ++l)
        {
            point[l] = block.points[first + std::min(l, count - 1)];
            if (l < count)
            {
                stencil[l].take
                (
                    state.cloud, state.grid, block, point[l], affine
                );
            }
        }
    }
};


//- Call f(batch) for all points of a block
template<int Dim, class Shape, class Function>
inline void forBatches
(
    const State<Dim>& state,
    const typename BlockGrid<Dim>::Block& block,
    const bool affine,
    const Function& f
)
{
    Batch<Dim, Shape> batch;
    const std::size_t n = block.points.size();
    for (std::size_t i = 0; i < n; i += laneCount)
    {
        batch.take(state, block, i, affine);
        f(batch);
    }
}


//- Momentum and mass of a point
template<int Dim, class Shape>
inline void addMomentum
(
    const PointCloud<Dim>& cloud,
    const std::int32_t p,
    const Stencil<Dim, Shape>& stencil,
    const bool carriesGradient,
    Node* patch
)
{
    Node value = all(cloud.mass[p])*node<Dim>(cloud.v[p]);
    value[massOf] = cloud.mass[p];
    if (carriesGradient)
    {
        Node slope[Dim] = {};
        for (int c = 0; c < Dim; ++c)
        {
            for (int r = 0; r < Dim; ++r)
            {
                slope[c][r] = cloud.mass[p]*cloud.C[p][c*Dim + r];
            }
        }
        stencil.forNodes
        (
            [&]
            (
                const int i,
                const double w,
                const Vector<Dim>&,
                const Vector<Dim>& distance
            )
            {
                Node q = value;
                for (int c = 0; c < Dim; ++c)
                {
                    q += all(distance[c])*slope[c];
                }
                patch[i] += all(w)*q;
            }
        );
    }
    else
    {
        stencil.forNodes
        (
            [&]
            (
                const int i,
                const double w,
                const Vector<Dim>&,
                const Vector<Dim>&
            )
            {
                patch[i] += all(w)*value;
            }
        );
    }
}


//- What the stress of a point gives in this time
template<int Dim, class Shape>
inline void addStress
(
    const State<Dim>& state,
    const std::int32_t p,
    const Stencil<Dim, Shape>& stencil,
    const double deltaT,
    Node* patch
)
{
    const PointCloud<Dim>& cloud = state.cloud;
    Node traction[Dim];
    for (int c = 0; c < Dim; ++c)
    {
        traction[c] = all(deltaT*cloud.volume[p])*column(cloud.sigma[p], c);
    }

    // The hoop stress of the whole circle, towards the axis
    Node hoop{};
    if (state.axisymmetric)
    {
        hoop[0] =
            deltaT*cloud.volume[p]*cloud.sigma[p][2]/state.radius(cloud.x[p]);
    }
    stencil.forNodes
    (
        [&]
        (
            const int i,
            const double w,
            const Vector<Dim>& gradient,
            const Vector<Dim>&
        )
        {
            Node force = all(w)*hoop;
            for (int c = 0; c < Dim; ++c)
            {
                force += all(gradient[c])*traction[c];
            }
            patch[i] -= force;
        }
    );
}


//- Velocity of the nodes where a point is
template<int Dim, class Shape>
inline Node velocityAt(const Stencil<Dim, Shape>& stencil, const Node* patch)
{
    Node v{};
    stencil.forNodes
    (
        [&]
        (
            const int i,
            const double w,
            const Vector<Dim>&,
            const Vector<Dim>&
        )
        {
            v += all(w)*patch[i];
        }
    );
    return v;
}


//- Gradient of the nodes' velocity there, column by column
template<int Dim, class Shape>
inline void gradientAt
(
    const Stencil<Dim, Shape>& stencil,
    const Node* patch,
    Node* gradient
)
{
    for (int c = 0; c < Dim; ++c)
    {
        gradient[c] = Node{};
    }
    stencil.forNodes
    (
        [&]
        (
            const int i,
            const double,
            const Vector<Dim>& slope,
            const Vector<Dim>&
        )
        {
            for (int c = 0; c < Dim; ++c)
            {
                gradient[c] += all(slope[c])*patch[i];
            }
        }
    );
}


//- The affine gradient there, column by column
template<int Dim, class Shape>
inline void affineAt
(
    const Stencil<Dim, Shape>& stencil,
    const Node* patch,
    Node* gradient
)
{
    for (int c = 0; c < Dim; ++c)
    {
        gradient[c] = Node{};
    }
    stencil.forNodes
    (
        [&]
        (
            const int i,
            const double w,
            const Vector<Dim>&,
            const Vector<Dim>& distance
        )
        {
            for (int c = 0; c < Dim; ++c)
            {
                gradient[c] += all(w*distance[c])*patch[i];
            }
        }
    );
    for (int c = 0; c < Dim; ++c)
    {
        gradient[c] *= all(1/stencil.moment(c));
    }
}


//- Stress of the points of a batch from velocities of the nodes
template<int Dim, class Shape>
inline void updateStress
(
    State<Dim>& state,
    const Batch<Dim, Shape>& batch,
    const Node* patch,
    const StressUpdate<Dim>& stressUpdate,
    BlockReport<Dim>& report
)
{
    constexpr int hoop = Dim*Dim;
    Lanes L[Dim*Dim + 1];
    L[hoop] = Lanes(0.0);
    for (int l = 0; l < batch.count; ++l)
    {
        Node gradient[Dim];
        gradientAt(batch.stencil[l], patch, gradient);
        for (int k = 0; k < Dim*Dim; ++k)
        {
            L[k].v[l] = gradient[k/Dim][k%Dim];
        }
        if (state.axisymmetric)
        {
            L[hoop].v[l] =
                velocityAt(batch.stencil[l], patch)[0]
               /state.radius(state.cloud.x[batch.point[l]]);
        }
    }
    for (int l = batch.count; l < laneCount; ++l)
    {
        for (Lanes& entry : L)
        {
            entry.v[l] = entry.v[batch.count - 1];
        }
    }

    const Lanes wave2 =
        stressUpdate.update(state.cloud, batch.point, batch.count, L);
    for (int l = 0; l < batch.count; ++l)
    {
        report.wave2 = std::max(report.wave2, wave2[l]);

        // Neither zero or less, nor not a number
        if (!(wave2[l] > 0))
        {
            report.broken = batch.point[l];
        }
    }
}


//- Move a point with the nodes; whether it stays in the block
template<int Dim, class Shape>
inline bool move
(
    State<Dim>& state,
    const typename BlockGrid<Dim>::Block& block,
    const std::int32_t p,
    const Stencil<Dim, Shape>& stencil,
    const Node* patch,
    const Node& velocity,
    const double deltaT,
    BlockReport<Dim>& report
)
{
    PointCloud<Dim>& cloud = state.cloud;
    if constexpr (Shape::sized)
    {
        if (state.sizesFollow)
        {
            Node gradient[Dim];
            gradientAt(stencil, patch, gradient);
            for (int d = 0; d < Dim; ++d)
            {
                cloud.halfSize[p][d] *= 1 + deltaT*gradient[d][d];
            }
        }
    }

    const Node dx = all(deltaT)*velocity;
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
    return belongs<Dim, Shape>(state, block, p, report);
}

} // End anonymous namespace
} // End namespace mpm


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
