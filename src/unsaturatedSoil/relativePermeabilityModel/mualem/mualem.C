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

#include "mualem.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace relativePermeabilityModels
{
    defineTypeNameAndDebug(mualem, 0);
    addToRunTimeSelectionTable(relativePermeabilityModel, mualem, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::relativePermeabilityModels::mualem::logOneMinusExp
(
    const scalar a
)
{
    // Where exp(-a) is the smaller part log1p keeps its digits, else expm1
    return
        a > 0.7 ? std::log1p(-std::exp(-a)) : std::log(-std::expm1(-a));
}


const Foam::waterRetentionModels::vanGenuchten&
Foam::relativePermeabilityModels::mualem::checkRetention
(
    const dictionary& dict,
    const waterRetentionModel& retention
)
{
    if (!isA<waterRetentionModels::vanGenuchten>(retention))
    {
        FatalIOErrorInFunction(dict)
            << "relativePermeability type " << typeName
            << " needs the retention type "
            << waterRetentionModels::vanGenuchten::typeName
            << ", but the retention type is " << retention.type() << nl
            << exit(FatalIOError);
    }

    return refCast<const waterRetentionModels::vanGenuchten>(retention);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::relativePermeabilityModels::mualem::mualem
(
    const dictionary& dict,
    const waterRetentionModel& retention
)
:
    relativePermeabilityModel(),
    retention_(checkRetention(dict, retention)),
    l_
    (
        readCheckedOrDefault
        (
            dict,
            "l",
            0.5,
            [](const scalar) { return true; },
            "any finite number"
        )
    ),
    logSaturatedPores_
    (
        retention_.saturationHead() < 0
      ? logOneMinusExp(retention_.poreExponent(retention_.saturationHead()))
      : 0
    )
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::relativePermeabilityModels::mualem::logKr
(
    const scalar h
) const
{
    if (h >= retention_.saturationHead())
    {
        return 0;
    }

    return
        l_*retention_.logSaturation(h)
      + 2*(logOneMinusExp(retention_.poreExponent(h)) - logSaturatedPores_);
}


Foam::scalar Foam::relativePermeabilityModels::mualem::dkrdh
(
    const scalar h
) const
{
    if (h >= retention_.saturationHead())
    {
        return 0;
    }

    scalar saturationSlope, poreSlope;
    retention_.logSlopes(h, saturationSlope, poreSlope);

    // d ln(1 - e^-a)/da = e^-a/(1 - e^-a)
    const scalar a = retention_.poreExponent(h);

    return
        kr(h)
       *(
            l_*saturationSlope
          + 2*poreSlope*std::exp(-a)/(-std::expm1(-a))
        );
}

// ************************************************************************* //
