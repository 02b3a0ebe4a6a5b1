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
#include "mpmLinearFlipCycle.H"
#include "mpmMoveBatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

template<int Dim>
using Batch = ShapeBatch<Dim, LinearShape>;


//- Of the weights' slopes in a cell: -1 and 1
constexpr double sign[2] = {-1, 1};


//- Call f(first node of a row along x, y, z, weights in y and z) for the rows
//  of nodes of a point; in a section z is 0 and its weight 1
template<int Dim, class Function>
inline void forRows(const Batch<Dim>& batch, const int l, const Function& f)
{
    constexpr int edge = Batch<Dim>::patchEdge;
    constexpr int last = Dim - 1;

    for (int z = 0; z < (Dim == 2 ? 1 : 2); ++z)
    {
        const double wz = Dim == 2 ? 1 : batch.w[last][z][l];
        for (int y = 0; y < 2; ++y)
        {
            f
            (
                batch.node[l] + edge*(y + edge*z),
                y, z, batch.w[1][y][l], wz
            );
        }
    }
}


//- Momentum and mass
template<int Dim>
inline void addMomentum
(
    const Batch<Dim>& batch,
    const int l,
    const PointCloud<Dim>& cloud,
    Node* patch
)
{
    const std::int32_t p = batch.point[l];
    const Node q = all(cloud.mass[p])*(nodeOf(cloud.v[p]) + Node{0, 0, 0, 1});
    forRows<Dim>
    (
        batch,
        l,
        [&]
        (
            const int node, const int, const int,
            const double wy, const double wz
        )
        {
            const Node row = all(wy*wz)*q;
            patch[node] += all(batch.w[0][0][l])*row;
            patch[node + 1] += all(batch.w[0][1][l])*row;
        }
    );
}


//- Columns of the stress
inline void tractions(const Stress<2>& s, Node* t)
{
    const Node sigma = four(s.data());
    const Node none{};
    t[0] = __builtin_shuffle(sigma, none, Pick{0, 3, 4, 4});
    t[1] = __builtin_shuffle(sigma, none, Pick{3, 1, 4, 4});
}


inline void tractions(const Stress<3>& s, Node* t)
{
    t[0] = Node{s[0], s[3], s[5], 0};
    t[1] = Node{s[3], s[1], s[4], 0};
    t[2] = Node{s[5], s[4], s[2], 0};
}


//- What the stress gives in this time over the length of a cell
template<int Dim>
inline void addStress
(
    const Batch<Dim>& batch,
    const int l,
    const PointCloud<Dim>& cloud,
    const double timePerCell,
    Node* patch
)
{
    const std::int32_t p = batch.point[l];
    Node t[3] = {};
    tractions(cloud.sigma[p], t);
    for (int c = 0; c < Dim; ++c)
    {
        t[c] *= all(-timePerCell*cloud.volume[p]);
    }
    forRows<Dim>
    (
        batch,
        l,
        [&]
        (
            const int node, const int y, const int z,
            const double wy, const double wz
        )
        {
            const Node along = all(wy*wz)*t[0];
            Node across = all(sign[y]*wz)*t[1];
            if constexpr (Dim == 3)
            {
                across += all(sign[z]*wy)*t[2];
            }
            patch[node] += all(batch.w[0][0][l])*across - along;
            patch[node + 1] += all(batch.w[0][1][l])*across + along;
        }
    );
}


template<int Dim>
inline Node velocityAt(const Batch<Dim>& batch, const int l, const Node* patch)
{
    Node v{};
    forRows<Dim>
    (
        batch,
        l,
        [&]
        (
            const int node, const int, const int,
            const double wy, const double wz
        )
        {
            v += all(wy*wz)
               *(
                    all(batch.w[0][0][l])*patch[node]
                  + all(batch.w[0][1][l])*patch[node + 1]
                );
        }
    );
    return v;
}


//- Gradient of the nodes' velocity, column by column, times the cell size
template<int Dim>
inline void gradientAt
(
    const Batch<Dim>& batch,
    const int l,
    const Node* patch,
    Node* gradient
)
{
    Node gx{}, gy{}, gz{};
    forRows<Dim>
    (
        batch,
        l,
        [&]
        (
            const int node, const int y, const int z,
            const double wy, const double wz
        )
        {
            const Node row =
                all(batch.w[0][0][l])*patch[node]
              + all(batch.w[0][1][l])*patch[node + 1];
            gx += all(wy*wz)*(patch[node + 1] - patch[node]);
            gy += all(sign[y]*wz)*row;
            gz += all(sign[z]*wy)*row;
        }
    );
    gradient[0] = gx;
    gradient[1] = gy;
    gradient[Dim - 1] = Dim == 2 ? gy : gz;
}


//- Call f(batch, place of its first point in the list) for all points
template<int Dim, class Function>
inline void forBatches
(
    const State<Dim>& state,
    const typename BlockGrid<Dim>::Block& block,
    const Function& f
)
{
    Batch<Dim> batch;
    const std::size_t n = block.points.size();
    for (std::size_t i = 0; i < n; i += Batch<Dim>::size)
    {
        batch.take
        (
            state.cloud.x, state.grid, block, block.points.data() + i, n - i
        );
        f(batch);
    }
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::LinearFlipCycle<Dim>::scatterPoints
(
    State<Dim>& state,
    const std::size_t b,
    const bool momentum,
    const double impulseTime,
    const double recordedShare
) const
{
    const Block& block = state.grid[b];
    if (impulseTime > 0 || block.rest.asleep)
    {
        Generic::scatterPoints(state, b, momentum, impulseTime, recordedShare);
        return;
    }
    if (block.points.empty())
    {
        return;
    }
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, nPatchNodes, Node{});
    forBatches<Dim>
    (
        state,
        block,
        [&](const Batch& batch)
        {
            for (int l = 0; l < batch.count; ++l)
            {
                addMomentum<Dim>(batch, l, state.cloud, patch);
            }
        }
    );
    foldPatch(state, b, recordedShare, true);
}


template<int Dim>
void mpm::LinearFlipCycle<Dim>::updateAndScatter
(
    State<Dim>& state,
    const std::size_t b,
    const StressUpdate<Dim>& stressUpdate,
    const double deltaT
) const
{
    const Block& block = state.grid[b];
    if (block.points.empty() || block.rest.asleep)
    {
        Generic::updateAndScatter(state, b, stressUpdate, deltaT);
        return;
    }
    alignas(64) Node velocity[nPatchNodes];
    state.grid.template collect<reach>(state.grid.nodes, block, velocity);
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, nPatchNodes, Node{});

    const double perCell = 1/state.grid.cellSize();
    BlockReport<Dim>& report = state.reports[b];
    Lanes wave2(0.0);
    forBatches<Dim>
    (
        state,
        block,
        [&](const Batch& batch)
        {
            Node rows[Dim][laneCount];
            for (int l = 0; l < laneCount; ++l)
            {
                Node gradient[Dim];
                gradientAt<Dim>(batch, l, velocity, gradient);
                for (int c = 0; c < Dim; ++c)
                {
                    rows[c][l] = all(perCell)*gradient[c];
                }
            }
            Lanes L[Dim*Dim];
            for (int c = 0; c < Dim; ++c)
            {
                columns<Dim>(rows[c], L + c*Dim);
            }

            const Lanes speeds =
                stressUpdate.update(state.cloud, batch.point, batch.count, L);
            wave2 = maxOf(wave2, speeds);
            findBroken(speeds, batch.point, report);
            for (int l = 0; l < batch.count; ++l)
            {
                addStress<Dim>(batch, l, state.cloud, deltaT*perCell, patch);
            }
        }
    );
    report.wave2 = largest(wave2);
    foldPatch(state, b, 1, false);
}


template<int Dim>
void mpm::LinearFlipCycle<Dim>::gather
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
        Generic::gather(state, b, stressUpdate, moves, deltaT);
        return;
    }
    alignas(64) Node after[nPatchNodes];
    alignas(64) Node before[nPatchNodes];
    state.grid.template collect<reach>(state.grid.nodes, block, after);
    state.grid.template collect<reach>(this->before_, block, before);
    recordMirrors(state, b, after, 1);
    recordMirrors(state, b, before, -this->scheme_.kept(deltaT));

    const Node share = all(this->scheme_.share(deltaT));
    const double cells = deltaT/state.grid.cellSize();
    PointCloud<Dim>& cloud = state.cloud;
    BlockReport<Dim>& report = state.reports[b];
    Lanes speed2(0.0);
    double kinetic = 0;
    std::size_t kept = 0;
    forBatches<Dim>
    (
        state,
        block,
        [&](const Batch& batch)
        {
            Node onGrid[laneCount];
            Node own[laneCount];
            for (int l = 0; l < laneCount; ++l)
            {
                onGrid[l] = velocityAt<Dim>(batch, l, after);
                own[l] =
                    onGrid[l]
                  + share
                   *(
                        nodeOf(cloud.v[batch.point[l]])
                      - velocityAt<Dim>(batch, l, before)
                    );
            }
            Lanes gridVelocity[Dim], velocity[Dim];
            columns<Dim>(onGrid, gridVelocity);
            columns<Dim>(own, velocity);

            Lanes square(0.0);
            for (const Lanes& component : velocity)
            {
                square += component*component;
            }
            speed2 = maxOf(speed2, square);

            for (int l = 0; l < batch.count; ++l)
            {
                const std::int32_t p = batch.point[l];
                const Node dx = all(deltaT)*onGrid[l];
                copy<Dim>(own[l], cloud.v[p].data());
                add<Dim>(dx, cloud.x[p].data());
                add<Dim>(dx, cloud.displacement[p].data());
                kinetic += cloud.mass[p]*square[l];
            }
            kept = keepInBlock
            (
                state, block, batch, gridVelocity, cells, kept, report
            );
        }
    );
    block.points.resize(kept);
    report.kineticEnergy = 0.5*kinetic;
    report.speed2 = largest(speed2);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::LinearFlipCycle<2>;
template class mpm::LinearFlipCycle<3>;


// ************************************************************************* //
