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
#include "mpmGridUpdate.H"
#include "mpmMoveBatch.H"
#include "mpmPrefetch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

typedef ShapeBatch<2, QuadraticBSpline> Batch2;
typedef ShapeBatch<3, QuadraticBSpline> Batch3;


//- Sums of weight x velocity, and of weight x distance (cells) x velocity for
//  each direction over the second moment of the weights
inline void received
(
    const Batch2& batch,
    const int l,
    const Node* source,
    const double perMoment,
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
    sums[1] = all(perMoment)*vx;
    sums[2] = all(perMoment)*vy;
}


inline void received
(
    const Batch3& batch,
    const int l,
    const Node* source,
    const double perMoment,
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
    sums[1] = all(perMoment)*vx;
    sums[2] = all(perMoment)*vy;
    sums[3] = all(perMoment)*vz;
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
    auto& block = state.grid[b];
    const std::size_t n = block.points.size();
    if (n == 0 || block.rest.asleep)
    {
        report.wave2 = block.rest.wave2;
        return;
    }

    typedef ShapeBatch<Dim, QuadraticBSpline> Batch;

    alignas(64) Node patch[BlockGrid<Dim>::nPatchNodes(Batch::reach)];
    state.grid.template collect<Batch::reach>(state.grid.nodes, block, patch);

    recordMirrors(state, b, patch, 1);

    const double perMoment = 4/state.grid.cellSize();
    const double cells = deltaT/state.grid.cellSize();

    Batch batch;
    Node sums[Batch::size][Dim + 1];
    Lanes speed2(0.0), wave2(0.0);
    double kinetic = 0;
    PointCloud<Dim>& cloud = state.cloud;
    Vector<Dim>* x = cloud.x.data();
    Vector<Dim>* v = cloud.v.data();
    Vector<Dim>* u = cloud.displacement.data();
    Tensor<Dim>* C = cloud.C.data();
    const double* mass = cloud.mass.data();
    std::int32_t* list = block.points.data();
    std::size_t kept = 0;

    for (std::size_t i = 0; i < n; i += Batch::size)
    {
        batch.take(cloud.x, state.grid, block, list + i, n - i);
        prefetchAhead
        (
            batch.point[0],
            cloud.x, cloud.v, cloud.displacement, cloud.C, cloud.sigma,
            cloud.mass, cloud.volume, cloud.cohesion, cloud.plasticStrain,
            cloud.law, cloud.yielding
        );
        for (int l = 0; l < Batch::size; ++l)
        {
            received(batch, l, patch + batch.node[l], perMoment, sums[l]);
        }

        Lanes velocity[Dim], gradient[Dim*Dim];
        columns<Dim, Dim + 1>(sums[0], velocity);
        for (int c = 0; c < Dim; ++c)
        {
            columns<Dim, Dim + 1>(sums[0] + c + 1, gradient + c*Dim);
        }
        const Lanes speeds =
            stressUpdate.update(cloud, batch.point, batch.count, gradient);
        wave2 = maxOf(wave2, speeds);

        findBroken(speeds, batch.point, report);

        Lanes square(0.0);
        for (const Lanes& component : velocity)
        {
            square += component*component;
        }
        speed2 = maxOf(speed2, square);

        for (int l = 0; l < batch.count; ++l)
        {
            const std::int32_t p = batch.point[l];
            const Node* s = sums[l];
            const Node dx = all(deltaT)*s[0];
            copy<Dim>(s[0], v[p].data());
            add<Dim>(dx, x[p].data());
            add<Dim>(dx, u[p].data());
            for (int c = 0; c < Dim; ++c)
            {
                copy<Dim>(s[c + 1], C[p].data() + c*Dim);
            }
            kinetic += mass[p]*square[l];
        }

        kept = keepInBlock(state, block, batch, velocity, cells, kept, report);
    }
    block.points.resize(kept);

    report.kineticEnergy = 0.5*kinetic;
    report.speed2 = largest(speed2);
    report.wave2 = largest(wave2);
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
            received(batch, l, patch + batch.node[l], perMoment, sums);
            double trace = 0;
            for (int c = 0; c < Dim; ++c)
            {
                trace += sums[c + 1][c];
            }
            rates[batch.point[l]] = trace;
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
