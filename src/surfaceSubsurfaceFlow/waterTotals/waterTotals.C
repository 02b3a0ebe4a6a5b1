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

#include "waterTotals.H"
#include "restartState.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::waterTotals::keep()
{
    dictionary kept;
    restartState::set(kept, "initialStorage", initialStorage_);
    restartState::set(kept, "initialScale", initialScale_);
    waterVolumes::forAllVolumes
    (
        sum_,
        [&](const word& name, const scalar volume)
        {
            restartState::set(kept, name, volume);
        }
    );

    state_.set("waterBalance", kept);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterTotals::waterTotals
(
    const scalar storage,
    const scalar scale,
    dictionary& state
)
:
    state_(state),
    initialStorage_(storage),
    initialScale_(scale),
    sum_()
{
    // Part of the storage beyond which it is not the one that the last run ended
    // with: fields written with few digits have lost or gained water
    const scalar roundOff = 1e-13;

    const dictionary kept(state.subOrEmptyDict("waterBalance"));

    kept.readIfPresent("initialStorage", initialStorage_);
    kept.readIfPresent("initialScale", initialScale_);
    waterVolumes::forAllVolumes
    (
        sum_,
        [&](const word& name, scalar& volume)
        {
            kept.readIfPresent(name, volume);
        }
    );

    if (mag(initialStorage_ + sum_.gain - storage) > roundOff*scale)
    {
        sum_.gain = storage - initialStorage_;
    }

    keep();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterTotals::add(const waterVolumes& step)
{
    sum_ += step;
    keep();
}


void Foam::waterTotals::forget(const scalar storage, const scalar scale)
{
    initialStorage_ = storage;
    initialScale_ = scale;
    sum_ = waterVolumes();
    state_.remove("waterBalance");
}

// ************************************************************************* //
