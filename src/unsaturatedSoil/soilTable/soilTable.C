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

#include "soilTable.H"
#include "DynamicList.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using Foam::scalar;

    // Where Se + kr ends the table: drier, tau = Se + kr - 2 has fewer than
    // seven digits of it left
    const scalar driestSum = 1e-9;

    // The first node is where 2 - Se - kr reaches this at least: the linear
    // curves before it are as exact as this, and dh/dtau stays bounded for
    // soils that are flat at saturation
    const scalar leastDeficit = 1e-6;

    // Where K has fallen to this part of Ks (a depth of water in the age of the
    // Earth) the spacing no longer follows it, and to this it stays positive
    const scalar slowLogKr = -60;
    const scalar leastKr = 1e-100;

    scalar deficit(const Foam::soilHydraulics& soil, const scalar suction)
    {
        return
            soil.retention().desaturation(-suction)
          + soil.permeability().reduction(-suction);
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::soilTable::nextSuction
(
    const soilHydraulics& soil,
    const controls& c,
    const scalar suction
)
{
    const scalar logKr = soil.permeability().logKr(-suction);
    scalar step = suction*(std::pow(10, 1/c.nodesPerDecade) - 1);

    if (logKr < slowLogKr)
    {
        return suction + step;
    }

    scalar fall = logKr - soil.permeability().logKr(-suction - step);

    while (fall > c.maxLogStep)
    {
        // A little less than proportional, so that few trials are needed
        step *= max(0.95*c.maxLogStep/fall, scalar(0.1));
        fall = logKr - soil.permeability().logKr(-suction - step);
    }

    return suction + step;
}


void Foam::soilTable::makeNodes(const soilHydraulics& soil, const controls& c)
{
    DynamicList<scalar> suction(8192);
    const scalar saturated = -soil.saturationHead();
    const scalar ratio = std::pow(10, 1/c.nodesPerDecade);
    const scalar end = min(c.maxSuction, soil.maxSuction());

    suction.append(saturated);

    scalar s =
        saturated > 0
      ? saturated*ratio
      : min(c.bridge, 0.01*soil.retention().characteristicSuction());

    while (s < end && deficit(soil, s) < leastDeficit)
    {
        s *= ratio;
    }

    s = min(s, end);

    if (s <= saturated || deficit(soil, s) < leastDeficit)
    {
        FatalErrorInFunction
            << "Soil " << soil.name() << " stays saturated up to " << end
            << " m of suction, where its curves end: Se + kr is within "
            << leastDeficit << " of 2. Check the parameters of its retention"
            << " and relativePermeability" << nl << exit(FatalError);
    }

    suction.append(s);
    scalar last = deficit(soil, s);

    while (s < end && 2 - last > driestSum)
    {
        s = min(nextSuction(soil, c, s), end);

        // Where the curves are flat within round-off the nodes lie further
        // apart
        if (deficit(soil, s) > last)
        {
            last = deficit(soil, s);
            suction.append(s);
        }
    }

    const label n = suction.size();
    tau_.resize(n);
    head_.resize(n);
    theta_.resize(n);
    Se_.resize(n);
    K_.resize(n);

    forAll(suction, i)
    {
        const scalar h = -suction[i];

        head_[i] = h;
        tau_[i] = -deficit(soil, suction[i]);
        theta_[i] = soil.theta(h);
        Se_[i] = soil.retention().Se(h);
        K_[i] = soil.Ks()*max(soil.permeability().kr(h), leastKr);
    }

    // At saturation exactly, not minus zero
    tau_[0] = 0;
}


void Foam::soilTable::makeIntervals()
{
    const label n = tau_.size();
    dHead_.resize(n - 1);
    dTheta_.resize(n - 1);
    dK_.resize(n - 1);
    dKdPhi_.resize(n - 1);
    Phi_.resize(n);
    SeIntegral_.resize(n);

    Phi_[0] = 0;
    SeIntegral_[0] = head_[0];

    for (label i = 0; i < n - 1; ++i)
    {
        const scalar dTau = tau_[i + 1] - tau_[i];
        const scalar dh = head_[i + 1] - head_[i];
        const scalar dPhi = 0.5*(K_[i] + K_[i + 1])*dh;

        dHead_[i] = dh/dTau;
        dTheta_[i] = (theta_[i + 1] - theta_[i])/dTau;
        dK_[i] = (K_[i + 1] - K_[i])/dTau;
        dKdPhi_[i] = (K_[i + 1] - K_[i])/dPhi;

        Phi_[i + 1] = Phi_[i] + dPhi;
        SeIntegral_[i + 1] = SeIntegral_[i] + 0.5*(Se_[i] + Se_[i + 1])*dh;
    }

    const scalar dSedh = dTheta_.last()/dHead_.last()/thetaRange_;
    dryDecay_ = max(dSedh/max(Se_.last(), VSMALL), VSMALL);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilTable::soilTable(const soilHydraulics& soil)
:
    soilTable(soil, controls())
{}


Foam::soilTable::soilTable(const soilHydraulics& soil, const controls& c)
:
    dryDecay_(0),
    thetaRange_(soil.retention().thetaS() - soil.retention().thetaR()),
    Ss_(soil.Ss()),
    saturatedScale_(c.saturatedScale)
{
    makeNodes(soil, c);
    makeIntervals();
}

// ************************************************************************* //
