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

#include "mpmEnergy.H"
#include "mpmSimulation.H"

#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

template<int Dim, class Direction>
double along(const Vector<Dim>& x, const Direction& direction)
{
    double s = 0;
    for (int d = 0; d < Dim; ++d)
    {
        s += x[d]*direction[d];
    }
    return s;
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
mpm::Diagnostics mpm::Simulation<Dim>::diagnostics() const
{
    const Settings& settings = state_.settings;
    const PointCloud<Dim>& cloud = state_.cloud;
    const std::size_t n = cloud.size();

    Diagnostics result;
    result.time = clock_.time;
    result.deltaT = clock_.deltaT;
    result.step = long(clock_.step);
    result.sorts = long(clock_.sorts);
    result.clampedByWalls = clock_.clampedByWalls;
    result.clampedByGrid = clock_.clampedByGrid;
    result.activeBlocks = state_.grid.size();
    result.bytesPerPoint =
        double(cloud.bytes() + state_.grid.bytes() + cycle_->bytes())
       /double(n);

    sumEnergies
    (
        state_,
        cycle_->secondMoment()*settings.cellSize*settings.cellSize,
        result
    );
    result.rmsVelocity = std::sqrt(2*result.kineticEnergy/result.mass);

    // A tenth of a cell is more than a soil at rest creeps
    const double moved =
        settings.movedDistance > 0
      ? settings.movedDistance
      : 0.1*settings.cellSize;
    const Vector<Dim> upward = up(settings);
    result.crest = -std::numeric_limits<double>::max();
    std::vector<double> fronts;
    for (std::size_t i = 0; i < n; ++i)
    {
        const double u = std::sqrt
        (
            along<Dim>(cloud.displacement[i], cloud.displacement[i])
        );
        const double v = std::sqrt(along<Dim>(cloud.v[i], cloud.v[i]));
        result.maxDisplacement = std::max(result.maxDisplacement, u);
        result.maxVelocity = std::max(result.maxVelocity, v);
        result.maxPlasticStrain =
            std::max(result.maxPlasticStrain, cloud.plasticStrain[i]);
        result.crest = std::max(result.crest, along<Dim>(cloud.x[i], upward));
        result.activePoints += v > settings.restVelocity;
        result.yieldingPoints += cloud.yielding[i];
        if (u > moved)
        {
            fronts.push_back(along<Dim>(cloud.x[i], settings.frontDirection));
        }
    }

    result.movedPoints = fronts.size();
    if (!fronts.empty())
    {
        const std::size_t most = std::size_t(0.99*double(fronts.size() - 1));
        std::sort(fronts.begin(), fronts.end());
        result.front = fronts.back();
        result.front99 = fronts[most];
    }

    return result;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template mpm::Diagnostics mpm::Simulation<2>::diagnostics() const;
template mpm::Diagnostics mpm::Simulation<3>::diagnostics() const;


// ************************************************************************* //
