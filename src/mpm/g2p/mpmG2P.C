/*---------------------------------------------------------------------------*\
  slideFoam | from rain to runout
-------------------------------------------------------------------------------
    Copyright (C) 2026 the slideFoam authors
-------------------------------------------------------------------------------
License
    This file is part of slideFoam.

    slideFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    slideFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with slideFoam.  If not, see <https://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "mpmG2P.H"
#include "mpmMovePoint.H"
#include "mpmShapeBatch.H"

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
        source += BlockGrid<2>::patchEdge;
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
    constexpr int edge = BlockGrid<3>::patchEdge;

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

    alignas(64) Node patch[BlockGrid<Dim>::nPatchNodes];
    state.grid.collect(state.grid.nodes, block, patch);

    typedef ShapeBatch<Dim, QuadraticBSpline> Batch;
    Batch batch;
    alignas(64) Node sums[Batch::size][Dim + 1];
    const double perMoment = 4/state.grid.cellSize();

    PointCloud<Dim>& cloud = state.cloud;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; i += Batch::size)
    {
        batch.take(cloud.x, state.grid, block, &block.points[i], n - i);
        for (int l = 0; l < Batch::size; ++l)
        {
            received(batch, l, patch + batch.node[l], sums[l]);
        }

        for (int first = 0; first < batch.count; first += laneCount)
        {
            Lanes gradient[Dim*Dim];
            for (int r = 0; r < Dim; ++r)
            {
                for (int c = 0; c < Dim; ++c)
                {
                    gradient[r*Dim + c] = perMoment*Lanes
                    (
                        Lanes::Numbers
                        {
                            sums[first][c + 1][r],
                            sums[first + 1][c + 1][r],
                            sums[first + 2][c + 1][r],
                            sums[first + 3][c + 1][r]
                        }
                    );
                }
            }

            const int count = std::min(laneCount, batch.count - first);
            const Lanes wave2 = stressUpdate.update
            (
                cloud, batch.point + first, count, gradient
            );

            for (int l = 0; l < count; ++l)
            {
                const std::int32_t p = batch.point[first + l];
                Vector<Dim> dx;
                for (int d = 0; d < Dim; ++d)
                {
                    cloud.v[p][d] = sums[first + l][0][d];
                    dx[d] = deltaT*cloud.v[p][d];
                }
                for (int c = 0; c < Dim*Dim; ++c)
                {
                    cloud.C[p][c] = gradient[c].v[l];
                }
                if
                (
                    movePoint<Dim, QuadraticBSpline>
                    (
                        state, block, p, dx, wave2.v[l], report
                    )
                )
                {
                    block.points[kept++] = p;
                }
            }
        }
    }
    block.points.resize(kept);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

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
