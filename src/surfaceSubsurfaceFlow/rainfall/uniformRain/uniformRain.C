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

#include "uniformRain.H"
#include "hyetograph.H"
#include "TableBase.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::uniformRain::uniformRain
(
    const word& entryName,
    const dictionary& dict
)
:
    dict_(dict),
    rate_(Function1<scalar>::New(entryName, dict)),
    hyetograph_
    (
        dynamic_cast<const Function1Types::hyetograph*>(rate_.get())
    ),
    nodes_()
{
    if
    (
        const auto* table =
            dynamic_cast<const Function1Types::TableBase<scalar>*>(rate_.get())
    )
    {
        nodes_ = table->x();

        for (const scalar t : nodes_)
        {
            if (table->value(t) < 0)
            {
                FatalIOErrorInFunction(dict_)
                    << "rainfall is " << table->value(t) << " m/s at t = "
                    << t << " s; rain must be >= 0" << exit(FatalIOError);
            }
        }
    }
    else if (!hyetograph_)
    {
        // Of a constant the whole, of any other function its beginning
        depth(0, 1);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::uniformRain::depth(const scalar t1, const scalar t2) const
{
    const scalar result = rate_->integrate(t1, t2);

    if (!(result >= 0))
    {
        FatalIOErrorInFunction(dict_)
            << "rainfall amounts to " << result << " m between t = " << t1
            << " s and " << t2 << " s; rain must be >= 0"
            << exit(FatalIOError);
    }

    return result;
}


void Foam::uniformRain::addDepth
(
    const scalar t1,
    const scalar t2,
    UList<scalar>& depths
) const
{
    const scalar added = depth(t1, t2);

    for (scalar& d : depths)
    {
        d += added;
    }
}


Foam::scalar Foam::uniformRain::nextBreakPoint(const scalar t) const
{
    if (hyetograph_)
    {
        return hyetograph_->nextChange(t);
    }

    const auto next = std::upper_bound(nodes_.cbegin(), nodes_.cend(), t);

    return next == nodes_.cend() ? VGREAT : *next;
}


Foam::rainfall::record Foam::uniformRain::recorded() const
{
    record result;

    if (hyetograph_)
    {
        result.given = true;
        result.begin = hyetograph_->start();
        result.end = hyetograph_->end();
        result.depth = hyetograph_->recorded();
    }

    return result;
}

// ************************************************************************* //
