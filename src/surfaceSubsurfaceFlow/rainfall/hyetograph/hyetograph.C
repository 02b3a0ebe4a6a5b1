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

#include "hyetograph.H"
#include "readChecked.H"
#include "Tuple2.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace Function1Types
{
    makeScalarFunction1(hyetograph);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::Function1Types::hyetograph::setRates
(
    const dictionary& dict,
    const scalar start
)
{
    const List<Tuple2<scalar, scalar>> values
    (
        dict.lookup("values")
    );

    times_.setSize(values.size() + 1);
    rates_.setSize(values.size());
    times_[0] = start;

    forAll(values, i)
    {
        times_[i+1] = values[i].first();
        rates_[i] = values[i].second();

        if (times_[i+1] <= times_[i])
        {
            FatalIOErrorInFunction(dict)
                << "values: interval " << i << " of the hyetograph ends at "
                << times_[i+1] << " s, not after its beginning at "
                << times_[i] << " s" << exit(FatalIOError);
        }

        if (rates_[i] < 0)
        {
            FatalIOErrorInFunction(dict)
                << "values: rain of interval " << i << " is " << rates_[i]
                << " m/s; rain must be >= 0" << exit(FatalIOError);
        }
    }
}


void Foam::Function1Types::hyetograph::setDepths
(
    const dictionary& dict,
    const scalar start
)
{
    const scalarList depths(dict.lookup("depths"));
    const scalar interval(dict.lookupOrDefault<scalar>("interval", 3600));
    const scalar metresPerMillimetre = 1e-3;

    if (interval <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "interval " << interval << " s; it must be > 0"
            << exit(FatalIOError);
    }

    times_.setSize(depths.size() + 1);
    rates_.setSize(depths.size());
    times_[0] = start;

    forAll(depths, i)
    {
        times_[i+1] = start + (i + 1)*interval;
        rates_[i] = metresPerMillimetre*depths[i]/interval;

        if (depths[i] < 0)
        {
            FatalIOErrorInFunction(dict)
                << "depths: rain of interval " << i << " is " << depths[i]
                << " mm; rain must be >= 0" << exit(FatalIOError);
        }
    }
}


void Foam::Function1Types::hyetograph::setRecord(const dictionary& dict)
{
    record_.reset(new rainRecord(dict));

    times_ = record_->times();
    rates_ = record_->rates();
    before_ = record_->rateBefore();
    after_ = record_->rateAfter();
}


Foam::label Foam::Function1Types::hyetograph::interval(const scalar t) const
{
    return
        std::upper_bound(times_.cbegin(), times_.cend(), t)
      - times_.cbegin() - 1;
}


Foam::scalar Foam::Function1Types::hyetograph::rate(const label i) const
{
    const label n = rates_.size();
    const scalar result = i < 0 ? before_ : i < n ? rates_[i] : after_;

    if (result < 0)
    {
        record_->stopAtGap
        (
            i < 0 ? -VGREAT : times_[i],
            i < n ? times_[i + 1] : VGREAT
        );
    }

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::Function1Types::hyetograph::hyetograph
(
    const word& entryName,
    const dictionary& dict
)
:
    Function1<scalar>(entryName),
    dict_(dict),
    times_(),
    rates_(),
    before_(0),
    after_(0),
    record_()
{
    // Without a dictionary of its own it shares that of its entry
    if (dict.found("type"))
    {
        checkKeys
        (
            dict,
            {
                "type", "values", "depths", "start", "file", "separator",
                "unit", "timeUnit", "timeColumn", "rainColumn", "origin",
                "interval", "stamp", "gapPolicy", "missing"
            }
        );
    }

    const scalar start(dict.lookupOrDefault<scalar>("start", 0));

    const label nGiven =
        label(dict.found("values")) + label(dict.found("depths"))
      + label(dict.found("file"));

    if (nGiven != 1)
    {
        FatalIOErrorInFunction(dict)
            << "A hyetograph needs one of values, pairs of the interval's end"
            << " [s] and the rate [m/s], depths [mm] of equal intervals, and"
            << " a csv file" << exit(FatalIOError);
    }

    if (dict.found("values"))
    {
        setRates(dict, start);
    }
    else if (dict.found("depths"))
    {
        setDepths(dict, start);
    }
    else
    {
        setRecord(dict);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::Function1Types::hyetograph::nextChange
(
    const scalar t
) const
{
    const auto known = [&](const label i)
    {
        return i < 0 ? before_ : i < rates_.size() ? rates_[i] : after_;
    };

    for (label i = interval(t) + 1; i < times_.size(); ++i)
    {
        if (known(i) != known(i - 1))
        {
            return times_[i];
        }
    }

    return VGREAT;
}


Foam::scalar Foam::Function1Types::hyetograph::value(const scalar t) const
{
    return rate(interval(t));
}


Foam::scalar Foam::Function1Types::hyetograph::integrate
(
    const scalar t1,
    const scalar t2
) const
{
    scalar depth = 0;
    scalar t = t1;

    for (label i = interval(t1); t < t2; ++i)
    {
        const scalar end = i + 1 < times_.size() ? min(t2, times_[i + 1]) : t2;

        depth += rate(i)*(end - t);
        t = end;
    }

    return depth;
}


Foam::scalar Foam::Function1Types::hyetograph::recorded() const
{
    scalar depth = 0;

    forAll(rates_, i)
    {
        depth += max(rates_[i], scalar(0))*(times_[i + 1] - times_[i]);
    }

    return depth;
}


void Foam::Function1Types::hyetograph::writeData(Ostream& os) const
{
    dict_.writeEntry(name(), os);
}

// ************************************************************************* //
