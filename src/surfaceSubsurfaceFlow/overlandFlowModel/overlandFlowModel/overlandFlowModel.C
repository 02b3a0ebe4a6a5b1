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

#include "overlandFlowModel.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(overlandFlowModel, 0);
    defineRunTimeSelectionTable(overlandFlowModel, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::overlandFlowModel::flux Foam::overlandFlowModel::normalGradient
(
    const planGeometry::edgePlan& edge,
    const side& first,
    const side& second,
    const vector2D& gradient
) const
{
    const scalar follows = followsWater();

    flux normal;
    normal.value =
        (
            second.elevation + follows*second.depth
          - first.elevation - follows*first.depth
        )*edge.inverseDistance
      + (edge.rest & gradient);
    normal.dFirst = -follows*edge.inverseDistance;
    normal.dSecond = follows*edge.inverseDistance;

    // No steeper than down to the bed at the edge
    const bool forward = (normal.value <= 0);
    const scalar fall = forward ? edge.fallFirst : edge.fallSecond;
    const scalar share = forward ? edge.position : 1 - edge.position;
    const scalar depth = forward ? first.depth : second.depth;
    const scalar steepest = fall + depth*edge.inverseDistance/share;

    if (fall > 0 && mag(normal.value) > steepest)
    {
        const scalar sign = forward ? -1 : 1;
        const scalar derivative = sign*edge.inverseDistance/share;

        normal.value = sign*steepest;
        normal.dFirst = forward ? derivative : 0;
        normal.dSecond = forward ? 0 : derivative;
    }

    return normal;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::overlandFlowModel::overlandFlowModel(const dictionary& dict)
:
    friction_(frictionModel::New(dict)),
    slopeFloor_
    (
        readCheckedOrDefault
        (
            dict,
            "slopeFloor",
            1e-4,
            [](const scalar s) { return s > 0 && s <= 1; },
            "0 < slopeFloor <= 1"
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::overlandFlowModel::frictionSlopeSqr
(
    const side&,
    const scalar normal,
    const scalar tangential,
    scalar& dNormal
) const
{
    dNormal = 2*normal;

    return sqr(normal) + sqr(tangential);
}


Foam::overlandFlowModel::flux Foam::overlandFlowModel::edgeFlux
(
    const planGeometry::edgePlan& edge,
    const side& first,
    const side& second,
    const surroundings& around
) const
{
    const flux normal
    (
        normalGradient(edge, first, second, around.gradient)
    );
    const scalar tangential =
        edge.normal.x()*around.gradient.y()
      - edge.normal.y()*around.gradient.x();

    const bool forward = (normal.value <= 0);
    const side& upwind = forward ? first : second;
    const side& downwind = forward ? second : first;

    // The depth that passes
    const bool uphill =
        followsWater() && upwind.elevation < downwind.elevation;
    const scalar ratio =
        uphill ? 1 : forward ? around.ratioFirst : around.ratioSecond;
    const scalar depth =
        uphill
      ? upwind.elevation + upwind.depth - downwind.elevation
      : ratio*upwind.depth;

    flux result;

    if (depth <= 0)
    {
        return result;
    }

    scalar dDepth, dSlopeSqr;
    const scalar discharge =
        friction_->discharge(depth, upwind.conveyance, dDepth);
    const scalar slopeSqr =
        frictionSlopeSqr(upwind, normal.value, tangential, dSlopeSqr)
      + sqr(slopeFloor_);

    // |S|^(1/2) = (|S|^2)^(1/4)
    const scalar root = sqrt(sqrt(slopeSqr));

    result.value = -edge.length*discharge*normal.value/root;

    const scalar dNormal =
        -edge.length*discharge
       *(1 - 0.25*normal.value*dSlopeSqr/slopeSqr)/root;

    result.dFirst = dNormal*normal.dFirst;
    result.dSecond = dNormal*normal.dSecond;
    (forward ? result.dFirst : result.dSecond) +=
        -edge.length*ratio*dDepth*normal.value/root;

    return result;
}

// ************************************************************************* //
