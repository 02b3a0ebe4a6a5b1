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

#include "coupledFlow.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledFlow::beginStep(const stepTrial& step)
{
    step_ = step;
    performance_ = stepPerformance();
    part_ = part::all;

    const scalar end = step.conditionsEnd();

    // Prescribed heads are those at the end of the step
    Time& runTime = const_cast<Time&>(mesh_.time());
    const label timeIndex = runTime.timeIndex();
    runTime.setTime(end, timeIndex + 1);

    water_->beginStep(step.start, end, step.stretch());
    if (sources_)
    {
        sources_->beginStep(step.start, end, step.stretch());
    }
    if (soil_)
    {
        soil_->beginStep();
    }

    runTime.setTime(step.start, timeIndex);

    scalarField content(unknowns_.size());
    scalarField room(unknowns_.size(), GREAT);

    SubList<scalar>(content, ground_.size(), start_) = water_->volume();
    if (soil_)
    {
        soil_->capacities
        (
            SubList<scalar>(content, start_),
            SubList<scalar>(room, start_)
        );
    }

    const scalar ratio = step.lengths[0]/step.lengths[1];

    volumes_->begin
    (
        step.length(),
        step.carries ? scheme_->carry(ratio) : 0,
        ratio,
        content,
        room
    );
}


void Foam::coupledFlow::extrapolate()
{
    if (step_.nRates == 0)
    {
        return;
    }

    const scalar dt = step_.lengths[0];
    const scalar slope =
        step_.nRates < 2
      ? 0
      : dt*(dt + step_.lengths[1])/(step_.lengths[1] + step_.lengths[2]);

    const Pair<scalar> weights(dt + slope, -slope);

    if (soil_)
    {
        soil_->extrapolate(weights, SubList<scalar>(unknowns_, start_));
    }
    water_->extrapolate
    (
        weights,
        SubList<scalar>(unknowns_, ground_.size(), start_)
    );
}


void Foam::coupledFlow::setStates()
{
    const workTimes::section timed(times_, workTimes::states);

    if (soil_ && part_ != part::runoff)
    {
        soil_->setCells(SubList<scalar>(unknowns_, start_));
    }

    solvedWater().set(SubList<scalar>(unknowns_, ground_.size(), start_));

    if (overland_ && part_ != part::soil)
    {
        overland_->setDepth(solvedWater());
    }
}


void Foam::coupledFlow::renewLagged(const label renewal)
{
    // The soil's part settles more slowly: it is renewed this many times as
    // often at most, and after so many renewals by halves
    const label moreOften = 2;
    const label outright = 2;

    const label n = controls_.nNonOrthogonalCorrectors;

    const auto due = [&](const label most)
    {
        return renewal == 0 || renewal < most;
    };

    if
    (
        soil_ && part_ != part::runoff && due(moreOften*n)
     && (
            renewal < outright
         || soil_->unsettled() > controls_.nonOrthogonalTolerance
        )
    )
    {
        soil_->renewCorrection(renewal < outright ? 1 : 0.5);
    }
    if (overland_ && part_ != part::soil && due(n))
    {
        overland_->renewSurroundings(renewal > 0);
    }
}


void Foam::coupledFlow::assembleSoil()
{
    if (sources_)
    {
        sources_->assemble(*matrix_, start_);
    }

    if (soil_)
    {
        soil_->assemble
        (
            *matrix_,
            ground_,
            step_.start,
            step_.conditionsEnd(),
            step_.fallback
        );
    }
}


void Foam::coupledFlow::assemble()
{
    const workTimes::section timed(times_, workTimes::assembly);

    if (part_ != part::all)
    {
        assemblePart();
        return;
    }

    matrix_->reset(leftOver_);

    // Zhu2022 Eq. 7 at the ground's faces: dh/dt - R, the flow over the edges
    // below
    water_->assemble(*matrix_, start_);

    // Zhu2022 Eq. 8 in the cells, and the infiltration I between both
    assembleSoil();

    // Zhu2022 Eq. 7: div of the discharge over a metre of width
    if (overland_)
    {
        overland_->assemble(*matrix_, *water_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledFlow::solve(const stepTrial& step)
{
    beginStep(step);

    if (controls_.nCouplings > 0 && soil_ && overland_)
    {
        return solveSequential();
    }

    extrapolate();

    const bool converged = iterate(part::all);
    remainder_ = matrix_->residual();

    return converged;
}


Foam::scalar Foam::coupledFlow::localError(const timeScheme& scheme) const
{
    const FixedList<scalar, 3> weights(scheme.errorWeights(step_.lengths));

    // In unsaturated and in saturated soil, and on the ground
    Pair<scalar> soilError(0, 0);
    Pair<scalar> soilTotal(0, 0);
    scalar groundError = 0;
    scalar groundTotal = 0;

    if (soil_)
    {
        soil_->localError(weights, step_.length(), soilError, soilTotal);
    }
    water_->localError(weights, step_.length(), groundError, groundTotal);

    scalarList error({soilError[0], soilError[1], groundError});
    scalarList total({soilTotal[0], soilTotal[1], groundTotal});

    Pstream::listCombineGather(error, plusEqOp<scalar>());
    Pstream::listCombineScatter(error);
    Pstream::listCombineGather(total, plusEqOp<scalar>());
    Pstream::listCombineScatter(total);

    // Saturated soil would make the error look smaller the more there is of
    // it: it counts only where all is saturated
    const label soil = total[0] > 0 ? 0 : 1;

    return sqrt
    (
        max
        (
            error[soil]/max(total[soil], VSMALL),
            error[2]/max(total[2], VSMALL)
        )
    );
}


void Foam::coupledFlow::giveUp()
{
    unknowns_ = unknownsOld_;
    part_ = part::all;
    setStates();
}


void Foam::coupledFlow::accept()
{
    unknownsOld_ = unknowns_;
    leftOver_ = remainder_;

    // A face without water has no storage: what is left in it would be a flux
    // that grows as the step is cut, and no head might drive it. The soil below
    // takes it
    forAll(water_->depth(), i)
    {
        if (soil_ && water_->depth()[i] <= 0)
        {
            const label facei = ground_.faces()[i];

            leftOver_[mesh_.faceOwner()[facei]] += leftOver_[start_ + i];
            leftOver_[start_ + i] = 0;
        }
    }
    keptRemainder_->keep(leftOver_);

    volumes_->end();
    water_->endStep(step_.length());
    if (soil_)
    {
        soil_->endStep(step_.length());
    }
    if (overland_)
    {
        overland_->endStep();
    }
    setFields();
    totals_->add(moved());

    if (history_)
    {
        history_->keep();
    }
}


void Foam::coupledFlow::forgetSteps()
{
    volumes_->clear();
    volumes_->end();
    leftOver_ = Zero;
    keptRemainder_->keep(leftOver_);
    totals_->forget(subsurfaceStorage() + surfaceStorage(), storageScale());

    if (history_)
    {
        history_->keep();
    }
}

// ************************************************************************* //
