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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::overlandFlowModel::overlandFlowModel(const dictionary& dict)
:
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


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::overlandFlowModel::manningFlux
(
    const scalar length,
    const scalar manning,
    const scalar depth,
    const scalar normal,
    const scalar tangential,
    scalar& dNormal,
    scalar& dDepth
) const
{
    dNormal = 0;
    dDepth = 0;

    if (depth <= 0)
    {
        return 0;
    }

    const scalar gradientSqr =
        sqr(normal) + sqr(tangential) + sqr(slopeFloor_);

    // -W h^(5/3) / (n |G|^(1/2)), |G|^(1/2) = (|G|^2)^(1/4)
    const scalar depth23 = sqr(cbrt(depth));
    const scalar conveyance =
        -length*depth23*depth/(manning*sqrt(sqrt(gradientSqr)));

    dNormal = conveyance*(1 - 0.5*sqr(normal)/gradientSqr);
    dDepth = (5.0/3.0)*conveyance*normal/depth;

    return conveyance*normal;
}

// ************************************************************************* //
