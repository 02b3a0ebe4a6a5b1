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


//- Sums of weight x value, and of weight x distance from the first one x value,
//  over three places in a row
class Sums
{
public:

    Node value;
    Node moment;

    Sums
    (
        const Node& w0,
        const Node& w1,
        const Node& w2,
        const Node& a,
        const Node& b,
        const Node& c
    )
    {
        const Node last = w2*c;
        const Node both = w1*b + last;
        value = w0*a + both;
        moment = both + last;
    }
};


//- The same over the three rows of three nodes of a plane, from the lowest node
//  on: sums, and first moments along x and y
class PlaneSums
{
public:

    Node value;
    Node x;
    Node y;

    template<class Batch>
    PlaneSums(const Batch& batch, const int l, const Node* source)
    {
        const Node w0 = all(batch.w[0][0][l]);
        const Node w1 = all(batch.w[0][1][l]);
        const Node w2 = all(batch.w[0][2][l]);
        const auto row = [&](const Node* s)
        {
            return Sums(w0, w1, w2, s[0], s[1], s[2]);
        };
        const Sums a = row(source);
        const Sums b = row(source + Batch::patchEdge);
        const Sums c = row(source + 2*Batch::patchEdge);

        const Node v0 = all(batch.w[1][0][l]);
        const Node v1 = all(batch.w[1][1][l]);
        const Node v2 = all(batch.w[1][2][l]);
        const Sums rows(v0, v1, v2, a.value, b.value, c.value);
        value = rows.value;
        x = v0*a.moment + v1*b.moment + v2*c.moment;
        y = rows.moment;
    }
};


//- Sums of weight x velocity, and of weight x distance (cells) x velocity for
//  each direction over the second moment of the weights. Distances are those
//  from the point
inline void received
(
    const Batch2& batch,
    const int l,
    const Node* source,
    const double perMoment,
    Node* sums
)
{
    const PlaneSums plane(batch, l, source);

    const Node scale = all(perMoment);
    sums[0] = plane.value;
    sums[1] = scale*(plane.x - all(batch.f[0][l])*plane.value);
    sums[2] = scale*(plane.y - all(batch.f[1][l])*plane.value);
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
    constexpr int layer = Batch3::patchEdge*Batch3::patchEdge;
    const PlaneSums a(batch, l, source);
    const PlaneSums b(batch, l, source + layer);
    const PlaneSums c(batch, l, source + 2*layer);

    const Node w0 = all(batch.w[2][0][l]);
    const Node w1 = all(batch.w[2][1][l]);
    const Node w2 = all(batch.w[2][2][l]);
    const Sums z(w0, w1, w2, a.value, b.value, c.value);
    const Node x = w0*a.x + w1*b.x + w2*c.x;
    const Node y = w0*a.y + w1*b.y + w2*c.y;

    const Node scale = all(perMoment);
    sums[0] = z.value;
    sums[1] = scale*(x - all(batch.f[0][l])*z.value);
    sums[2] = scale*(y - all(batch.f[1][l])*z.value);
    sums[3] = scale*(z.moment - all(batch.f[2][l])*z.value);
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
