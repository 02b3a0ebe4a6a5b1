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

#include "mpmVolumeAverage.H"
#include "mpmLinearNodes.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int Dim, int Reach>
mpm::VolumeAverage<Dim, Reach>::VolumeAverage(const Settings& settings)
:
    width_(settings.antiLocking == "cell" ? 1 : 2)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<int Dim, int Reach>
std::unique_ptr<mpm::VolumeAverage<Dim, Reach>>
mpm::VolumeAverage<Dim, Reach>::New(const Settings& settings)
{
    if (settings.antiLocking == "none")
    {
        return nullptr;
    }
    return std::make_unique<VolumeAverage>(settings);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim, int Reach>
void mpm::VolumeAverage<Dim, Reach>::average
(
    State<Dim>& state,
    const double deltaT
)
{
    typedef const std::size_t Index;

    BlockGrid<Dim>& grid = state.grid;
    const PointCloud<Dim>& cloud = state.cloud;
    nodes_.resize(grid.size()*BlockGrid<Dim>::nNodes);
    patches_.resize(grid.size()*nPatchNodes);

    state.forBlocks
    (
        [&](Index b)
        {
            Node* patch = patches_.data() + b*nPatchNodes;
            std::fill_n(patch, nPatchNodes, Node{});
            for (const std::int32_t p : grid[b].points)
            {
                if (!cloud.dilation.empty())
                {
                    values_[p] -= cloud.dilation[p]/deltaT;
                }
                const double v = cloud.volume[p];
                const Node sent{v*values_[p], 0, 0, v};
                forLinearNodes<Dim, Reach>
                (
                    grid,
                    grid[b],
                    cloud.x[p],
                    width_,
                    [&](const int node, const double w)
                    {
                        patch[node] += Node{w, w, w, w}*sent;
                    }
                );
            }
        }
    );
    state.halo.complete(*state.communicator, grid, patches_);
    state.forBlocks
    (
        [&](Index b)
        {
            Node* nodes = nodes_.data() + b*BlockGrid<Dim>::nNodes;
            grid.template sum<Reach>(patches_, grid[b], nodes);
            for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
            {
                const double v = nodes[i][volume];
                nodes[i][mean] = v > 0 ? nodes[i][mean]/v : 0;
            }
        }
    );

    const double share = 1.0/(Dim + state.axisymmetric);
    state.forBlocks
    (
        [&](Index b)
        {
            if (grid[b].points.empty())
            {
                return;
            }
            alignas(64) Node patch[nPatchNodes];
            grid.template collect<Reach>(nodes_, grid[b], patch);
            for (const std::int32_t p : grid[b].points)
            {
                double smooth = 0;
                forLinearNodes<Dim, Reach>
                (
                    grid,
                    grid[b],
                    cloud.x[p],
                    width_,
                    [&](const int node, const double w)
                    {
                        smooth += w*patch[node][mean];
                    }
                );
                values_[p] = share*(smooth - values_[p]);
            }
        }
    );
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::VolumeAverage<2, 1>;
template class mpm::VolumeAverage<2, 2>;
template class mpm::VolumeAverage<2, 3>;
template class mpm::VolumeAverage<3, 1>;
template class mpm::VolumeAverage<3, 2>;
template class mpm::VolumeAverage<3, 3>;


// ************************************************************************* //
