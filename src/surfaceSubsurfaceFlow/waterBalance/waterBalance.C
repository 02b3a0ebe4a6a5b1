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

#include "waterBalance.H"
#include "restartState.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::waterBalance::inflow() const
{
    return sum_.rain + sum_.subsurfaceInflow + sum_.sourceInflow;
}


Foam::scalar Foam::waterBalance::outflow() const
{
    return sum_.surfaceOutflow + sum_.subsurfaceOutflow + sum_.sourceOutflow;
}


void Foam::waterBalance::keep()
{
    water_.setCrossed(inflow() + outflow());

    dictionary balance;
    restartState::set(balance, "initialStorage", initialStorage_);
    restartState::set(balance, "rain", sum_.rain);
    restartState::set(balance, "infiltration", sum_.infiltration);
    restartState::set(balance, "sourceInflow", sum_.sourceInflow);
    restartState::set(balance, "sourceOutflow", sum_.sourceOutflow);
    restartState::set(balance, "surfaceOutflow", sum_.surfaceOutflow);
    restartState::set(balance, "subsurfaceInflow", sum_.subsurfaceInflow);
    restartState::set(balance, "subsurfaceOutflow", sum_.subsurfaceOutflow);

    state_.set("waterBalance", balance);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterBalance::waterBalance
(
    coupledFlow& water,
    dictionary& state
)
:
    water_(water),
    state_(state),
    table_
    (
        water.mesh().time(),
        "waterBalance",
        {
            "time",
            "dt",
            "rain",
            "infiltration",
            "surfaceOutflow",
            "subsurfaceOutflow",
            "surfaceStorage",
            "subsurfaceStorage",
            "sourceSink",
            "error",
            "relativeError"
        }
    ),
    sum_(),
    initialStorage_(water.subsurfaceStorage() + water.surfaceStorage())
{
    const dictionary kept(state.subOrEmptyDict("waterBalance"));

    kept.readIfPresent("initialStorage", initialStorage_);
    kept.readIfPresent("rain", sum_.rain);
    kept.readIfPresent("infiltration", sum_.infiltration);
    kept.readIfPresent("sourceInflow", sum_.sourceInflow);
    kept.readIfPresent("sourceOutflow", sum_.sourceOutflow);
    kept.readIfPresent("surfaceOutflow", sum_.surfaceOutflow);
    kept.readIfPresent("subsurfaceInflow", sum_.subsurfaceInflow);
    kept.readIfPresent("subsurfaceOutflow", sum_.subsurfaceOutflow);

    keep();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterBalance::update()
{
    // A change of storage below this share of the storage is no measure: the
    // storage is known to 1e-16 of it at best, and such a change to 1e-11
    const scalar storageShare = 1e-5;

    const coupledFlow::volumes step(water_.moved());

    sum_.rain += step.rain;
    sum_.infiltration += step.infiltration;
    sum_.sourceInflow += step.sourceInflow;
    sum_.sourceOutflow += step.sourceOutflow;
    sum_.surfaceOutflow += step.surfaceOutflow;
    sum_.subsurfaceInflow += step.subsurfaceInflow;
    sum_.subsurfaceOutflow += step.subsurfaceOutflow;

    const scalar surface = water_.surfaceStorage();
    const scalar subsurface = water_.subsurfaceStorage();

    const scalar sourceSink = sum_.sourceInflow - sum_.sourceOutflow;
    const scalar change = surface + subsurface - initialStorage_;
    const scalar error = change - (inflow() - outflow());
    const scalar scale = max
    (
        max(inflow(), outflow()),
        max(mag(change), storageShare*initialStorage_)
    );
    const scalar relativeError = mag(error)/max(scale, VSMALL);

    const Time& runTime = water_.mesh().time();
    const bool ground = water_.hasGround();
    const bool soil = water_.hasSoil();

    table_.write
    ({
        runTime.value(),
        runTime.deltaTValue(),
        {ground, sum_.rain},
        {ground && soil, sum_.infiltration},
        {water_.hasOverland(), sum_.surfaceOutflow},
        {soil, sum_.subsurfaceOutflow - sum_.subsurfaceInflow},
        {ground, surface},
        {soil, subsurface},
        {water_.hasSources(), sourceSink},
        error,
        relativeError
    });

    Info<< "Water [m3]: rain " << sum_.rain
        << ", infiltration " << sum_.infiltration
        << ", surfaceOutflow " << sum_.surfaceOutflow
        << ", subsurfaceOutflow "
        << sum_.subsurfaceOutflow - sum_.subsurfaceInflow
        << ", surfaceStorage " << surface
        << ", subsurfaceStorage " << subsurface
        << ", sourceSink " << sourceSink
        << ", error " << error << ", relativeError " << relativeError << endl;

    keep();
}

// ************************************************************************* //
