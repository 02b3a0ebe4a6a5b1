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

#include "slideControl.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::slideControl::runMode>
Foam::slideControl::runModeNames
({
    { runMode::ALWAYS, "always" },
    { runMode::BELOW, "whenFactorOfSafetyBelow" },
    { runMode::NEVER, "never" }
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::slideControl::listed(const scalar time) const
{
    // Times of directories are written with 6 digits by default
    const scalar sameTime = 1e-6;

    for (const scalar t : times_)
    {
        if (mag(t - time) <= sameTime*max(scalar(1), mag(time)))
        {
            return true;
        }
    }

    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideControl::slideControl(const dictionary& dict)
:
    mode_(runMode::ALWAYS),
    factorOfSafety_(1),
    times_(),
    endTime_(0),
    writeInterval_(0),
    pointInterval_(0),
    stopAtRest_(true),
    restDuration_(0),
    restGrowth_(0),
    finalState_(false)
{
    checkKeys
    (
        dict,
        {
            "run", "factorOfSafety", "times", "endTime", "writeInterval",
            "pointInterval", "stopAtRest", "restDuration", "restGrowth",
            "finalState"
        }
    );

    mode_ = runModeNames.getOrDefault("run", dict, mode_);
    stopAtRest_ = dict.getOrDefault("stopAtRest", stopAtRest_);
    finalState_ = dict.getOrDefault("finalState", finalState_);
    dict.readIfPresent("times", times_);

    const auto positive = [](const scalar x){ return x > 0; };

    factorOfSafety_ =
        readCheckedOrDefault(dict, "factorOfSafety", 1, positive, "> 0");
    endTime_ = readChecked(dict, "endTime", positive, "> 0 s");
    writeInterval_ = readChecked
    (
        dict,
        "writeInterval",
        [this](const scalar x)
        {
            return x > 0 && x <= endTime_ && x*maxRows_ >= endTime_;
        },
        "0 < writeInterval <= endTime s, and no more than a million of them"
    );
    pointInterval_ = readCheckedOrDefault
    (
        dict,
        "pointInterval",
        endTime_,
        [this](const scalar x){ return x >= writeInterval_; },
        ">= writeInterval s"
    );

    // Soil that is let go with a factor of safety of 0.999 moves 2 mm in the
    // first second
    const scalar defaultRestDuration = 1;
    const scalar defaultRestGrowth = 1e-3;
    restDuration_ = readCheckedOrDefault
    (
        dict,
        "restDuration",
        defaultRestDuration,
        positive,
        "> 0 s"
    );
    restGrowth_ = readCheckedOrDefault
    (
        dict,
        "restGrowth",
        defaultRestGrowth,
        positive,
        "> 0"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::slideControl::decision Foam::slideControl::decide
(
    const scalar time,
    const std::optional<scalar>& factorOfSafety
) const
{
    if (mode_ == NEVER)
    {
        return {false, "never"};
    }
    if (listed(time))
    {
        return {true, "listedTime"};
    }
    if (mode_ == ALWAYS)
    {
        return
            times_.empty()
          ? decision{true, "always"}
          : decision{false, "notListed"};
    }
    if (!factorOfSafety)
    {
        // A slide too many is cheaper than one overlooked
        return {true, "factorOfSafetyUnknown"};
    }

    return
        *factorOfSafety < factorOfSafety_
      ? decision{true, "factorOfSafetyBelowLimit"}
      : decision{false, "factorOfSafetyAboveLimit"};
}


bool Foam::slideControl::looksForRest
(
    const scalar time,
    const scalar lastTime
) const
{
    const scalar rounding = 1e-9;

    return
        stopAtRest_
     && time < endTime_*(1 - rounding)
     && time - lastTime >= restDuration_*(1 - rounding);
}


Foam::scalar Foam::slideControl::missedDisplacement
(
    const scalar time,
    const scalar change,
    const scalar energyBefore,
    const scalar energy
) const
{
    return
        energy > energyBefore
      ? GREAT
      : change*max(scalar(0), endTime_ - time)/restDuration_;
}


Foam::scalar Foam::slideControl::rowTime(const label n) const
{
    return min(n*writeInterval_, endTime_);
}


Foam::label Foam::slideControl::lastRow() const
{
    // An interval that divides the end time but for rounding makes no short
    // last one
    const scalar rounding = 1e-9;

    return std::ceil(endTime_/writeInterval_*(1 - rounding));
}


Foam::label Foam::slideControl::rowAt(const scalar time) const
{
    const scalar rounding = 1e-9;

    return std::floor(time/writeInterval_*(1 + rounding));
}


bool Foam::slideControl::writesPoints(const label n) const
{
    const label every =
        max
        (
            label(1),
            label(min(pointInterval_/writeInterval_ + 0.5, 2*maxRows_))
        );

    return n % every == 0 || n == lastRow();
}

// ************************************************************************* //
