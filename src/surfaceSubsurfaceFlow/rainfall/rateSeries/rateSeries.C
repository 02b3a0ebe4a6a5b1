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

#include "rateSeries.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::rateSeries::integral(const scalar t1, const scalar t2) const
{
    const scalarList& nodes = nodes_.times();

    if (nodes.empty())
    {
        return rate_->integrate(t1, t2);
    }

    const scalar first = nodes.first();
    const scalar last = nodes.last();

    // A table integrates between its nodes only
    const auto between = [this](const scalar from, const scalar to)
    {
        return from < to ? rate_->integrate(from, to) : 0;
    };

    if (nodes_.repeats())
    {
        const scalar period = last - first;
        const scalar n1 = std::floor((t1 - first)/period);
        const scalar n2 = std::floor((t2 - first)/period);

        return
            (n2 - n1)*between(first, last)
          + between(first, min(t2 - n2*period, last))
          - between(first, min(t1 - n1*period, last));
    }

    scalar result =
        between(min(max(t1, first), last), min(max(t2, first), last));

    if (t1 < first)
    {
        result += rate_->value(t1)*(min(t2, first) - t1);
    }
    if (t2 > last)
    {
        result += rate_->value(t2)*(t2 - max(t1, last));
    }

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rateSeries::rateSeries
(
    const word& entryName,
    const dictionary& dict,
    const scalar least
)
:
    dict_(dict),
    entry_(entryName),
    least_(least),
    rate_(Function1<scalar>::New(entryName, dict)),
    hyetograph_
    (
        dynamic_cast<const Function1Types::hyetograph*>(rate_.get())
    ),
    nodes_(*rate_),
    checked_(true)
{
    for (const scalar t : nodes_.times())
    {
        if (rate_->value(t) < least_)
        {
            FatalIOErrorInFunction(dict_)
                << entry_ << " is " << rate_->value(t) << " at t = "
                << t << " s; it must be >= " << least_
                << exit(FatalIOError);
        }
    }

    if (nodes_.times().empty() && !hyetograph_)
    {
        // Of a constant the whole, of any other function its beginning
        checked_ = false;
        amount(0, 1);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rateSeries::amount(const scalar t1, const scalar t2) const
{
    const scalar result = integral(t1, t2);
    const scalar least = least_*(t2 - t1);

    if (checked_)
    {
        // The difference of two integrals: less is round-off
        return max(result, least);
    }

    if (!std::isfinite(result) || result < least)
    {
        FatalIOErrorInFunction(dict_)
            << entry_ << " amounts to " << result << " between t = " << t1
            << " s and " << t2 << " s; the rate must be >= " << least_
            << exit(FatalIOError);
    }

    return result;
}


Foam::scalar Foam::rateSeries::nextBreakPoint(const scalar t) const
{
    if (hyetograph_)
    {
        return hyetograph_->nextChange(t);
    }

    return nodes_.next(t);
}

// ************************************************************************* //
