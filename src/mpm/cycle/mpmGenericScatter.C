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
#include "mpmStencil.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Column d of a stress
inline Vector<2> column(const Stress<2>& s, const int d)
{
    return d == 0 ? Vector<2>{{s[0], s[3]}} : Vector<2>{{s[3], s[1]}};
}


inline Vector<3> column(const Stress<3>& s, const int d)
{
    return
        d == 0 ? Vector<3>{{s[0], s[3], s[5]}}
      : d == 1 ? Vector<3>{{s[3], s[1], s[4]}}
      : Vector<3>{{s[5], s[4], s[2]}};
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::scatterMomentum
(
    State<Dim>& state,
    const std::size_t b
) const
{
    const Block& block = state.grid[b];
    const PointCloud<Dim>& cloud = state.cloud;
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, BlockGrid<Dim>::nPatchNodes, Node{});

    Stencil<Dim, Shape> stencil(state.grid.cellSize(), affine_);
    for (std::size_t i = 0; i < block.points.size(); i += stencil.size)
    {
        stencil.take(cloud.x, state.grid, block, i);
        for (int l = 0; l < stencil.count(); ++l)
        {
            const std::int32_t p = stencil.points()[l];
            stencil.forNodes
            (
                l,
                [&]
                (
                    const int node,
                    const double weight,
                    const Vector<Dim>&,
                    const Vector<Dim>& distance
                )
                {
                    const double m = weight*cloud.mass[p];
                    for (int r = 0; r < Dim; ++r)
                    {
                        double v = cloud.v[p][r];
                        for (int c = 0; affine_ && c < Dim; ++c)
                        {
                            v += cloud.C[p][c*Dim + r]*distance[c];
                        }
                        patch[node][r] += m*v;
                    }
                    patch[node][massOf] += m;
                }
            );
        }
    }
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::scatterForces
(
    State<Dim>& state,
    const std::size_t b
) const
{
    const Block& block = state.grid[b];
    const PointCloud<Dim>& cloud = state.cloud;
    Node* patch = state.grid.patchOf(b);
    std::fill_n(patch, BlockGrid<Dim>::nPatchNodes, Node{});

    Stencil<Dim, Shape> stencil(state.grid.cellSize(), affine_);
    for (std::size_t i = 0; i < block.points.size(); i += stencil.size)
    {
        stencil.take(cloud.x, state.grid, block, i);
        for (int l = 0; l < stencil.count(); ++l)
        {
            const std::int32_t p = stencil.points()[l];
            stencil.forNodes
            (
                l,
                [&]
                (
                    const int node,
                    const double,
                    const Vector<Dim>& gradient,
                    const Vector<Dim>&
                )
                {
                    for (int c = 0; c < Dim; ++c)
                    {
                        const Vector<Dim> s = column(cloud.sigma[p], c);
                        const double k = cloud.volume[p]*gradient[c];
                        for (int r = 0; r < Dim; ++r)
                        {
                            patch[node][r] -= k*s[r];
                        }
                    }
                }
            );
        }
    }
}


template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::sumForces
(
    State<Dim>& state,
    const std::size_t b
)
{
    state.grid.sum
    (
        state.grid.patches,
        state.grid[b],
        forces_.data() + b*BlockGrid<Dim>::nNodes
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim, Shape)                                                \
    template void mpm::GenericCycle<Dim, mpm::Shape>::scatterMomentum          \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t                                                            \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::scatterForces            \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t                                                            \
    ) const;                                                                   \
    template void mpm::GenericCycle<Dim, mpm::Shape>::sumForces                \
    (                                                                          \
        State<Dim>&,                                                           \
        std::size_t                                                            \
    );

instantiate(2, QuadraticBSpline)
instantiate(3, QuadraticBSpline)
instantiate(2, LinearShape)
instantiate(3, LinearShape)

#undef instantiate


// ************************************************************************* //
