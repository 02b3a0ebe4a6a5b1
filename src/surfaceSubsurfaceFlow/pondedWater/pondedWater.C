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

#include "pondedWater.H"
#include "subsurfaceFlow.H"
#include "coupledMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pondedWater::pondedWater
(
    const groundSurface& ground,
    subsurfaceFlow* soil
)
:
    ground_(ground),
    soil_(soil),
    head_(ground.size(), Zero),
    dHead_(ground.size(), 1),
    depth_(ground.size(), Zero),
    dDepth_(ground.size(), 1),
    depthOld_(ground.size(), Zero),
    depthRate_(ground.size(), Zero),
    depthRateOld_(ground.size(), Zero),
    rainVolume_(ground.size(), Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::pondedWater::dryUnknown(const label i) const
{
    if (!soil_)
    {
        return 0;
    }

    const polyMesh& mesh = soil_->psi().mesh();
    const label celli = mesh.faceOwner()[ground_.faces()[i]];

    return soil_->table(celli).tauOfHead(0);
}


void Foam::pondedWater::initialise
(
    const UList<scalar>& head,
    SubList<scalar>& unknowns
) const
{
    forAll(unknowns, i)
    {
        if (soil_)
        {
            const polyMesh& mesh = soil_->psi().mesh();
            const label celli = mesh.faceOwner()[ground_.faces()[i]];
            unknowns[i] = soil_->table(celli).tauOfHead(head[i]);
        }
        else
        {
            unknowns[i] = max(head[i], scalar(0));
        }
    }
}


void Foam::pondedWater::beginStep
(
    const scalar t1,
    const scalar t2,
    const scalar stretch
)
{
    depthOld_ = depth_;
    rainVolume_ = stretch*ground_.rainVolume(t1, t2);
}


void Foam::pondedWater::extrapolate
(
    const Pair<scalar>& weights,
    SubList<scalar> unknowns
) const
{
    forAll(depth_, i)
    {
        const scalar change =
            weights.first()*depthRate_[i] + weights.second()*depthRateOld_[i];

        if (depth_[i] > 0 && depth_[i] + change > 0)
        {
            unknowns[i] += change/dDepth_[i];
        }
    }
}


void Foam::pondedWater::set(const UList<scalar>& unknowns)
{
    forAll(head_, i)
    {
        if (soil_)
        {
            const label facei = ground_.faces()[i];
            soil_->setGround(facei, unknowns[i]);

            const soilTable::state& s = soil_->boundaryState(facei);
            head_[i] = s.head;
            dHead_[i] = s.dHead;
        }
        else
        {
            head_[i] = unknowns[i];
        }

        // Without soil the derivative is that of wet ground also at zero
        // depth, where nothing else holds the unknown
        const bool wet = (head_[i] > 0 || !soil_);

        depth_[i] = max(head_[i], scalar(0));
        dDepth_[i] = wet ? dHead_[i] : 0;
    }
}


void Foam::pondedWater::assemble
(
    coupledMatrix& matrix,
    const label start
) const
{
    const scalarField& area = ground_.planArea();

    forAll(head_, i)
    {
        matrix.add
        (
            start + i,
            area[i]*(depth_[i] - depthOld_[i]) - rainVolume_[i],
            area[i]*dDepth_[i]
        );
    }
}


void Foam::pondedWater::endStep(const scalar dt)
{
    depthRateOld_ = depthRate_;
    depthRate_ = (depth_ - depthOld_)/dt;
}


void Foam::pondedWater::localError
(
    const FixedList<scalar, 3>& weights,
    const scalar dt,
    scalar& error,
    scalar& total
) const
{
    // Depth below which errors count as absolute [m]
    const scalar depthScale = 1e-3;

    const scalarField& area = ground_.planArea();

    forAll(depth_, i)
    {
        error += area[i]*sqr
        (
            weights[0]*(depth_[i] - depthOld_[i])/dt
          + weights[1]*depthRate_[i]
          + weights[2]*depthRateOld_[i]
        );
        total += area[i]*sqr(depth_[i] + depthScale);
    }
}


Foam::scalar Foam::pondedWater::changedStorage() const
{
    return sumProd(ground_.planArea(), mag(depth_ - depthOld_)());
}


Foam::scalar Foam::pondedWater::gainedStorage() const
{
    return sumProd(ground_.planArea(), (depth_ - depthOld_)());
}


void Foam::pondedWater::addMoved
(
    scalar& crossed,
    scalar& changed,
    scalar& total
) const
{
    crossed += sum(rainVolume_);
    changed += changedStorage();
    total += sumProd(ground_.planArea(), depth_);
}


Foam::scalar Foam::pondedWater::storage() const
{
    return gSumProd(depth_, ground_.planArea());
}


Foam::scalar Foam::pondedWater::rain() const
{
    return gSum(rainVolume_);
}

// ************************************************************************* //
