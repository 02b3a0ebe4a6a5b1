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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, class Shape>
void mpm::GenericCycle<Dim, Shape>::average
(
    State<Dim>& state,
    const double deltaT
)
{
    if (!average_)
    {
        return;
    }

    std::vector<double>& rates = average_->rates(state);
    state.forBlocks
    (
        [&](const std::size_t b)
        {
            const Block& block = state.grid[b];
            if (block.points.empty())
            {
                return;
            }
            alignas(64) Node velocity[nPatchNodes];
            state.grid.template collect<reach>
            (
                state.grid.nodes, block, velocity
            );

            Stencil stencil;
            for (const std::int32_t p : block.points)
            {
                stencil.take
                (
                    state.cloud, state.grid, block, p, scheme_.affine()
                );
                const double perRadius =
                    state.axisymmetric
                  ? 1/state.radius(state.cloud.x[p])
                  : 0;
                double rate = 0;
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
                        rate += w*perRadius*velocity[i][0];
                        for (int d = 0; d < Dim; ++d)
                        {
                            rate += gradient[d]*velocity[i][d];
                        }
                    }
                );
                rates[p] = rate;
            }
        }
    );
    average_->average(state, deltaT);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim, Shape)                                                \
    template void mpm::GenericCycle<Dim, mpm::Shape>::average                  \
    (                                                                          \
        State<Dim>&,                                                           \
        double                                                                 \
    );

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
