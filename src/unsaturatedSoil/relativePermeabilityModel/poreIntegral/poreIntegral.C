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

#include "poreIntegral.H"
#include "readChecked.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::relativePermeabilityModels::poreIntegral::poreIntegral
(
    const dictionary& dict,
    const waterRetentionModel& retention,
    const word& type,
    const label power,
    const scalar exponent,
    const scalar defaultL
)
:
    relativePermeabilityModel(),
    retention_(retention),
    power_(power),
    exponent_(exponent),
    l_(defaultL)
{
    checkKeys(dict, {"type", "l"});

    if (!retention.hasPoreIntegral(power))
    {
        FatalIOErrorInFunction(dict)
            << "relativePermeability type " << type
            << " needs a retention type whose integral over the pore sizes"
            << " is known: " << (power == 1 ? "vanGenuchten or " : "")
            << "brooksCorey, but the retention type is " << retention.type()
            << nl << exit(FatalIOError);
    }

    const scalar least = -exponent_*retention.dryPoreExponent(power);

    l_ = readCheckedOrDefault
    (
        dict,
        "l",
        defaultL,
        [least](const scalar x) { return x > least; },
        "l > " + name(least) + ", below which kr would rise in dry soil"
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::relativePermeabilityModels::poreIntegral::logKr
(
    const scalar h
) const
{
    return
        l_*retention_.logSe(h)
      + exponent_*retention_.logPoreIntegral(power_, h);
}


Foam::scalar Foam::relativePermeabilityModels::poreIntegral::dkrdh
(
    const scalar h
) const
{
    return
        h < retention_.saturationHead()
      ? kr(h)
       *(
            l_*retention_.dlogSedh(h)
          + exponent_*retention_.dlogPoreIntegraldh(power_, h)
        )
      : 0;
}


void Foam::relativePermeabilityModels::poreIntegral::writeInfo
(
    Ostream& os
) const
{
    os  << type() << " with l " << l_;
}

// ************************************************************************* //
