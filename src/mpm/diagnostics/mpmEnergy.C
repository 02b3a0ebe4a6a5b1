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
#include "neoHookean.H"
#include "mpmPointTensor.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace mpm
{
namespace
{

//- Moment of momentum about the origin, z alone in a section
void addAngularMomentum
(
    const PointCloud<2>& cloud,
    const std::size_t i,
    const double secondMoment,
    Point3& sum
)
{
    const Vector<2>& x = cloud.x[i];
    const Vector<2>& v = cloud.v[i];
    const Tensor<2>& C = cloud.C[i];
    sum[2] += cloud.mass[i]*
    (
        x[0]*v[1] - x[1]*v[0] + secondMoment*(C[1] - C[2])
    );
}


void addAngularMomentum
(
    const PointCloud<3>& cloud,
    const std::size_t i,
    const double secondMoment,
    Point3& sum
)
{
    const Vector<3>& x = cloud.x[i];
    const Vector<3>& v = cloud.v[i];
    const Tensor<3>& C = cloud.C[i];
    for (int a = 0; a < 3; ++a)
    {
        const int b = (a + 1)%3;
        const int c = (a + 2)%3;
        sum[a] += cloud.mass[i]*
        (
            x[b]*v[c] - x[c]*v[b] + secondMoment*(C[3*b + c] - C[3*c + b])
        );
    }
}

} // End anonymous namespace
} // End namespace mpm


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int Dim>
void mpm::sumEnergies
(
    const State<Dim>& state,
    const std::vector<std::int32_t>& points,
    const double secondMoment,
    Diagnostics& sums
)
{
    const PointCloud<Dim>& cloud = state.cloud;
    for (const std::int32_t i : points)
    {
        const double m = cloud.mass[i];
        sums.mass += m;
        sums.volume += cloud.volume[i];

        for (int d = 0; d < Dim; ++d)
        {
            sums.momentum[d] += m*cloud.v[i][d];
            sums.kineticEnergy += 0.5*m*cloud.v[i][d]*cloud.v[i][d];
            sums.potentialEnergy -= m*state.gravity[d]*cloud.x[i][d];
        }
        for (const double c : cloud.C[i])
        {
            sums.affineKineticEnergy += 0.5*m*secondMoment*c*c;
        }
        addAngularMomentum(cloud, i, secondMoment, sums.angularMomentum);
        if (!cloud.plasticWork.empty())
        {
            sums.plasticEnergy += cloud.plasticWork[i];
            sums.integrationEnergy += cloud.integrationWork[i];
        }

        const LawTable::Law& law = state.laws[cloud.law[i]];
        sums.elasticEnergy += cloud.volume[i]*
        (
            law.model == LawTable::Model::neoHookean
          ? neoHookeanEnergyDensity
            (
                tensor(cloud.leftCauchyGreen[i]), law.soil.moduli
            )
          : elasticEnergyDensity(tensor(cloud.sigma[i]), law.soil.moduli)
        );
    }
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

#define instantiate(Dim)                                                       \
    template void mpm::sumEnergies                                             \
    (                                                                          \
        const State<Dim>&,                                                     \
        const std::vector<std::int32_t>&,                                      \
        double,                                                                \
        Diagnostics&                                                           \
    );

instantiate(2)
instantiate(3)

#undef instantiate


// ************************************************************************* //
