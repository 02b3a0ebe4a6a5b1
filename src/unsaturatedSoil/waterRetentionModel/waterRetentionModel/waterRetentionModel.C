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

#include "waterRetentionModel.H"
#include "readChecked.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(waterRetentionModel, 0);
    defineRunTimeSelectionTable(waterRetentionModel, dictionary);
}

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModel::integrateSe
(
    const scalar from,
    const scalar to,
    const scalar exponent
) const
{
    // Eight-point Gauss nodes and weights on [-1, 1]
    static const scalar node[4] =
    {
        0.1834346424956498049394761, 0.5255324099163289858177390,
        0.7966664774136267395915539, 0.9602898564975362316835609
    };
    static const scalar weight[4] =
    {
        0.3626837833783619829651504, 0.3137066458778872873379622,
        0.2223810344533744705443560, 0.1012285362903762591525314
    };

    // Panels of a third of the distance to the nearest pole lose nothing
    const scalar range = std::log(to/from);
    const label nPanels = 1 + label(range*max(exponent, scalar(2)));
    const scalar half = 0.5*range/nPanels;

    scalar sum = 0;

    for (label panel = 0; panel < nPanels; ++panel)
    {
        const scalar centre = std::log(from) + (2*panel + 1)*half;

        for (label i = 0; i < 4; ++i)
        {
            for (const scalar side : {-1.0, 1.0})
            {
                const scalar s = std::exp(centre + side*node[i]*half);

                sum += weight[i]*half*s*Se(-s);
            }
        }
    }

    return sum;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModel::waterRetentionModel
(
    const scalar thetaS,
    const scalar thetaR
)
:
    thetaS_(thetaS),
    thetaR_(thetaR)
{}


Foam::waterRetentionModel::waterRetentionModel(const dictionary& dict)
:
    thetaS_
    (
        readChecked
        (
            dict,
            "thetaS",
            [](const scalar x) { return x > 0 && x <= 1; },
            "0 < thetaS <= 1"
        )
    ),
    thetaR_
    (
        readChecked
        (
            dict,
            "thetaR",
            [this](const scalar x) { return x >= 0 && x < thetaS_; },
            "0 <= thetaR < thetaS"
        )
    )
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModel::Se(const scalar h) const
{
    return std::exp(logSe(h));
}


Foam::scalar Foam::waterRetentionModel::desaturation(const scalar h) const
{
    return -std::expm1(logSe(h));
}


Foam::scalar Foam::waterRetentionModel::logPoreIntegral
(
    const label,
    const scalar
) const
{
    NotImplemented;
    return 0;
}


Foam::scalar Foam::waterRetentionModel::dlogPoreIntegraldh
(
    const label,
    const scalar
) const
{
    NotImplemented;
    return 0;
}


Foam::scalar Foam::waterRetentionModel::dryPoreExponent(const label) const
{
    NotImplemented;
    return 0;
}

// ************************************************************************* //
