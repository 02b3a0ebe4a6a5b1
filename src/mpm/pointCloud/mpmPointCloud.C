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

#include "mpmPointCloud.H"
#include "mpmNames.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::PointCloud<Dim>::assign
(
    const PointData& data,
    const std::size_t first,
    const std::size_t end
)
{
    forAll([n = end - first](auto& a) { a.assign(n, {}); });

    for (std::size_t j = first; j < end; ++j)
    {
        const std::size_t i = j - first;
        for (int d = 0; d < Dim; ++d)
        {
            x[i][d] = data.position[j][d];
            v[i][d] = data.velocity.empty() ? 0.0 : data.velocity[j][d];
        }
        for (int c = 0; c < nStress<Dim>; ++c)
        {
            sigma[i][c] = data.sigma.empty() ? 0.0 : data.sigma[j][c];
        }
        volume[i] = data.volume[j];
        mass[i] = data.rho[j]*data.volume[j];
        cohesion[i] =
            data.cohesionIntercept.empty() ? 0.0 : data.cohesionIntercept[j];
        porePressure[i] =
            data.porePressure.empty() ? 0.0 : data.porePressure[j];
        plasticStrain[i] =
            data.equivalentPlasticStrain.empty()
          ? 0.0
          : data.equivalentPlasticStrain[j];
        id[i] = std::int32_t(j);
    }
    softeningStrain.clear();
    countedStrain.clear();
    leftCauchyGreen.clear();
    dilation.clear();
    plasticWork.clear();
    integrationWork.clear();
    halfSize.clear();
    heldCohesion.clear();
    heldLaw.clear();
}


template<int Dim>
void mpm::PointCloud<Dim>::keepDeformation()
{
    Stress<Dim> unit{};
    unit[0] = unit[1] = unit[2] = 1;
    leftCauchyGreen.assign(size(), unit);
}


template<int Dim>
void mpm::PointCloud<Dim>::turn()
{
    for (std::size_t i = 0; i < size(); ++i)
    {
        require
        (
            x[i][0] > 0,
            "symmetry axisymmetric: point " + std::to_string(id[i])
          + ": position x",
            x[i][0], "> 0, the distance from the axis [m]"
        );
        volume[i] *= x[i][0];
        mass[i] *= x[i][0];
    }
}


template<int Dim>
void mpm::PointCloud<Dim>::keepSize()
{
    halfSize.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
    {
        halfSize[i].fill(0.5*std::pow(volume[i], 1.0/Dim));
    }
}


template<int Dim>
void mpm::PointCloud<Dim>::keepSofteningStrain()
{
    softeningStrain = plasticStrain;
    countedStrain = plasticStrain;
}


template<int Dim>
void mpm::PointCloud<Dim>::forgetPlasticStrain()
{
    for (auto* strain : {&plasticStrain, &softeningStrain, &countedStrain})
    {
        std::fill(strain->begin(), strain->end(), 0.0);
    }
}


template<int Dim>
void mpm::PointCloud<Dim>::hold()
{
    heldCohesion = cohesion;
    heldLaw = law;
}


template<int Dim>
void mpm::PointCloud<Dim>::release()
{
    cohesion.swap(heldCohesion);
    law.swap(heldLaw);
    heldCohesion = std::vector<double>();
    heldLaw = std::vector<std::int32_t>();
}


template<int Dim>
void mpm::PointCloud<Dim>::reorder(const std::vector<std::int32_t>& order)
{
    forAll
    (
        [&order](auto& a)
        {
            typename std::remove_reference<decltype(a)>::type sorted(a.size());
            for (std::size_t i = 0; i < a.size(); ++i)
            {
                sorted[i] = a[order[i]];
            }
            a.swap(sorted);
        }
    );
}


template<int Dim>
std::size_t mpm::PointCloud<Dim>::bytes() const
{
    std::size_t sum = 0;
    const_cast<PointCloud&>(*this).forAll
    (
        [&sum](const auto& a) { sum += a.capacity()*sizeof(a[0]); }
    );
    return sum;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template struct mpm::PointCloud<2>;
template struct mpm::PointCloud<3>;


// ************************************************************************* //
