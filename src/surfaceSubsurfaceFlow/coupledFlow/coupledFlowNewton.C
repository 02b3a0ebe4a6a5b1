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

//- Multiple of the tolerance that the residuals of single cells may have: what
//  is left goes into the next step
static const scalar single = 100;

//- Just beyond a bend of the curves, where the derivatives are those of the
//  other side
static const scalar beyond = 1e-12;

//- No head is beyond this [m]
static const scalar largestHead = 1e10;


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

Foam::coupledFlow::limits Foam::coupledFlow::residualLimits() const
{
    // Round-off of storages and fluxes, of which the residual is a difference
    const scalar epsilon = std::numeric_limits<scalar>::epsilon();
    const scalar roundOff = 4*epsilon;

    // Shares of the water there is and of what the step moves beyond which
    // round-off is no excuse: the fluxes of a step of that length cannot be told
    // from none, unless what they move is far more. No more is moved than has
    // crossed the boundary so far: a trial that goes astray moves anything
    const scalar largestNoise = 1e-10;
    const scalar largestNoiseMoved = 1e-6;

    // The sum of the residuals is the error of the balance: small also against
    // all that has come in and left so far, where that is less than what the step
    // moves inside
    const scalar margin = 0.25;

    // And share of the water there is: the balance is judged against 1e-6 of it
    // at least, of which this is 4e-11. Round-off of many cells is less in sum
    // than epsilon of what they hold
    const scalar sumRoundOff = 0.2*epsilon;

    // Share of the water there is that round-off of the fluxes through the
    // boundary may take from the balance
    const scalar largestLoss = 8e-15;

    // Water that came in or left, by which storages changed, that infiltrated,
    // that there is, and that passes faces
    scalarList volumes(5, Zero);
    scalar& crossed = volumes[0];
    scalar& changed = volumes[1];
    scalar& infiltrated = volumes[2];
    scalar& total = volumes[3];
    scalar& passing = volumes[4];

    water_->addMoved(crossed, changed, total);
    if (soil_)
    {
        soil_->addMoved(*volumes_, crossed, changed, total);
        infiltrated += sumMag(infiltration()());
        passing += step_.length()*soil_->fluxScale();
    }
    if (sources_)
    {
        crossed += sources_->inflow() + sources_->outflow();
    }
    if (overland_)
    {
        passing += step_.length()*overland_->fluxScale();
    }

    Pstream::listCombineGather(volumes, plusEqOp<scalar>());
    Pstream::listCombineScatter(volumes);

    // No more infiltrates than there is, and a step does not exchange the water
    // more often than this: a trial that goes astray has fluxes of any size, which
    // would make its residuals look small
    const scalar exchanges = 100;

    const scalar most =
        exchanges
       *(totals_->initialScale() + totals_->crossed() + water_->rain());

    crossed = min(crossed, most);
    const scalar moved =
        min(crossed + changed + min(infiltrated, crossed + total), most);

    limits result;
    result.balance =
        controls_.tolerance*min(margin*(totals_->crossed() + crossed), moved)
      + sumRoundOff*total;
    result.noise = min
    (
        roundOff*(total + passing),
        max
        (
            largestNoise*total,
            largestNoiseMoved*min(moved, totals_->crossed())
        )
    );
    result.loss = min(result.noise, largestLoss*total);
    result.norm = single*controls_.tolerance*moved + result.noise;

    return result;
}


Foam::scalar Foam::coupledFlow::imbalance() const
{
    return matrix_->imbalance
    (
        part_ == part::soil ? start_ : unknowns_.size()
    );
}


bool Foam::coupledFlow::singular(const scalarField& change) const
{
    if (!allFinite(change))
    {
        return true;
    }

    forAll(change, i)
    {
        if (unknowns_[i] > 0 && mag(change[i]) > largestHead)
        {
            return true;
        }
    }

    return false;
}


void Foam::coupledFlow::wetGround()
{
    forAll(ground_.faces(), i)
    {
        scalar& unknown = unknowns_[start_ + i];
        unknown = max(unknown, water_->dryUnknown(i) + beyond);
    }

    setStates();
    assemble();
}


Foam::scalar Foam::coupledFlow::chopped
(
    const label i,
    const scalar from,
    const scalar step
) const
{
    const scalar to = min(max(from + step, -largestHead), largestHead);

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

    // Where evaporation sets in it is steep, and its slope falls from there on:
    // drier, nothing would say how far to come back; from here on the iteration
    // does not go too far
    const auto stopWetter = [&](const scalar bend)
    {
        const scalar at = bend + beyond;

        if ((from < bend && result > at) || (from > at && result < at))
        {
            result = at;
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
        if (sources_)
        {
            stopWetter(soil_->table(celli).tauOfHead(sources_->driestHead()));
        }
    }

    return result;
}


void Foam::coupledFlow::update
(
    const scalarField& step,
    const label renewal,
    const bool search,
    newtonProgress& progress
)
{
    const label maxHalvings = search ? 6 : 0;

    const scalarField from(unknowns_);
    const scalar norm = matrix_->norm();
    const bool remaining = progress.circles();
    scalar fraction = 1;

    // By which residuals may grow whose sum is less than ever
    const scalar growth = 10;

    for (label halving = 0; halving <= maxHalvings; ++halving)
    {
        forAll(unknowns_, i)
        {
            unknowns_[i] =
                remaining && i >= start_
              ? from[i] + fraction*(chopped(i, from[i], step[i]) - from[i])
              : chopped(i, from[i], fraction*step[i]);
        }

        setStates();
        if (renewal > 0 && halving == 0)
        {
            renewLagged(renewal);
        }
        assemble();

        // While a column fills residuals of both signs may grow, and their sum
        // falls. It falls for good: else two states could follow one another
        const bool record = progress.record(imbalance());

        if (matrix_->norm() < (record ? growth : 1)*norm)
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

    // Multiple of its limit that the imbalance may then have, and a larger one
    // after some iterations at rest, if it is small against what the step moves
    // or round-off. More of it is water that nobody sent
    const scalar tolerated = 2;
    const scalar toleratedAtLast = 100;
    const label nRest = 2;

    part_ = solved;

    setStates();
    renewLagged(0);
    assemble();

    stepPerformance& p = performance_;
    scalarField change(unknowns_.size(), Zero);
    scalar norm = matrix_->norm();
    scalar previousNorm = GREAT;

    newtonProgress progress(controls_.maxIterations, imbalance());

    // The latest iteration started from a small residual, and from where
    bool polished = false;
    label nAtRest = 0;

    // Water was tried on all of the ground
    bool triedWet = false;

    struct
    {
        scalarField unknowns;
        scalar norm = 0;
        scalar imbalance = 0;
        limits limit;
    } rest;

    if (p.iterations == 0)
    {
        p.initialResidual = norm;
    }

    for (label n = 0; ; ++n)
    {
        const limits limit(residualLimits());

        const bool small = (norm <= limit.norm);
        const scalar imbalance = this->imbalance();

        // The state before the latest iteration is the better one. It is held to
        // its own limits
        const bool restBetter = polished && rest.imbalance < imbalance;
        const limits& taken = restBetter ? rest.limit : limit;

        p.finalResidual = restBetter ? rest.norm : norm;
        p.limit = taken.norm;
        p.imbalance = restBetter ? rest.imbalance : imbalance;
        p.imbalanceLimit = taken.balance;

        // Nothing but round-off seems to be left
        const bool atRest =
            (polished && imbalance > ceased*rest.imbalance)
         || (
                norm <= limit.norm + many*limit.noise
             && norm > ceased*previousNorm
            );

        scalar restLimit = tolerated*taken.balance;
        if (atRest && nAtRest++ >= nRest)
        {
            restLimit = min
            (
                restLimit + (taken.norm - taken.noise)/single + taken.loss,
                toleratedAtLast*taken.balance
            );
        }

        p.converged =
            (small && imbalance <= limit.balance)
         || (atRest && p.imbalance <= restLimit);

        if (p.converged && restBetter)
        {
            unknowns_ = rest.unknowns;
            setStates();
            assemble();
        }

        if (p.converged && soil_)
        {
            p.dried = returnReduce(soil_->driedCell() >= 0, orOp<bool>());
            p.converged = !p.dried;
        }

        progress.begin(n, norm, imbalance);

        if (p.converged || p.dried || progress.hopeless() || !(norm < GREAT))
        {
            return p.converged;
        }

        {
            const workTimes::section timed(times_, workTimes::linearSolver);
            p.linearIterations +=
                small && polished
              ? solver_.solveClosely(*matrix_, change)
              : solver_.solve(*matrix_, change);
        }
        ++p.iterations;

        if (returnReduce(singular(change), orOp<bool>()))
        {
            const bool finite = returnReduce(allFinite(change), andOp<bool>());

            if
            (
                (!finite || progress.circles())
             && !triedWet && part_ != part::runoff
            )
            {
                triedWet = true;
                wetGround();
                previousNorm = GREAT;
                norm = matrix_->norm();
                continue;
            }
            if (!finite)
            {
                p.singular = true;
                return false;
            }
        }

        // Iterations that bring the balance in order, unless nothing but round-off
        // is left
        polished = small;
        if (small)
        {
            rest.unknowns = unknowns_;
            rest.norm = norm;
            rest.imbalance = imbalance;
            rest.limit = limit;
        }
        update(change, small ? 0 : n + 1, !small, progress);

        previousNorm = norm;
        norm = matrix_->norm();
    }
}

// ************************************************************************* //
