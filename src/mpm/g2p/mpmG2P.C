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

#include "mpmG2P.H"
#include "mpmMovePoint.H"
#include "mpmShapeBatch.H"
#include "mpmTranspose.H"

#include <cstring>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

typedef ShapeBatch<2, QuadraticBSpline> Batch2;
typedef ShapeBatch<3, QuadraticBSpline> Batch3;


inline Node all(const double a)
{
    return Node{a, a, a, a};
}


//- Sums of weight x velocity, and of weight x distance (cells) x velocity for
//  each direction
inline void received
(
    const Batch2& batch,
    const int l,
    const Node* source,
    Node* sums
)
{
    Node v{}, vx{}, vy{};
    for (int y = 0; y < 3; ++y)
    {
        Node row{}, rowX{};
        for (int x = 0; x < 3; ++x)
        {
            row += all(batch.w[0][x][l])*source[x];
            rowX += all(batch.wd[0][x][l])*source[x];
        }
        v += all(batch.w[1][y][l])*row;
        vx += all(batch.w[1][y][l])*rowX;
        vy += all(batch.wd[1][y][l])*row;
        source += Batch2::patchEdge;
    }
    sums[0] = v;
    sums[1] = vx;
    sums[2] = vy;
}


inline void received
(
    const Batch3& batch,
    const int l,
    const Node* source,
    Node* sums
)
{
    constexpr int edge = Batch3::patchEdge;

    Node v{}, vx{}, vy{}, vz{};
    for (int z = 0; z < 3; ++z)
    {
        Node plane{}, planeX{}, planeY{};
        for (int y = 0; y < 3; ++y)
        {
            const Node* s = source + edge*y;
            Node row{}, rowX{};
            for (int x = 0; x < 3; ++x)
            {
                row += all(batch.w[0][x][l])*s[x];
                rowX += all(batch.wd[0][x][l])*s[x];
            }
            plane += all(batch.w[1][y][l])*row;
            planeX += all(batch.w[1][y][l])*rowX;
            planeY += all(batch.wd[1][y][l])*row;
        }
        v += all(batch.w[2][z][l])*plane;
        vx += all(batch.w[2][z][l])*planeX;
        vy += all(batch.w[2][z][l])*planeY;
        vz += all(batch.wd[2][z][l])*plane;
        source += edge*edge;
    }
    sums[0] = v;
    sums[1] = vx;
    sums[2] = vy;
    sums[3] = vz;
}


//- Entry d of four nodes
template<int Dim>
inline void columns
(
    const Node& a,
    const Node& b,
    const Node& c,
    const Node& d,
    Lanes* entries
)
{
    Node n[laneCount] = {a, b, c, d};
    transpose(n[0], n[1], n[2], n[3]);
    for (int e = 0; e < Dim; ++e)
    {
        entries[e] = Lanes(n[e]);
    }
}


inline Eight both(const Lanes& a, const Lanes& b)
{
    Eight e;
    std::memcpy(&e, &a.v, sizeof(a.v));
    std::memcpy(reinterpret_cast<char*>(&e) + sizeof(a.v), &b.v, sizeof(b.v));
    return e;
}


typedef long long EightMask __attribute__((vector_size(64)));

inline bool any(const EightMask& m)
{
    LaneMask half[2];
    std::memcpy(half, &m, sizeof(m));
    return mpm::any(half[0] | half[1]);
}


inline double largest(const Eight& a)
{
    double m = a[0];
    for (int l = 1; l < 8; ++l)
    {
        m = std::max(m, a[l]);
    }
    return m;
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::gatherAPIC
(
    State<Dim>& state,
    const std::size_t b,
    const StressUpdate<Dim>& stressUpdate,
    const double deltaT
)
{
    BlockReport<Dim>& report = state.reports[b];
    report.reset();

    auto& block = state.grid[b];
    const std::size_t n = block.points.size();
    if (n == 0)
    {
        return;
    }

    typedef ShapeBatch<Dim, QuadraticBSpline> Batch;

    alignas(64) Node patch[BlockGrid<Dim>::nPatchNodes(Batch::reach)];
    state.grid.template collect<Batch::reach>(state.grid.nodes, block, patch);

    constexpr double shift = QuadraticBSpline::shift;
    constexpr double end = BlockGrid<Dim>::edge + shift;
    const double perMoment = 4/state.grid.cellSize();
    const double cells = deltaT/state.grid.cellSize();
    const bool open = block.walls.empty();

    Batch batch;
    Node sums[Batch::size][Dim + 1];
    Eight speed2{};
    Lanes wave2(0.0);
    PointCloud<Dim>& cloud = state.cloud;
    Vector<Dim>* x = cloud.x.data();
    Vector<Dim>* v = cloud.v.data();
    Vector<Dim>* u = cloud.displacement.data();
    Tensor<Dim>* C = cloud.C.data();
    const double* mass = cloud.mass.data();
    std::int32_t* list = block.points.data();
    std::size_t kept = 0;
    double energy = 0;

    for (std::size_t i = 0; i < n; i += Batch::size)
    {
        batch.take(cloud.x, state.grid, block, list + i, n - i);
        for (int l = 0; l < Batch::size; ++l)
        {
            received(batch, l, patch + batch.node[l], sums[l]);
        }

        Lanes velocity[2][Dim];
        for (int half = 0; half < 2; ++half)
        {
            const auto& s = sums + laneCount*half;
            columns<Dim>(s[0][0], s[1][0], s[2][0], s[3][0], velocity[half]);

            const int count = batch.count - laneCount*half;
            if (count <= 0)
            {
                continue;
            }
            Lanes gradient[Dim*Dim];
            for (int c = 0; c < Dim; ++c)
            {
                for (int l = 0; l < laneCount; ++l)
                {
                    s[l][c + 1] *= all(perMoment);
                }
                columns<Dim>
                (
                    s[0][c + 1], s[1][c + 1], s[2][c + 1], s[3][c + 1],
                    gradient + c*Dim
                );
            }
            const std::int32_t* points = batch.point + laneCount*half;
            const Lanes speeds = stressUpdate.update
            (
                cloud, points, std::min(laneCount, count), gradient
            );
            wave2 = maxOf(wave2, speeds);

            // Neither zero or less, nor not a number
            if (any(LaneMask{~(speeds > Lanes(0.0)).bits}))
            {
                for (int l = 0; l < laneCount; ++l)
                {
                    report.broken =
                        speeds[l] > 0 ? report.broken : points[l];
                }
            }
        }

        Eight square{};
        EightMask leaves{};
        for (int d = 0; d < Dim; ++d)
        {
            const Eight vd = both(velocity[0][d], velocity[1][d]);
            const Eight place = batch.local[d] + cells*vd;
            square += vd*vd;
            leaves |= ~((place >= shift) & (place < end));
        }
        speed2 = square > speed2 ? square : speed2;
        const bool allStay = !any(leaves);

        for (int l = 0; l < batch.count; ++l)
        {
            const std::int32_t p = batch.point[l];
            const Node dx = all(deltaT)*sums[l][0];
            for (int d = 0; d < Dim; ++d)
            {
                v[p][d] = sums[l][0][d];
                x[p][d] += dx[d];
                u[p][d] += dx[d];
            }
            for (int c = 0; c < Dim; ++c)
            {
                for (int d = 0; d < Dim; ++d)
                {
                    C[p][c*Dim + d] = sums[l][c + 1][d];
                }
            }
            energy += mass[p]*square[l];

            const bool moved = !open && project(state, block, p, report);
            const bool stays = !moved && (allStay || !leaves[l]);
            if
            (
                stays
             || belongs<Dim, QuadraticBSpline>(state, block, p, report)
            )
            {
                list[kept++] = p;
            }
        }
    }
    block.points.resize(kept);

    report.kineticEnergy = 0.5*energy;
    report.speed2 = largest(speed2);
    for (int l = 0; l < laneCount; ++l)
    {
        report.wave2 = std::max(report.wave2, wave2[l]);
    }
}


template<int Dim>
void mpm::findVolumetricRates
(
    State<Dim>& state,
    const std::size_t b,
    std::vector<double>& rates
)
{
    const auto& block = state.grid[b];
    const std::size_t n = block.points.size();
    if (n == 0)
    {
        return;
    }

    typedef ShapeBatch<Dim, QuadraticBSpline> Batch;
    alignas(64) Node patch[BlockGrid<Dim>::nPatchNodes(Batch::reach)];
    state.grid.template collect<Batch::reach>(state.grid.nodes, block, patch);

    const double perMoment = 4/state.grid.cellSize();
    Batch batch;
    for (std::size_t i = 0; i < n; i += Batch::size)
    {
        batch.take
        (
            state.cloud.x, state.grid, block, block.points.data() + i, n - i
        );
        for (int l = 0; l < batch.count; ++l)
        {
            Node sums[Dim + 1];
            received(batch, l, patch + batch.node[l], sums);
            double trace = 0;
            for (int c = 0; c < Dim; ++c)
            {
                trace += sums[c + 1][c];
            }
            rates[batch.point[l]] = perMoment*trace;
        }
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::findVolumetricRates
(
    State<2>&,
    std::size_t,
    std::vector<double>&
);

template void mpm::findVolumetricRates
(
    State<3>&,
    std::size_t,
    std::vector<double>&
);

template void mpm::gatherAPIC
(
    State<2>&,
    std::size_t,
    const StressUpdate<2>&,
    double
);

template void mpm::gatherAPIC
(
    State<3>&,
    std::size_t,
    const StressUpdate<3>&,
    double
);


// ************************************************************************* //
