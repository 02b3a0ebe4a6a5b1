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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterBalance::waterBalance(const coupledFlow& water)
:
    water_(water),
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
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterBalance::update()
{
    // A change of storage below this share of the storage is no measure: the
    // storage of a cell is known to 1e-16 of it, and such a change to 1e-10
    const scalar storageShare = 1e-6;

    const waterTotals& totals = water_.totals();
    const waterVolumes& sum = totals.sum();

    const scalar surface = water_.surfaceStorage();
    const scalar subsurface = water_.subsurfaceStorage();

    const scalar sourceSink = sum.sourceInflow - sum.sourceOutflow;
    const scalar subsurfaceOutflow =
        sum.subsurfaceOutflow - sum.subsurfaceInflow;
    const scalar error = sum.gain - (sum.inflow() - sum.outflow());
    const scalar scale = max
    (
        max(sum.inflow(), sum.outflow()),
        max(mag(sum.gain), storageShare*water_.storageScale())
    );
    const scalar relativeError = mag(error)/max(scale, VSMALL);

    const Time& runTime = water_.mesh().time();
    const bool ground = water_.hasGround();
    const bool soil = water_.hasSoil();

    table_.write
    ({
        runTime.value(),
        runTime.deltaTValue(),
        {ground, sum.rain},
        {ground && soil, sum.infiltration},
        {water_.hasOverland(), sum.surfaceOutflow},
        {soil, subsurfaceOutflow},
        {ground, surface},
        {soil, subsurface},
        {water_.hasSources(), sourceSink},
        error,
        relativeError
    });

    Info<< "Water [m3]: rain " << sum.rain
        << ", infiltration " << sum.infiltration
        << ", surfaceOutflow " << sum.surfaceOutflow
        << ", subsurfaceOutflow "
        << subsurfaceOutflow
        << ", surfaceStorage " << surface
        << ", subsurfaceStorage " << subsurface
        << ", sourceSink " << sourceSink
        << ", error " << error << ", relativeError " << relativeError << endl;
}

// ************************************************************************* //
