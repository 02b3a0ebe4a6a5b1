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

void Foam::coupledFlow::assemblePart()
{
    matrix_->reset(leftOver_);

    if (part_ == part::soil)
    {
        // What ran to and from each face at the depths of the last runoff
        if (hasRunoff_)
        {
            overland_->assemble(*matrix_, *runoffWater_);
            matrix_->dropDerivatives();
        }

        water_->assemble(*matrix_, start_);
        assembleSoil();
    }
    else
    {
        // The infiltration that the soil has taken
        assembleSoil();
        matrix_->dropDerivatives();
        matrix_->hold(start_);

        runoffWater_->assemble(*matrix_, start_);
        overland_->assemble(*matrix_, *runoffWater_);
    }
}


void Foam::coupledFlow::toDepths()
{
    SubList<scalar> groundUnknowns(unknowns_, ground_.size(), start_);

    groundUnknowns = water_->depth();
}


void Foam::coupledFlow::toHeads()
{
    scalarField head(ground_.size());

    forAll(head, i)
    {
        const scalar depth = runoffWater_->depth()[i];

        head[i] = depth > 0 ? depth : min(water_->head()[i], scalar(0));
    }

    SubList<scalar> groundUnknowns(unknowns_, ground_.size(), start_);
    water_->initialise(head, groundUnknowns);
}


bool Foam::coupledFlow::solveSequential()
{
    // Change of the infiltration, relative, at which soil and runoff agree
    const scalar agreement = 1e-9;

    toDepths();
    runoffWater_->set(SubList<scalar>(unknowns_, ground_.size(), start_));
    runoffWater_->beginStep
    (
        step_.start,
        step_.conditionsEnd(),
        step_.stretch()
    );
    unknowns_ = unknownsOld_;
    hasRunoff_ = false;

    extrapolate();

    scalarField exchange(ground_.size(), Zero);

    for (label n = 0; n < controls_.nCouplings; ++n)
    {
        if (!iterate(part::soil))
        {
            return false;
        }

        const scalarField soilRemainder(matrix_->residual());
        const scalarField infiltrated(infiltration());

        toDepths();
        if (!iterate(part::runoff))
        {
            return false;
        }
        hasRunoff_ = true;

        remainder_ = matrix_->residual();
        SubList<scalar>(remainder_, start_) =
            SubList<scalar>(soilRemainder, start_);

        toHeads();
        water_->set(SubList<scalar>(unknowns_, ground_.size(), start_));

        const scalar change = gSumMag(scalarField(infiltrated - exchange));
        if (change <= agreement*gSumMag(infiltrated))
        {
            break;
        }
        exchange = infiltrated;
    }

    part_ = part::all;
    return true;
}

// ************************************************************************* //
