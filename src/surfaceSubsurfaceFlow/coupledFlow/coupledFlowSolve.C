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

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool allFinite(const UList<scalar>& values)
{
    for (const scalar value : values)
    {
        if (!std::isfinite(value))
        {
            return false;
        }
    }

    return true;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledFlow::beginStep(const trial& step)
{
    step_ = step;
    performance_ = performance();
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


void Foam::coupledFlow::renewLagged(const bool again)
{
    if (soil_ && part_ != part::runoff)
    {
        soil_->renewCorrection();
    }
    if (overland_ && part_ != part::soil)
    {
        overland_->renewSurroundings(again);
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
    water_->assemble(*matrix_, start_);

    assembleSoil();

    if (overland_)
    {
        overland_->assemble(*matrix_, *water_);
    }
}


Foam::coupledFlow::limits Foam::coupledFlow::residualLimits() const
{
    // Round-off of storages and fluxes, of which the residual is a difference
    const scalar roundOff = 4*std::numeric_limits<scalar>::epsilon();

    // Water moved by the step, water there is, water that passes faces
    scalarList volumes(3, Zero);

    water_->addMoved(volumes[0], volumes[1]);
    if (soil_)
    {
        soil_->addMoved(*volumes_, volumes[0], volumes[1]);
        volumes[0] += sumMag(infiltration()());
        volumes[2] += step_.length()*soil_->fluxScale();
    }
    if (sources_)
    {
        volumes[0] += sources_->inflow() + sources_->outflow();
    }
    if (overland_)
    {
        volumes[2] += step_.length()*overland_->fluxScale();
    }

    Pstream::listCombineGather(volumes, plusEqOp<scalar>());
    Pstream::listCombineScatter(volumes);

    // What is left in single cells goes into their next step, so that only the
    // sum has to be small
    const scalar single = 100;

    limits result;
    result.balance = tolerance_*volumes[0] + roundOff*volumes[1];
    result.noise = roundOff*(volumes[1] + volumes[2]);
    result.norm = single*tolerance_*volumes[0] + result.noise;

    return result;
}


Foam::scalar Foam::coupledFlow::chopped
(
    const label i,
    const scalar from,
    const scalar step
) const
{
    // Just beyond a bend, where the derivatives are those of the other side
    const scalar beyond = 1e-12;

    // No head is beyond this [m]
    const scalar largest = 1e10;

    const scalar to = min(max(from + step, -largest), largest);

    if (!soil_ || part_ == part::runoff)
    {
        return max(to, scalar(0));
    }

    scalar result = to;

    const auto stopAt = [&](const scalar bend)
    {
        if (from < bend && result > bend)
        {
            result = min(result, bend + beyond);
        }
        else if (from > bend && result < bend)
        {
            result = max(result, bend - beyond);
        }
    };

    const label celli =
        i < start_ ? i : mesh_.faceOwner()[ground_.faces()[i - start_]];
    const scalar dryEnd = soil_->table(celli).dryEnd();

    stopAt(0);
    stopAt(dryEnd);
    if (sources_)
    {
        stopAt(dryEnd + waterSource::last);
    }
    if (i >= start_)
    {
        stopAt(water_->dryUnknown(i - start_));
    }

    return result;
}


void Foam::coupledFlow::update
(
    const scalarField& step,
    const bool renew,
    const bool search
)
{
    const label maxHalvings = search ? 6 : 0;

    const scalarField from(unknowns_);
    const scalar norm = matrix_->norm();
    const scalar imbalance = matrix_->imbalance();
    scalar fraction = 1;

    for (label halving = 0; halving <= maxHalvings; ++halving)
    {
        forAll(unknowns_, i)
        {
            unknowns_[i] = chopped(i, from[i], fraction*step[i]);
        }

        setStates();
        if (renew && halving == 0)
        {
            renewLagged(true);
        }
        assemble();

        // While a column fills residuals of both signs may grow, and their sum
        // falls
        if (matrix_->norm() < norm || matrix_->imbalance() < imbalance)
        {
            break;
        }
        fraction *= 0.5;
    }
}


bool Foam::coupledFlow::iterate(const part solved)
{
    // Share of the former residual at which it has ceased to fall, and
    // multiple of round-off at which this is no trouble
    const scalar ceased = 0.5;
    const scalar many = 100;

    // Share of the imbalance whose loss is worth more iterations: where a front
    // passes many cells in a step they fill one after the other
    const scalar worth = 0.5;

    part_ = solved;

    setStates();
    renewLagged(false);
    assemble();

    performance& p = performance_;
    scalarField change(unknowns_.size(), Zero);
    scalar norm = matrix_->norm();
    scalar previousNorm = GREAT;

    // Iterations that are allowed, and the imbalance when they were
    label nAllowed = maxIterations_;
    scalar allowedFrom = matrix_->imbalance();

    // The last iteration started from a small residual, and from where
    bool polished = false;
    struct
    {
        scalarField unknowns;
        scalar imbalance = 0;
    } rest;

    if (p.iterations == 0)
    {
        p.initialResidual = norm;
    }

    for (label n = 0; ; ++n)
    {
        const limits limit(residualLimits());

        p.finalResidual = norm;
        p.limit = limit.norm;

        const bool small = (norm <= limit.norm);
        const scalar imbalance = matrix_->imbalance();

        if (polished && imbalance > rest.imbalance)
        {
            unknowns_ = rest.unknowns;
            setStates();
            assemble();
        }

        p.converged =
            polished
         || (small && imbalance <= limit.balance)
         || (
                norm <= limit.norm + many*limit.noise
             && norm > ceased*previousNorm
            );

        if (p.converged && soil_)
        {
            p.dried = returnReduce(soil_->driedCell() >= 0, orOp<bool>());
            p.converged = !p.dried;
        }

        if (n >= nAllowed && imbalance < worth*allowedFrom)
        {
            nAllowed += maxIterations_;
            allowedFrom = imbalance;
        }

        if (p.converged || p.dried || n >= nAllowed || !(norm < GREAT))
        {
            return p.converged;
        }

        {
            const workTimes::section timed(times_, workTimes::linearSolver);
            p.linearIterations += solver_.solve(*matrix_, change);
        }
        ++p.iterations;

        if (returnReduce(!allFinite(change), orOp<bool>()))
        {
            p.singular = true;
            return false;
        }

        // One more iteration brings the balance in order, unless nothing but
        // round-off is left
        polished = small;
        if (small)
        {
            rest.unknowns = unknowns_;
            rest.imbalance = imbalance;
        }
        update(change, !small && n + 1 < nCorrectors_, !small);

        previousNorm = norm;
        norm = matrix_->norm();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledFlow::solve(const trial& step)
{
    beginStep(step);

    if (nCouplings_ > 0 && soil_ && overland_)
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

    volumes_->end();
    water_->endStep(step_.length());
    if (soil_)
    {
        soil_->endStep(step_.length());
    }
    setFields();

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

    if (history_)
    {
        history_->keep();
    }
}

// ************************************************************************* //
