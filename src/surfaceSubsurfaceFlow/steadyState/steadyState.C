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

#include "steadyState.H"
#include "argList.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Longest step [s]: a steady state answers to it as to an endless one
static const scalar longestStep = 1e12;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::steadyState::holdRain
(
    const dictionary& dict,
    const argList& args
)
{
    const auto valid = [](const scalar rain) { return rain >= 0; };
    const string range(">= 0 m/s");

    if (args.found("steadyRain"))
    {
        scalar rain = 0;
        if (!readScalar(args["steadyRain"].c_str(), rain))
        {
            FatalErrorInFunction
                << "Option -steadyRain is " << args["steadyRain"]
                << ", which is no number; it must be " << range
                << exit(FatalError);
        }

        dictionary option(dictionary::null);
        option.name() = "-steadyRain";
        option.set("rain", rain);
        water_.holdRain(readChecked(option, "rain", valid, range));
    }
    else if (dict.found("rain"))
    {
        water_.holdRain(readChecked(dict, "rain", valid, range));
    }
}


bool Foam::steadyState::isSteady()
{
    // Water that rests is known by its change over the storage
    const waterVolumes moved(water_.moved());

    const scalar inflow = moved.inflow();
    const scalar changed = water_.changedStorage();

    change_ = changed/max(inflow, VSMALL);

    return
        change_ <= tolerance_
     || (
            step_.length() >= longestStep
         && changed <= tolerance_*water_.storageScale()
        );
}


void Foam::steadyState::report() const
{
    const waterVolumes moved(water_.moved());
    const scalar dt = step_.length();

    const scalar inflow = moved.inflow();
    const scalar outflow = moved.outflow();

    Info<< "Flows [m3/s]: rain " << moved.rain/dt
        << ", infiltration " << moved.infiltration/dt
        << ", surfaceOutflow " << moved.surfaceOutflow/dt
        << ", subsurfaceInflow " << moved.subsurfaceInflow/dt
        << ", subsurfaceOutflow " << moved.subsurfaceOutflow/dt
        << ", sourceInflow " << moved.sourceInflow/dt
        << ", sourceOutflow " << moved.sourceOutflow/dt << nl
        << "Imbalance [m3/s]: " << (inflow - outflow)/dt
        << ", of the inflow " << mag(inflow - outflow)/max(inflow, VSMALL)
        << nl
        << "Water [m3]: surfaceStorage " << water_.surfaceStorage()
        << ", subsurfaceStorage " << water_.subsurfaceStorage() << endl;
}


void Foam::steadyState::stop() const
{
    report();

    FatalErrorInFunction
        << "No steady state within " << label(maxSteps_)
        << " steps: in the last one, of " << step_.length()
        << " s, the storage changed by " << change_
        << " of the inflow; the limit is " << tolerance_
        << ". Is there a way out for all that flows in? More steps: maxSteps"
        << " in fvSolution, overlandRichards, steady" << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::steadyState::steadyState
(
    Time& runTime,
    coupledFlow& water,
    const argList& args
)
:
    runTime_(runTime),
    water_(water),
    tolerance_(0),
    maxSteps_(0),
    step_(),
    change_(GREAT)
{
    const dictionary& dict = water.controls().subOrEmptyDict("steady");
    checkKeys(dict, {"rain", "tolerance", "maxSteps"});

    tolerance_ = readCheckedOrDefault
    (
        dict,
        "tolerance",
        1e-8,
        [](const scalar x) { return x > 0 && x < 1; },
        "0 < tolerance < 1"
    );
    maxSteps_ = readCheckedOrDefault
    (
        dict,
        "maxSteps",
        200,
        [](const scalar n) { return n >= 1; },
        ">= 1"
    );
    holdRain(dict, args);

    const scalar first = runTime.deltaTValue();

    step_.start = runTime.value();
    step_.lengths = {first, first, first};
    step_.held = first;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::steadyState::addOptions()
{
    argList::addBoolOption
    (
        "steady",
        "Find the steady state under the conditions of the start time, write"
        " it there and end"
    );
    argList::addOption
    (
        "steadyRain",
        "m/s",
        "With -steady: rain on all of the ground instead of that of the start"
        " time"
    );
}


bool Foam::steadyState::wanted(const argList& args)
{
    const bool steady = args.found("steady");

    if (args.found("steadyRain") && !steady)
    {
        FatalErrorInFunction
            << "The option -steadyRain goes with -steady: the rain of other"
            << " runs is given by rainfall" << exit(FatalError);
    }

    return steady;
}


void Foam::steadyState::find()
{
    // Steps grow the faster the less work they are
    const scalar few = 8;
    const scalar many = 16;
    const scalar fast = 5;
    const scalar slow = 2;

    // After a failure
    const scalar cut = 0.2;
    const label maxCuts = 20;

    Info<< "\nLooking for the steady state" << endl;

    label nCuts = 0;

    for (label n = 1; n <= maxSteps_; ++n)
    {
        scalar& length = step_.lengths[0];

        if (!water_.solve(step_))
        {
            Info<< "Step of " << length << " s not converged: "
                << water_.trouble().c_str() << endl;

            if (++nCuts > maxCuts)
            {
                water_.stop(nCuts);
            }
            water_.giveUp();
            length *= cut;
            continue;
        }

        nCuts = 0;
        water_.accept();
        const bool steady = isSteady();

        Info<< "Step " << n << " of " << length << " s: "
            << water_.latest().iterations << " iterations, storage changes by "
            << change_ << " of the inflow" << endl;

        if (steady)
        {
            Info<< "Steady after " << n << " steps" << nl << endl;
            report();

            water_.forgetSteps();

            const int allDigits = 17;
            const unsigned int digits = IOstream::defaultPrecision(allDigits);
            runTime_.writeNow();
            IOstream::defaultPrecision(digits);

            Info<< "Written to " << runTime_.timeName() << nl << endl;
            return;
        }

        const label iterations = water_.latest().iterations;
        length = min
        (
            longestStep,
            length*(iterations <= few ? fast : iterations <= many ? slow : 1)
        );
    }

    stop();
}

// ************************************************************************* //
