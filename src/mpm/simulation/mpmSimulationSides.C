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

#include "mpmSimulation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
void mpm::Simulation<Dim>::measureSides()
{
    bool any = false;
    for (const Wall<Dim>& wall : state_.walls)
    {
        any = any || wall.absorbs();
    }
    if (!any)
    {
        return;
    }

    typedef typename BlockGrid<Dim>::NodeField NodeField;
    PointCloud<Dim>& cloud = state_.cloud;
    const std::vector<double> mass(cloud.mass);
    const auto v(cloud.v);
    const auto C(cloud.C);
    std::fill(cloud.v.begin(), cloud.v.end(), Vector<Dim>{});
    std::fill(cloud.C.begin(), cloud.C.end(), Tensor<Dim>{});

    // Without velocities, what the points give in one second is the force
    cycle_->scatter(state_, 1.0);
    const NodeField force(state_.grid.nodes);

    // Impedances are means by mass: masses times impedances, over masses
    const auto scattered = [&](const auto& modulus)
    {
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            cloud.mass[i] =
                mass[i]
               *std::sqrt
                (
                    modulus(state_.laws[cloud.law[i]])*mass[i]/cloud.volume[i]
                );
        }
        cycle_->scatter(state_, 0);
        return state_.grid.nodes;
    };
    typedef LawTable::Law Law;
    const NodeField pressure
    (
        scattered([](const Law& law) { return law.stiffness; })
    );
    const NodeField shear
    (
        scattered([](const Law& law) { return law.soil.moduli.mu; })
    );
    cloud.mass = mass;
    cloud.v = v;
    cloud.C = C;

    std::vector<typename SideTable<Dim>::Entry> mine;
    for (std::size_t b = 0; b < state_.grid.size(); ++b)
    {
        const auto& block = state_.grid[b];
        for (const auto& w : block.wallNodes)
        {
            const std::size_t i = b*BlockGrid<Dim>::nNodes + w.node;
            const double m = force[i][massOf];
            if
            (
                !(m > 0)
             || !state_.walls[w.wall].absorbs()
             || !state_.grid.isOwn(block, w.node)
            )
            {
                continue;
            }
            double across = 0;
            for (int d = 0; d < Dim; ++d)
            {
                across += (force[i][d] + m*state_.gravity[d])*w.normal[d];
            }
            mine.push_back
            ({
                BlockGrid<Dim>::key(block.at),
                w.node,
                w.wall,
                -across,
                pressure[i][massOf]/m,
                shear[i][massOf]/m
            });
        }
    }
    state_.sides.share(*state_.communicator, mine);
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template void mpm::Simulation<2>::measureSides();
template void mpm::Simulation<3>::measureSides();


// ************************************************************************* //
