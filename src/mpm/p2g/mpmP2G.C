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

#include "mpmNode.H"
#include "mpmP2G.H"
#include "mpmPrefetch.H"
#include "mpmShapeBatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- What a point sends: value at its own place, and change for each cell in
//  each direction. The latter is that of its affine velocity less its stress
//  times impulse, which is 4 deltaT/h: weights times distances in cells, over
//  the second moment 1/4 of the weights, over h
template<int Dim>
struct Sent
{
    Node value;
    Node slope[Dim];
};


inline Sent<2> sent
(
    const PointCloud<2>& cloud,
    const std::int32_t p,
    const double h,
    const double impulse
)
{
    const Node m = all(cloud.mass[p]);
    const Node V = all(cloud.volume[p]);

    // Both columns at once: sigma is xx yy zz xy
    const Node sigma = four(cloud.sigma[p].data());
    const Node slopes =
        m*(all(h)*four(cloud.C[p].data()))
      - V*(all(impulse)*__builtin_shuffle(sigma, Pick{0, 3, 3, 1}));

    const Node none{};
    return
    {
        m*(nodeOf(cloud.v[p]) + Node{0, 0, 0, 1}),
        {
            __builtin_shuffle(slopes, none, Pick{0, 1, 4, 5}),
            __builtin_shuffle(slopes, none, Pick{2, 3, 4, 5})
        }
    };
}


inline Sent<3> sent
(
    const PointCloud<3>& cloud,
    const std::int32_t p,
    const double h,
    const double impulse
)
{
    const Node m = all(cloud.mass[p]);
    const Node V = all(cloud.volume[p]);
    const Node hm = m*Node{h, h, h, 0};
    const Node k = V*Node{impulse, impulse, impulse, 0};

    // sigma is xx yy zz xy yz zx
    const double* C = cloud.C[p].data();
    const Node first = four(cloud.sigma[p].data());
    const Node last = four(cloud.sigma[p].data() + 2);
    const Node end = four(C + 5);

    return
    {
        m*(nodeOf(cloud.v[p]) + Node{0, 0, 0, 1}),
        {
            hm*four(C)
          - k*__builtin_shuffle(first, last, Pick{0, 3, 7, 7}),
            hm*four(C + 3)
          - k*__builtin_shuffle(first, last, Pick{3, 1, 6, 6}),
            hm*__builtin_shuffle(end, Pick{1, 2, 3, 3})
          - k*__builtin_shuffle(last, Pick{3, 2, 0, 0})
        }
    };
}


typedef ShapeBatch<2, QuadraticBSpline> Batch2;
typedef ShapeBatch<3, QuadraticBSpline> Batch3;


//- What a point sends to the three nodes of a row: the values there for the
//  first one, and by how much they change from node to node
inline void addRow
(
    const Node& first,
    const Node& change,
    const Node& w0,
    const Node& w1,
    const Node& w2,
    Node* row
)
{
    const Node second = first + change;
    row[0] += w0*first;
    row[1] += w1*second;
    row[2] += w2*(second + change);
}


//- The same for the three rows of three nodes of a plane, from the lowest node
//  on: its value and the changes along x and y
template<class Batch>
inline void addPlane
(
    const Batch& batch,
    const int l,
    Node value,
    const Node& alongX,
    const Node& alongY,
    Node* target
)
{
    const Node w0 = all(batch.w[0][0][l]);
    const Node w1 = all(batch.w[0][1][l]);
    const Node w2 = all(batch.w[0][2][l]);
    for (int y = 0; y < 3; ++y)
    {
        const Node w = all(batch.w[1][y][l]);
        addRow(w*value, w*alongX, w0, w1, w2, target);
        value += alongY;
        target += Batch::patchEdge;
    }
}


//- To the nodes of a point, from the lowest one on
inline void add
(
    const Batch2& batch,
    const int l,
    const Sent<2>& q,
    Node* target
)
{
    const Node value =
        q.value - all(batch.f[0][l])*q.slope[0] - all(batch.f[1][l])*q.slope[1];
    addPlane(batch, l, value, q.slope[0], q.slope[1], target);
}


inline void add
(
    const Batch3& batch,
    const int l,
    const Sent<3>& q,
    Node* target
)
{
    Node value =
        q.value
      - all(batch.f[0][l])*q.slope[0]
      - all(batch.f[1][l])*q.slope[1]
      - all(batch.f[2][l])*q.slope[2];
    for (int z = 0; z < 3; ++z)
    {
        const Node w = all(batch.w[2][z][l]);
        addPlane(batch, l, w*value, w*q.slope[0], w*q.slope[1], target);
        value += q.slope[2];
        target += Batch3::patchEdge*Batch3::patchEdge;
    }
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::scatterAPIC
(
    const PointCloud<Dim>& cloud,
    const BlockGrid<Dim>& grid,
    const typename BlockGrid<Dim>::Block& block,
    const double deltaT,
    Node* patch
)
{
    ShapeBatch<Dim, QuadraticBSpline> batch;
    for (int i = 0; i < BlockGrid<Dim>::nPatchNodes(batch.reach); ++i)
    {
        patch[i] = Node{};
    }

    const double h = grid.cellSize();
    const double impulse = deltaT/(QuadraticBSpline::secondMoment*h);

    const std::size_t n = block.points.size();
    for (std::size_t i = 0; i < n; i += batch.size)
    {
        batch.take(cloud.x, grid, block, block.points.data() + i, n - i);
        prefetchAhead
        (
            batch.point[0],
            cloud.x, cloud.v, cloud.C, cloud.sigma, cloud.mass, cloud.volume
        );
        for (int l = 0; l < batch.count; ++l)
        {
            add
            (
                batch,
                l,
                sent(cloud, batch.point[l], h, impulse),
                patch + batch.node[l]
            );
        }
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::scatterAPIC
(
    const PointCloud<2>&,
    const BlockGrid<2>&,
    const BlockGrid<2>::Block&,
    double,
    Node*
);

template void mpm::scatterAPIC
(
    const PointCloud<3>&,
    const BlockGrid<3>&,
    const BlockGrid<3>::Block&,
    double,
    Node*
);


// ************************************************************************* //
