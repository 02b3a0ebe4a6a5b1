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

#include "newtonProgress.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::newtonProgress::newtonProgress
(
    const label maxIterations,
    const scalar imbalance
)
:
    maxIterations_(maxIterations),
    nAllowed_(maxIterations),
    allowedFrom_(imbalance),
    n_(0),
    leastImbalance_(imbalance),
    nRecord_(0),
    gainedImbalance_(GREAT),
    gainedNorm_(GREAT),
    nGained_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::newtonProgress::begin
(
    const label n,
    const scalar norm,
    const scalar imbalance
)
{
    // Share of the least so far that is a gain
    const scalar gain = 0.9;

    // Share of the imbalance whose loss is worth more iterations: where a front
    // passes many cells in a step they fill one after the other
    const scalar worth = 0.5;

    n_ = n;

    if (imbalance < gain*gainedImbalance_)
    {
        gainedImbalance_ = imbalance;
        nGained_ = n;
    }
    if (norm < gain*gainedNorm_)
    {
        gainedNorm_ = norm;
        nGained_ = n;
    }

    if (n >= nAllowed_ && imbalance < worth*allowedFrom_)
    {
        nAllowed_ += maxIterations_;
        allowedFrom_ = imbalance;
    }
}


bool Foam::newtonProgress::record(const scalar imbalance)
{
    if (imbalance < leastImbalance_)
    {
        leastImbalance_ = imbalance;
        nRecord_ = n_;
        return true;
    }

    return false;
}


bool Foam::newtonProgress::circles() const
{
    // Half a step far beyond a bend ends at the same bend again
    const label nDirect = 20;

    return n_ > nRecord_ + nDirect;
}


bool Foam::newtonProgress::hopeless() const
{
    // Of 10 000 steps of odd soils that converged one in a thousand had gained
    // nothing for so long, and of those that did not converge two in three
    const label nPatient = 30;

    return n_ >= nAllowed_ || n_ > nGained_ + nPatient;
}

// ************************************************************************* //
