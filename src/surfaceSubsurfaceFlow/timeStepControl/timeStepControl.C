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

#include "timeStepControl.H"
#include "readChecked.H"
#include "restartState.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::timeStepControl::fitted(const scalar length) const
{
    // Distances in time below this share of a step are round-off
    const scalar roundOff = 1e-9;

    const scalar left = nextEvent_ - runTime_.value();
    scalar result = length;

    if (result > (1 - roundOff)*left)
    {
        result = left;
    }
    else if (result > 0.5*left)
    {
        result = 0.5*left;
    }

    // Time goes towards output times (its own and the function objects') by
    // limited factors: ask until it is content
    scalar before = 0;
    do
    {
        before = result;
        runTime_.setDeltaT(before);
        result = runTime_.deltaTValue();
    }
    while (result < (1 - roundOff)*before && result > minStep_);

    // It may have stretched the step to have fewer of them: two halves then
    if (result > (1 + roundOff)*maxStep_)
    {
        result *= 0.5;
    }

    return min(result, left);
}


Foam::scalar Foam::timeStepControl::defaultMaxStep() const
{
    const dictionary& times = runTime_.controlDict();
    const word control(times.lookupOrDefault<word>("writeControl", "none"));

    // Of the other controls writeInterval is no time of the run
    const bool inTime =
        control == "adjustableRunTime"
     || control == "adjustable"
     || control == "runTime";

    return
        inTime
      ? times.get<scalar>("writeInterval")
      : max(runTime_.endTime().value() - runTime_.value(), firstStep_);
}


void Foam::timeStepControl::keep()
{
    dictionary history;
    restartState::set(history, "proposal", proposal_);
    restartState::set(history, "previous", previous_);
    history.set("fresh", fresh_);

    state_.set("timeStep", history);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeStepControl::timeStepControl
(
    Time& runTime,
    const dictionary& controls,
    dictionary& state
)
:
    runTime_(runTime),
    state_(state),
    firstStep_(runTime.deltaTValue()),
    minStep_(0),
    maxStep_(0),
    adaptive_
    (
        runTime.controlDict().lookupOrDefault<bool>("adjustTimeStep", true)
    ),
    proposal_(firstStep_),
    previous_(firstStep_),
    fresh_(true),
    nextEvent_(VGREAT),
    length_(0),
    fallback_(false),
    nRejected_(0),
    nCuts_(0),
    errorRatio_(0)
{
    const dictionary& dict = controls.subOrEmptyDict("timeStep");
    const auto positive = [](const scalar x) { return x > 0; };

    localError_ = readCheckedOrDefault
    (
        dict,
        "localError",
        1e-3,
        [](const scalar x) { return x >= 0; },
        ">= 0"
    );
    fewIterations_ =
        readCheckedOrDefault(dict, "fewIterations", 8, positive, "> 0");
    growth_ = readCheckedOrDefault
    (
        dict,
        "growth",
        2,
        [](const scalar x) { return x > 1; },
        "> 1"
    );
    cut_ = readCheckedOrDefault
    (
        dict,
        "cut",
        0.3,
        [](const scalar x) { return x > 0 && x < 1; },
        "0 < cut < 1"
    );
    maxCuts_ = readCheckedOrDefault
    (
        dict,
        "maxCuts",
        15,
        [](const scalar x) { return x >= 0; },
        ">= 0"
    );

    const dictionary& times = runTime.controlDict();
    minStep_ =
        readCheckedOrDefault(times, "minDeltaT", 1e-6, positive, "> 0 s");
    maxStep_ = readCheckedOrDefault
    (
        times,
        "maxDeltaT",
        defaultMaxStep(),
        positive,
        "> 0 s"
    );

    const dictionary& history = state.subOrEmptyDict("timeStep");
    history.readIfPresent("proposal", proposal_);
    history.readIfPresent("previous", previous_);
    history.readIfPresent("fresh", fresh_);

    keep();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeStepControl::begin(const coupledFlow& water)
{
    const scalar t = runTime_.value();

    // The change of rain at which the last step ended lies behind
    nextEvent_ = min
    (
        water.nextRainChange(t + minStep_),
        runTime_.endTime().value()
    );

    fallback_ = false;
    nRejected_ = 0;
    nCuts_ = 0;
    length_ = fitted(min(adaptive_ ? proposal_ : firstStep_, maxStep_));
}


bool Foam::timeStepControl::rejects(coupledFlow& water)
{
    // A step is repeated if its error is this much beyond the aim
    const scalar tolerated = 4;

    if (water.latest().converged)
    {
        errorRatio_ =
            fresh_ || localError_ <= 0 || !adaptive_
          ? 0
          : water.localError(previous_)/localError_;

        if (errorRatio_ <= tolerated)
        {
            return false;
        }

        Info<< "Step of " << length_ << " s rejected: local error "
            << errorRatio_*localError_ << endl;

        length_ *= max(cut_, 0.9/sqrt(errorRatio_));
    }
    else if (!fallback_ && water.hasSoil())
    {
        fallback_ = true;
    }
    else
    {
        fallback_ = false;
        length_ *= cut_;
        ++nCuts_;
    }

    if (!water.latest().converged)
    {
        Info<< "Step not converged after " << water.latest().iterations
            << " iterations: " << water.trouble().c_str() << ". Next "
            << length_ << " s with "
            << (fallback_ ? "integralUpwind" : "the selected flux") << endl;
    }

    if (nCuts_ > maxCuts_ || length_ < minStep_)
    {
        water.stop(nCuts_);
    }

    water.giveUp();
    ++nRejected_;
    proposal_ = length_;

    return true;
}


void Foam::timeStepControl::advance(const coupledFlow& water)
{
    const scalar t = runTime_.value();

    runTime_.setDeltaT(length_, false);
    ++runTime_;

    // Backward Euler's local error goes with the square of the step
    scalar factor = growth_;
    if (errorRatio_ > 0)
    {
        factor = min(factor, max(0.9/sqrt(errorRatio_), cut_));
    }
    if (water.latest().iterations > fewIterations_)
    {
        const bool many = water.latest().iterations > 2*fewIterations_;
        factor = min(factor, many ? 0.7 : 1.0);
    }

    // A step that was only fitted to an event does not bind the next one
    proposal_ =
        factor > 1
      ? max(min(proposal_, maxStep_), factor*length_)
      : factor*length_;
    previous_ = length_;

    fresh_ = water.nextRainChange(t + minStep_) <= runTime_.value() + minStep_;
    if (fresh_)
    {
        proposal_ = min(proposal_, firstStep_);
    }

    keep();
}

// ************************************************************************* //
