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
#include "Tuple2.H"

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::Function1Types::hyetograph::hyetograph
(
    const word& entryName,
    const dictionary& dict
)
:
    Function1<scalar>(entryName),
    times_(),
    rates_()
{
    const scalar start(dict.lookupOrDefault<scalar>("start", 0));

    if (dict.found("values") == dict.found("depths"))
    {
        FatalIOErrorInFunction(dict)
            << "A hyetograph needs either values, pairs of the interval's end"
            << " [s] and the rate [m/s], or depths [mm] of equal intervals"
            << exit(FatalIOError);
    }

    if (dict.found("values"))
    {
        setRates(dict, start);
    }
    else
    {
        setDepths(dict, start);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::Function1Types::hyetograph::breakPoints() const
{
    DynamicList<scalar> result;

    forAll(times_, i)
    {
        const scalar before = (i > 0 ? rates_[i-1] : 0);
        const scalar after = (i < rates_.size() ? rates_[i] : 0);

        if (before != after)
        {
            result.append(times_[i]);
        }
    }

    return scalarList(std::move(result));
}


Foam::scalar Foam::Function1Types::hyetograph::value(const scalar t) const
{
    forAll(rates_, i)
    {
        if (t >= times_[i] && t < times_[i+1])
        {
            return rates_[i];
        }
    }

    return 0;
}


Foam::scalar Foam::Function1Types::hyetograph::integrate
(
    const scalar t1,
    const scalar t2
) const
{
    scalar depth = 0;

    forAll(rates_, i)
    {
        const scalar duration = min(t2, times_[i+1]) - max(t1, times_[i]);

        depth += rates_[i]*max(duration, scalar(0));
    }

    return depth;
}


void Foam::Function1Types::hyetograph::writeData(Ostream& os) const
{
    os.beginBlock(name());
    os.writeEntry("type", type());
    os.writeEntry("start", times_.first());

    List<Tuple2<scalar, scalar>> values(rates_.size());
    forAll(values, i)
    {
        values[i] = Tuple2<scalar, scalar>(times_[i+1], rates_[i]);
    }
    os.writeEntry("values", values);
    os.endBlock();
}

// ************************************************************************* //
