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

#include "mpmStressUpdate.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int Dim>
mpm::Lanes mpm::StressUpdate<Dim>::updateByLaw
(
    PointCloud<Dim>& cloud,
    const std::int32_t* p,
    const int n,
    const Lanes* gradient
) const
{
    Lanes wave2(0.0);
    bool done[laneCount] = {};
    for (int first = 0; first < n; ++first)
    {
        if (done[first])
        {
            continue;
        }

        // Points of this law side by side; the first one fills what is left
        const std::int32_t law = cloud.law[p[first]];
        std::int32_t points[laneCount];
        int lane[laneCount];
        int count = 0;
        for (int l = first; l < n; ++l)
        {
            if (cloud.law[p[l]] == law)
            {
                points[count] = p[l];
                lane[count++] = l;
                done[l] = true;
            }
        }
        for (int l = count; l < laneCount; ++l)
        {
            points[l] = points[0];
            lane[l] = lane[0];
        }
        Lanes g[Dim*Dim + 1];
        for (int k = 0; k < nGradient(); ++k)
        {
            for (int l = 0; l < laneCount; ++l)
            {
                g[k].v[l] = gradient[k][lane[l]];
            }
        }

        const Lanes speeds =
            laws_[law].model == LawTable::Model::neoHookean
          ? updateNeoHookean(laws_[law], cloud, points, count, g)
          : updatePlastic(laws_[law], cloud, points, count, g);
        for (int l = 0; l < count; ++l)
        {
            wave2.v[lane[l]] = speeds[l];
        }
    }

    // Lanes that do not count take after the first
    for (int l = n; l < laneCount; ++l)
    {
        wave2.v[l] = wave2[0];
    }
    return wave2;
}


template<int Dim>
mpm::PlasticIncrement<mpm::Lanes> mpm::StressUpdate<Dim>::yield
(
    const LawTable::Law& law,
    const PointCloud<Dim>& cloud,
    const std::int32_t* p,
    SymmetricTensor<Dim, Lanes>& stress
) const
{
    Lanes cohesion, tension;
    limits(cloud, p, cohesion, tension);
    const Lanes* tensionLimit = tensionCutOff_ ? &tension : nullptr;

    MohrCoulomb<Lanes> soil(law.lanes);
    DruckerPrager<Lanes> cone(law.coneLanes);
    if (law.softens)
    {
        const SoftenedStrength<Lanes> now = law.softening.strength
        (
            gather
            (
                p, law.nonlocal ? cloud.softeningStrain : cloud.plasticStrain
            ),
            cohesion,
            gather(p, cloud.porePressure)
        );
        cohesion = now.cohesionIntercept;
        soil.setAngles(now.sinPhi, now.cosPhi, now.sinPsi);
        cone.setAngles(law.fit, now.sinPhi, now.cosPhi, now.sinPsi);
    }

    const SymmetricTensor<Dim, Lanes> trial(stress);
    PlasticIncrement<Lanes> plastic =
        law.model == LawTable::Model::DruckerPrager
      ? cone.returnStress(stress, cohesion, tensionLimit)
      : tensionLimit
      ? soil.returnStress(stress, cohesion, tension)
      : soil.returnStress(stress, cohesion);

    if (law.relaxationTime > 0)
    {
        // The stress beyond the surface relaxes: implicit in time, for any
        // length of the step (G. Duvaut, J.L. Lions 1972)
        const Lanes kept(law.relaxationTime/(law.relaxationTime + deltaT_));
        stress.combine
        (
            trial,
            [&kept](Lanes& s, const Lanes& t) { s += kept*(t - s); }
        );
        plastic.equivalentStrain *= Lanes(1.0) - kept;
    }
    return plastic;
}


template<int Dim>
mpm::Lanes mpm::StressUpdate<Dim>::updatePlastic
(
    const LawTable::Law& law,
    PointCloud<Dim>& cloud,
    const std::int32_t* p,
    const int n,
    const Lanes* gradient
) const
{
    SymmetricTensor<Dim, Lanes> stress;
    load(cloud.sigma, p, stress);

    SymmetricTensor<Dim, Lanes> strain;
    Spin<Dim, Lanes> spin;
    kinematics(gradient, Lanes(deltaT_), strain, spin);
    rotateStress(stress, spin);
    addElasticStress(stress, strain, law.lanes.moduli);

    const Lanes trial = stress.trace();
    const PlasticIncrement<Lanes> plastic =
        elastic_ || law.elastic
      ? PlasticIncrement<Lanes>{Lanes(0.0), Lanes(yieldRegion::elastic)}
      : yield(law, cloud, p, stress);

    if (!cloud.plasticWork.empty())
    {
        addWork(cloud, p, n, gradient, stress, law.lanes.moduli);
    }
    return finish
    (
        cloud, p, n, stress, strain.trace(), trial, plastic, law.lanes.moduli
    );
}


template<int Dim>
void mpm::StressUpdate<Dim>::addWork
(
    PointCloud<Dim>& cloud,
    const std::int32_t* p,
    const int n,
    const Lanes* gradient,
    const SymmetricTensor<Dim, Lanes>& stress,
    const ElasticModuli<Lanes>& moduli
) const
{
    typedef SymmetricTensor<Dim, Lanes> Stresses;

    Stresses before, strain;
    Spin<Dim, Lanes> spin;
    load(cloud.sigma, p, before);
    kinematics(gradient, Lanes(deltaT_), strain, spin);
    rotateStress(before, spin);
    Stresses trial(before);
    addElasticStress(trial, strain, moduli);

    // The plastic strain is C^-1 (trial - stress), over the mean stress of the
    // step. With a = before + stress and b = trial - stress, their product
    // 1/2 a : C^-1 b is a difference of elastic energies:
    // 1/4 (W(a + b) - W(a - b))
    Stresses sum(before), difference(before);
    const auto add = [](Lanes& s, const Lanes& t) { s += t; };
    const auto subtract = [](Lanes& s, const Lanes& t) { s -= t; };
    sum.combine(trial, add);
    difference.combine(stress, add);
    difference.combine(stress, add);
    difference.combine(trial, subtract);

    const Lanes volume = gather(p, cloud.volume);
    const Lanes work =
        0.25*volume
       *(
            elasticEnergyDensity(sum, moduli)
          - elasticEnergyDensity(difference, moduli)
        );

    // Nodes did the work of the stress before the step
    Stresses half(before);
    half.combine(stress, subtract);
    half.combine(strain, [&](Lanes& s, const Lanes& e) { s *= 0.5*volume*e; });
    Lanes integration = half.trace() + 2.0*half.xy;
    if constexpr (Dim == 3)
    {
        integration += 2.0*(half.yz + half.zx);
    }
    for (int l = 0; l < n; ++l)
    {
        cloud.plasticWork[p[l]] += work[l];
        cloud.integrationWork[p[l]] += integration[l];
    }
}


template<int Dim>
mpm::Lanes mpm::StressUpdate<Dim>::updateNeoHookean
(
    const LawTable::Law& law,
    PointCloud<Dim>& cloud,
    const std::int32_t* p,
    const int n,
    const Lanes* gradient
) const
{
    Lanes g[Dim*Dim];
    for (int k = 0; k < Dim*Dim; ++k)
    {
        g[k] = deltaT_*gradient[k];
    }

    SymmetricTensor<Dim, Lanes> b;
    load(cloud.leftCauchyGreen, p, b);
    Lanes volume = deform(b, g)*gather(p, cloud.volume);
    if (axisymmetric_)
    {
        const Lanes stretch = Lanes(1.0) + deltaT_*gradient[Dim*Dim];
        b.zz *= stretch*stretch;
        volume *= stretch;
    }
    const Lanes mass = gather(p, cloud.mass);
    store(b, p, n, cloud.leftCauchyGreen);
    store(neoHookeanStress(b, law.lanes.moduli), p, n, cloud.sigma);
    scatter(volume, p, n, cloud.volume);

    return neoHookeanStiffness(b, law.lanes.moduli)*volume/mass;
}


// * * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * //

template class mpm::StressUpdate<2>;
template class mpm::StressUpdate<3>;


// ************************************************************************* //
