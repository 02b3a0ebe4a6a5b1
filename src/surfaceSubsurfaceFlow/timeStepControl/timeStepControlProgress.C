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

#include "timeStepControl.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::timeStepControl::checkProgress(const coupledFlow& water)
{
    ++nLost_;

    if (nLost_ < maxLost_)
    {
        return;
    }

    const scalar run =
        runTime_.endTime().value() - runTime_.startTime().value();
    const scalar advance = runTime_.value() - lostFrom_;

    if (advance < leastAdvance_*run)
    {
        OStringStream why;
        why << "after " << nLost_ << " trials without one in which time"
            << " advanced by " << advance << " s, less than "
            << leastAdvance_ << " of the run (maxLost, leastAdvance)";
        water.stop(string(why.str()));
    }

    nLost_ = 0;
    lostFrom_ = runTime_.value();
}


void Foam::timeStepControl::checkPace(const coupledFlow& water)
{
    // So many iterations make a pace
    const label window = 20000;

    const scalar end = step_.start + step_.length();

    // Shortened by what does not belong to the water, or after a sudden change
    if
    (
        nSmooth_ == 0
     || end >= nextEvent_ - minStep_
     || step_.length() >= 0.5*maxStep_
    )
    {
        nPaced_ = 0;
        pacedFrom_ = end;
        return;
    }

    if (nPaced_ < window)
    {
        return;
    }

    const scalar rest = runTime_.endTime().value() - end;
    const scalar needed = nPaced_*rest/(end - pacedFrom_);

    if (mostIterations_ > 0 && needed > mostIterations_)
    {
        OStringStream why;
        why << "No end in reach from t = " << end << " s: " << nPaced_
            << " iterations brought " << end - pacedFrom_ << " s, and the "
            << rest << " s to the end would take "
            << needed << ", more than mostIterations = " << mostIterations_
            << ". Where the state changes most";
        water.stopRun(string(why.str()));
    }

    nPaced_ = 0;
    pacedFrom_ = end;
}

// ************************************************************************* //
