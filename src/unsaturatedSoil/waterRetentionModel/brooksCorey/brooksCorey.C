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

#include "brooksCorey.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterRetentionModels
{
    defineTypeNameAndDebug(brooksCorey, 0);
    addToRunTimeSelectionTable(waterRetentionModel, brooksCorey, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModels::brooksCorey::brooksCorey(const dictionary& dict)
:
    waterRetentionModel(dict),
    airEntry_
    (
        readChecked
        (
            dict,
            "airEntryHead",
            [](const scalar x) { return x > 0; },
            "airEntryHead > 0 [m of suction]"
        )
    ),
    lambda_
    (
        readChecked
        (
            dict,
            "lambda",
            [](const scalar x) { return x > 0; },
            "lambda > 0"
        )
    )
{
    checkKeys(dict, {"type", "thetaS", "thetaR", "airEntryHead", "lambda"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::brooksCorey::logSe
(
    const scalar h
) const
{
    return h < -airEntry_ ? -lambda_*std::log(-h/airEntry_) : 0;
}


Foam::scalar Foam::waterRetentionModels::brooksCorey::dlogSedh
(
    const scalar h
) const
{
    return h < -airEntry_ ? -lambda_/h : 0;
}


Foam::scalar Foam::waterRetentionModels::brooksCorey::SeIntegral
(
    const scalar h
) const
{
    if (h >= -airEntry_)
    {
        return h;
    }

    // hb + integral of (hb/s)^lambda from hb to s, also for lambda near 1
    const scalar logRatio = std::log(-h/airEntry_);
    const scalar z = (1 - lambda_)*logRatio;
    const scalar mean = mag(z) > 0 ? std::expm1(z)/z : 1;

    return -airEntry_*(1 + logRatio*mean);
}


Foam::scalar Foam::waterRetentionModels::brooksCorey::logPoreIntegral
(
    const label power,
    const scalar h
) const
{
    return dryPoreExponent(power)*logSe(h);
}


Foam::scalar Foam::waterRetentionModels::brooksCorey::dlogPoreIntegraldh
(
    const label power,
    const scalar h
) const
{
    return dryPoreExponent(power)*dlogSedh(h);
}

// ************************************************************************* //
