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

#include "mpmNonlocalStrain.H"
#include "mpmLinearNodes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim, int Reach>
void mpm::NonlocalStrainOnPatch<Dim, Reach>::scatter
(
    State<Dim>& state,
    const int zone
)
{
    typedef const std::size_t Index;

    const BlockGrid<Dim>& grid = state.grid;
    const PointCloud<Dim>& cloud = state.cloud;
    nodes_.resize(grid.size()*BlockGrid<Dim>::nNodes);
    patches_.resize(grid.size()*nPatchNodes);
    share_.resize(patches_.size());

    state.forBlocks
    (
        [&](Index b)
        {
            Node* patch = patches_.data() + b*nPatchNodes;
            double* cell = share_.data() + b*nPatchNodes;
            std::fill_n(patch, nPatchNodes, Node{});
            std::fill_n(cell, nPatchNodes, 0.0);
            for (const std::int32_t p : grid[b].points)
            {
                const LawTable::Law& law = state.laws[cloud.law[p]];
                if (law.zone != zone)
                {
                    continue;
                }
                const double v = cloud.volume[p];
                const double yielded =
                    law.softening.lost(cloud.softeningStrain[p]) < 1
                  ? cloud.plasticStrain[p] - cloud.countedStrain[p]
                  : 0;
                const Node sent{v*yielded, 0, 0, v};
                forLinearNodes<Dim, Reach>
                (
                    grid,
                    grid[b],
                    cloud.x[p],
                    2,
                    [&](const int node, const double w)
                    {
                        patch[node] += Node{w, w, w, w}*sent;
                    }
                );
                forLinearNodes<Dim, Reach>
                (
                    grid,
                    grid[b],
                    cloud.x[p],
                    1,
                    [&](const int node, double)
                    {
                        patch[node][cellVolume] += v;
                        cell[node] += v;
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
            grid.template sum<Reach>
            (
                patches_, grid[b], nodes_.data() + b*BlockGrid<Dim>::nNodes
            );
        }
    );
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
            double* cell = share_.data() + b*nPatchNodes;
            for (int i = 0; i < nPatchNodes; ++i)
            {
                cell[i] = cell[i] > 0 ? cell[i]/patch[i][cellVolume] : 0;
            }
        }
    );
}


template<int Dim, int Reach>
void mpm::NonlocalStrainOnPatch<Dim, Reach>::pass
(
    State<Dim>& state,
    const double share
)
{
    typedef const std::size_t Index;

    constexpr int nCorners = 1 << Dim;
    int corner[nCorners];
    for (int c = 0; c < nCorners; ++c)
    {
        corner[c] =
            (c & 1) + patchEdge*((c >> 1 & 1) + patchEdge*(c >> 2 & 1));
    }
    const auto all = [](const double x) { return Node{x, x, x, x}; };
    const double give = share/(nCorners*nCorners);

    const BlockGrid<Dim>& grid = state.grid;
    state.forBlocks
    (
        [&](Index b)
        {
            Node* patch = patches_.data() + b*nPatchNodes;
            std::fill_n(patch, nPatchNodes, Node{});
            if (grid[b].points.empty())
            {
                return;
            }
            alignas(64) Node before[nPatchNodes];
            grid.template collect<Reach>(nodes_, grid[b], before);
            for (int i = 0; i < nPatchNodes; ++i)
            {
                const double cell = share_[b*nPatchNodes + i];
                if (cell == 0)
                {
                    continue;
                }
                Node sum{};
                for (const int c : corner)
                {
                    sum += before[i + c];
                }
                for (const int c : corner)
                {
                    patch[i + c] += all(give*cell)*sum;
                }
            }
        }
    );
    state.halo.complete(*state.communicator, grid, patches_);
    state.forBlocks
    (
        [&](Index b)
        {
            Node passed[BlockGrid<Dim>::nNodes];
            grid.template sum<Reach>(patches_, grid[b], passed);
            Node* nodes = nodes_.data() + b*BlockGrid<Dim>::nNodes;
            for (int i = 0; i < BlockGrid<Dim>::nNodes; ++i)
            {
                nodes[i] = all(1 - share)*nodes[i] + passed[i];
            }
        }
    );
}


template<int Dim, int Reach>
void mpm::NonlocalStrainOnPatch<Dim, Reach>::gather
(
    State<Dim>& state,
    const int zone
) const
{
    const BlockGrid<Dim>& grid = state.grid;
    PointCloud<Dim>& cloud = state.cloud;
    state.forBlocks
    (
        [&](const std::size_t b)
        {
            if (grid[b].points.empty())
            {
                return;
            }
            alignas(64) Node patch[nPatchNodes];
            grid.template collect<Reach>(nodes_, grid[b], patch);
            for (const std::int32_t p : grid[b].points)
            {
                const LawTable::Law& law = state.laws[cloud.law[p]];
                if (law.zone != zone)
                {
                    continue;
                }
                Node sum{};
                forLinearNodes<Dim, Reach>
                (
                    grid,
                    grid[b],
                    cloud.x[p],
                    2,
                    [&](const int node, const double w)
                    {
                        sum += Node{w, w, w, w}*patch[node];
                    }
                );
                cloud.softeningStrain[p] += sum[strain]/sum[volume];
                cloud.countedStrain[p] = cloud.plasticStrain[p];
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<int Dim>
std::unique_ptr<mpm::NonlocalStrain<Dim>> mpm::NonlocalStrain<Dim>::New
(
    const Settings& settings,
    const LawTable& laws
)
{
    if (!laws.nonlocal())
    {
        return nullptr;
    }
    switch (settings.reach())
    {
        case 1: return std::make_unique<NonlocalStrainOnPatch<Dim, 1>>();
        case 2: return std::make_unique<NonlocalStrainOnPatch<Dim, 2>>();
        default: return std::make_unique<NonlocalStrainOnPatch<Dim, 3>>();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim, int Reach>
void mpm::NonlocalStrainOnPatch<Dim, Reach>::update
(
    State<Dim>& state,
    const long step
)
{
    const std::vector<Material>& materials = state.laws.materials();
    for (std::size_t zone = 0; zone < materials.size(); ++zone)
    {
        const SofteningSettings& softening = materials[zone].softening;
        if (!softening.nonlocal())
        {
            continue;
        }
        const double deviation =
            softening.length/Softening::lengthOverDeviation
           /state.grid.cellSize();
        if (step % std::max(1L, long(deviation)) != 0)
        {
            continue;
        }
        scatter(state, int(zone));

        // The weights to the nodes and from them have h^2/3
        const double missing = deviation*deviation - 1.0/3;
        const int nPasses = int(std::ceil(2*missing));
        for (int i = 0; i < nPasses; ++i)
        {
            pass(state, 2*missing/nPasses);
        }
        gather(state, int(zone));
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::NonlocalStrain<2>;
template class mpm::NonlocalStrain<3>;


// ************************************************************************* //
