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

#include "evaporation.H"
#include "readChecked.H"
#include "standardGravity.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterSources
{
    defineTypeNameAndDebug(evaporation, 0);
    addToRunTimeSelectionTable(waterSource, evaporation, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::waterSource::share Foam::waterSources::evaporation::yielded
(
    const soilTable::state& s
) const
{
    if (s.head >= 0)
    {
        return {1, 0};
    }

    // (e^x - RH)/(1 - RH) without cancellation near 1
    const scalar x = vapour_*s.head;
    const scalar value = 1 + std::expm1(x)/(1 - humidity_);

    if (value <= 0)
    {
        return {0, 0};
    }

    return {value, vapour_*std::exp(x)/(1 - humidity_)*s.dHead};
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::waterSources::evaporation::add
(
    coupledMatrix& matrix,
    const label start
)
{
    forAll(ground_.faces(), i)
    {
        const label facei = ground_.faces()[i];
        const soilTable::state& s = soil_.boundaryState(facei);
        const scalar demand = demand_*ground_.planArea()[i];

        const share taken =
            yielded(s)*supply(soil_.table(mesh_.faceOwner()[facei]), s);

        addInflow
        (
            matrix,
            start + i,
            -demand*taken.value,
            -demand*taken.derivative
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSources::evaporation::evaporation
(
    const dictionary& dict,
    const groundSurface& ground,
    const subsurfaceFlow& soil
)
:
    waterSource(dict, ground, soil),
    rate_("rate", dict),
    humidity_
    (
        readCheckedOrDefault
        (
            dict,
            "relativeHumidity",
            0.5,
            [](const scalar x) { return x > 0 && x < 1; },
            "0 < relativeHumidity < 1"
        )
    ),
    vapour_(0),
    demand_(0)
{
    checkKeys
    (
        dict,
        {"type", "rate", "relativeHumidity", "temperature"},
        {"rate", "rateCoeffs"}
    );

    // Molar mass of water [kg/mol] and gas constant [J/(mol K)]
    const scalar M = 0.018015;
    const scalar R = 8.314463;

    vapour_ =
        M*standardGravity/R
       /readCheckedOrDefault
        (
            dict,
            "temperature",
            293.15,
            [](const scalar x) { return x > 0; },
            "temperature > 0 [K]"
        );

    if (returnReduce(ground.size(), sumOp<label>()) == 0)
    {
        FatalIOErrorInFunction(dict)
            << "There is no ground from which water could evaporate: neither"
            << " constant/overlandProperties nor a patch of psi with the type"
            << " surfaceRain" << nl << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterSources::evaporation::beginStep
(
    const scalar t1,
    const scalar t2,
    const scalar stretch
)
{
    demand_ = stretch*rate_.amount(t1, t2);
}


Foam::scalar Foam::waterSources::evaporation::driestHead() const
{
    return std::log(humidity_)/vapour_;
}


void Foam::waterSources::evaporation::writeInfo(Ostream& os) const
{
    os  << "    " << name_ << ": evaporation from " << gSum(ground_.planArea())
        << " m2, as dry as the air at a surface head of "
        << driestHead() << " m" << nl;
}

// ************************************************************************* //
