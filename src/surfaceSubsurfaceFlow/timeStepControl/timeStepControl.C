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

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::timeStepControl::rejection>
Foam::timeStepControl::rejectionNames
({
    { rejection::localError, "local error" },
    { rejection::notConverged, "no convergence" },
    { rejection::dried, "drier than the curves" },
});


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

    // Time goes towards the output times of function objects by limited
    // factors: ask until it is content
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


Foam::scalar Foam::timeStepControl::outputInterval() const
{
    const dictionary& times = runTime_.controlDict();
    const word control(times.lookupOrDefault<word>("writeControl", "none"));

    // Of the other controls writeInterval is no time of the run
    const bool inTime =
        control == "adjustableRunTime"
     || control == "adjustable"
     || control == "runTime";

    return inTime ? times.get<scalar>("writeInterval") : VGREAT;
}


Foam::scalar Foam::timeStepControl::nextOutput() const
{
    const scalar interval = outputInterval();

    if (interval == VGREAT)
    {
        return VGREAT;
    }

    // Distances in time below this share of the interval are round-off
    const scalar roundOff = 1e-9;

    const scalar start = runTime_.startTime().value();
    const scalar passed =
        std::floor((runTime_.value() - start)/interval + roundOff);

    return start + (passed + 1)*interval;
}


Foam::scalar Foam::timeStepControl::defaultMaxStep() const
{
    const scalar interval = outputInterval();

    return
        interval < VGREAT
      ? interval
      : max(runTime_.endTime().value() - runTime_.value(), firstStep_);
}


void Foam::timeStepControl::keep()
{
    dictionary history;
    restartState::set(history, "proposal", proposal_);
    restartState::set(history, "previous", previous_);
    restartState::set(history, "beforePrevious", beforePrevious_);
    history.set("nSmooth", nSmooth_);
    history.set("nHeld", nHeld_);
    history.set("nFutile", nFutile_);
    restartState::set(history, "cutFrom", cutFrom_);

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
    firstStep_(runTime.controlDict().get<scalar>("deltaT")),
    minStep_(0),
    maxStep_(0),
    adaptive_
    (
        runTime.controlDict().lookupOrDefault<bool>("adjustTimeStep", true)
    ),
    rescue_(true),
    proposal_(firstStep_),
    previous_(firstStep_),
    beforePrevious_(firstStep_),
    nSmooth_(0),
    nHeld_(0),
    nFutile_(0),
    cutFrom_(GREAT),
    nextEvent_(VGREAT),
    euler_(),
    step_(),
    nRejected_(0),
    nCuts_(0),
    nLost_(0),
    lostFrom_(runTime.value()),
    nPaced_(0),
    pacedFrom_(runTime.value()),
    errorRatio_(0),
    errorOrder_(1),
    rejections_(0)
{
    const dictionary& dict = controls.subOrEmptyDict("timeStep");
    checkKeys
    (
        dict,
        {
            "localError", "fewIterations", "growth", "cut", "maxCuts",
            "maxLost", "leastAdvance", "mostIterations", "rescue"
        }
    );

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

    maxLost_ = readCheckedOrDefault
    (
        dict,
        "maxLost",
        200,
        [](const scalar x) { return x >= 1; },
        ">= 1"
    );
    leastAdvance_ = readCheckedOrDefault
    (
        dict,
        "leastAdvance",
        1e-4,
        [](const scalar x) { return x >= 0 && x <= 1; },
        "0 <= leastAdvance <= 1"
    );

    mostIterations_ = readCheckedOrDefault
    (
        dict,
        "mostIterations",
        1e6,
        [](const scalar x) { return x >= 0; },
        ">= 0"
    );

    rescue_ = dict.lookupOrDefault<bool>("rescue", true);

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
    history.readIfPresent("beforePrevious", beforePrevious_);
    history.readIfPresent("nSmooth", nSmooth_);
    history.readIfPresent("nHeld", nHeld_);
    history.readIfPresent("nFutile", nFutile_);
    history.readIfPresent("cutFrom", cutFrom_);

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
        min(nextOutput(), runTime_.endTime().value())
    );

    nRejected_ = 0;
    nCuts_ = 0;

    const scalar length =
        fitted(min(adaptive_ ? proposal_ : firstStep_, maxStep_));

    step_ = stepTrial();
    step_.start = t;
    step_.lengths = {length, previous_, beforePrevious_};
    step_.carries = nSmooth_ > 0 && water.scheme().order() > 1;
    step_.nRates = min(nSmooth_, 2);
}


bool Foam::timeStepControl::rejects(coupledFlow& water)
{
    // A step is repeated if its error is this much beyond the aim
    const scalar tolerated = 4;

    nPaced_ += water.latest().iterations;

    if (water.latest().converged)
    {
        // The error of the scheme needs as many smooth steps as its order;
        // until then that of a step of first order stands for it
        const bool full =
            step_.carries && nSmooth_ >= water.scheme().order();
        const timeScheme& scheme = full ? water.scheme() : euler_;

        errorOrder_ = scheme.order();
        errorRatio_ =
            nSmooth_ == 0 || localError_ <= 0 || !adaptive_
          ? 0
          : water.localError(scheme)/localError_;

        if (errorRatio_ <= tolerated)
        {
            checkPace(water);
            return false;
        }

        Info<< "Step of " << step_.length() << " s rejected: local error "
            << errorRatio_*localError_ << endl;

        step_.lengths[0] *= max(cut_, errorFactor());
        ++rejections_[rejection::localError];
    }
    else
    {
        ++rejections_
        [
            water.latest().dried ? rejection::dried : rejection::notConverged
        ];

        if (rescue_ && step_.carries)
        {
            step_.carries = false;
            step_.nRates = 0;
        }
        else if (rescue_ && !step_.fallback && water.hasSoil())
        {
            step_.fallback = true;
        }
        else
        {
            step_.fallback = false;
            step_.lengths[0] *= cut_;
            ++nCuts_;
        }

        Info<< "Step not converged after " << water.latest().iterations
            << " iterations: " << water.trouble().c_str() << ". Next "
            << step_.length() << " s with "
            << (step_.fallback ? "integralUpwind" : "the selected flux")
            << ", first order in time" << endl;
    }

    if (nCuts_ > maxCuts_ || step_.length() < minStep_)
    {
        water.stop(nCuts_);
    }
    if (!water.latest().converged)
    {
        checkProgress(water);
    }

    water.giveUp();
    ++nRejected_;
    proposal_ = step_.length();

    return true;
}


Foam::scalar Foam::timeStepControl::iterationFactor(const scalar nIterations)
{
    // After so many steps that did not grow, one does: what has nothing to do
    // with the length of a step must not hold it for ever
    const label patience = 50;

    // A cut is futile if more than this share of the iterations is left, and
    // after so many futile ones there are no more until the next sudden change
    const scalar worth = 0.9;
    const label maxFutile = 3;

    if (nIterations <= fewIterations_)
    {
        nHeld_ = 0;
        cutFrom_ = GREAT;
        return growth_;
    }

    ++nHeld_;
    if (nIterations > worth*cutFrom_)
    {
        ++nFutile_;
    }

    const bool shorter =
        nIterations > 2*fewIterations_ && nFutile_ < maxFutile;

    cutFrom_ = shorter ? nIterations : GREAT;

    return
        shorter ? 0.7
      : nHeld_ % patience == 0 ? growth_
      : 1.0;
}


Foam::scalar Foam::timeStepControl::errorFactor() const
{
    return 0.9*pow(errorRatio_, -1.0/(errorOrder_ + 1));
}


void Foam::timeStepControl::advance(const coupledFlow& water)
{
    const scalar t = runTime_.value();

    runTime_.setDeltaT(step_.length(), false);
    ++runTime_;

    scalar factor = iterationFactor(water.latest().iterations);
    if (errorRatio_ > 0)
    {
        factor = min(factor, max(errorFactor(), cut_));
    }

    // A step that was only fitted to an event does not bind the next one
    proposal_ =
        factor > 1
      ? max(min(proposal_, maxStep_), factor*step_.length())
      : factor*step_.length();
    beforePrevious_ = previous_;
    previous_ = step_.length();
    ++nSmooth_;

    if (water.nextRainChange(t + minStep_) <= runTime_.value() + minStep_)
    {
        nSmooth_ = 0;
        nFutile_ = 0;
        proposal_ = min(proposal_, firstStep_);
    }

    keep();
}

// ************************************************************************* //
