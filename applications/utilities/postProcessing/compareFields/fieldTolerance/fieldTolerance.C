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

#include "fieldTolerance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldTolerance::fieldTolerance(const dictionary& dict)
:
    limits_(GREAT)
{
    const auto& names = fieldDifference::measureNames;

    for (const entry& e : dict)
    {
        if (!names.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown measure " << e.keyword() << nl
                << "    Valid measures: " << flatOutput(names.sortedToc())
                << exit(FatalIOError);
        }

        const scalar limit = dict.get<scalar>(e.keyword());

        if (!(limit >= 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " is " << limit
                << "; a tolerance must be >= 0"
                << exit(FatalIOError);
        }

        limits_[names[e.keyword()]] = limit;
    }

    if (dict.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No tolerance is given for " << dict.dictName() << nl
            << "    Valid measures: " << flatOutput(names.sortedToc())
            << exit(FatalIOError);
    }
}


Foam::fieldTolerance::fieldTolerance
(
    const fieldDifference::measure measure,
    const scalar limit
)
:
    limits_(GREAT)
{
    limits_[measure] = limit;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fieldTolerance::accepts
(
    const fieldDifference& difference,
    Ostream& os
) const
{
    bool accepted = true;

    for (label i = 0; i < fieldDifference::nMeasures; ++i)
    {
        const auto measure = fieldDifference::measure(i);

        if (difference[measure] > limits_[measure])
        {
            accepted = false;
            os  << "        " << fieldDifference::measureNames[measure]
                << ' ' << difference[measure] << " exceeds "
                << limits_[measure] << nl;
        }
    }

    return accepted;
}


// ************************************************************************* //
