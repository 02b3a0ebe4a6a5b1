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

#include "tableNodes.H"
#include "StringStream.H"
#include "TableBase.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tableNodes::tableNodes(const scalarList& times)
:
    times_(times),
    period_(0)
{}


Foam::tableNodes::tableNodes(const Function1<scalar>& function)
:
    times_(),
    period_(0)
{
    const auto* table =
        dynamic_cast<const Function1Types::TableBase<scalar>*>(&function);

    if (!table)
    {
        return;
    }

    times_ = table->x();

    // What a table does beyond its ends it tells only when it is written
    OStringStream os;
    table->writeEntries(os);
    IStringStream is(os.str());

    if (dictionary(is).lookupOrDefault<word>("outOfBounds", "") == "repeat")
    {
        period_ = times_.last() - times_.first();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::tableNodes::next(const scalar t) const
{
    const scalar past =
        repeats() ? std::floor((t - times_.first())/period_)*period_ : 0;

    for (const scalar shift : {past, past + period_})
    {
        const auto node =
            std::upper_bound(times_.cbegin(), times_.cend(), t - shift);

        // Round-off of the sum may fall on the time that was asked for
        if (node != times_.cend() && *node + shift > t)
        {
            return *node + shift;
        }
    }

    return VGREAT;
}

// ************************************************************************* //
