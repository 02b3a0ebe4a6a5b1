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

#include "slideVerdict.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideVerdict::slideVerdict(const dictionary& dict)
:
    height_(-1),
    relief_(0),
    stableBelow_(0.01),
    failedAbove_(0.25)
{
    checkKeys(dict, {"height", "stableBelow", "failedAbove"});

    height_ = readCheckedOrDefault
    (
        dict,
        "height",
        height_,
        [](const scalar x){ return x > 0; },
        "> 0 m"
    );
    stableBelow_ = readCheckedOrDefault
    (
        dict,
        "stableBelow",
        stableBelow_,
        [](const scalar x){ return x > 0; },
        "> 0, a share of the height"
    );
    failedAbove_ = readCheckedOrDefault
    (
        dict,
        "failedAbove",
        failedAbove_,
        [this](const scalar x){ return x >= stableBelow_; },
        ">= stableBelow, a share of the height"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::slideVerdict::judge(const scalar maxDisplacement) const
{
    if (maxDisplacement < stableBelow())
    {
        return "stable";
    }

    return maxDisplacement > failedAbove() ? "failed" : "critical";
}

// ************************************************************************* //
