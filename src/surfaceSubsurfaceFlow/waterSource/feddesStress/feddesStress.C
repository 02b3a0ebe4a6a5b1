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

#include "feddesStress.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feddesStress::feddesStress(const dictionary& dict)
:
    heads_({-0.1, -0.25, -8, -160})
{
    dict.readIfPresent("stressHeads", heads_);

    bool ordered = true;
    for (const scalar head : heads_)
    {
        ordered = ordered && std::isfinite(head);
    }
    ordered =
        ordered
     && heads_[0] >= heads_[1]
     && heads_[1] > heads_[2]
     && heads_[2] > heads_[3];

    if (!ordered)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'stressHeads' of " << dict.name() << " is " << heads_
            << "; the four pressure heads [m] must fall: h1 >= h2 > h3 > h4"
            << nl << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::feddesStress::value(const scalar head) const
{
    if (head > heads_[1])
    {
        return
            heads_[0] > heads_[1]
          ? max((heads_[0] - head)/(heads_[0] - heads_[1]), scalar(0))
          : 1;
    }

    return
        head >= heads_[2] ? 1
      : head > heads_[3] ? (head - heads_[3])/(heads_[2] - heads_[3])
      : 0;
}


Foam::scalar Foam::feddesStress::slope(const scalar head) const
{
    if (head > heads_[1])
    {
        return head < heads_[0] ? -1/(heads_[0] - heads_[1]) : 0;
    }

    return
        head < heads_[2] && head > heads_[3]
      ? 1/(heads_[2] - heads_[3])
      : 0;
}

// ************************************************************************* //
