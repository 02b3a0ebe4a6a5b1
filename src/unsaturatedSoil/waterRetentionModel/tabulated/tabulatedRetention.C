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

#include "tabulatedRetention.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterRetentionModels
{
    defineTypeNameAndDebug(tabulatedRetention, 0);
    addToRunTimeSelectionTable
    (
        waterRetentionModel,
        tabulatedRetention,
        dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::suctionTable
Foam::waterRetentionModels::tabulatedRetention::readTable
(
    const dictionary& dict
)
{
    const suctionTable table(dict);

    if (table.theta().empty())
    {
        FatalIOErrorInFunction(dict)
            << "The table of " << dict.name() << " has no column theta" << nl
            << exit(FatalIOError);
    }

    return table;
}


Foam::scalar Foam::waterRetentionModels::tabulatedRetention::readThetaR
(
    const dictionary& dict,
    const suctionTable& table
)
{
    const scalar least = table.theta().last();

    return readCheckedOrDefault
    (
        dict,
        "thetaR",
        0,
        [least](const scalar x) { return x >= 0 && x < least; },
        "0 <= thetaR < " + Foam::name(least) + ", the last theta of the table"
    );
}


Foam::scalarList
Foam::waterRetentionModels::tabulatedRetention::desaturations() const
{
    scalarList result(table_.theta());

    for (scalar& value : result)
    {
        value = (thetaS() - value)/(thetaS() - thetaR());
    }

    return result;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterRetentionModels::tabulatedRetention::tabulatedRetention
(
    const dictionary& dict,
    const suctionTable& table
)
:
    waterRetentionModel(table.theta().first(), readThetaR(dict, table)),
    table_(table),
    desaturation_(table_.suction(), desaturations(), table_.cubic())
{}


Foam::waterRetentionModels::tabulatedRetention::tabulatedRetention
(
    const dictionary& dict
)
:
    tabulatedRetention(dict, readTable(dict))
{
    checkKeys
    (
        dict,
        {
            "type", "thetaR", "values", "file", "separator", "headUnit",
            "interpolation"
        }
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::waterRetentionModels::tabulatedRetention::logSe
(
    const scalar h
) const
{
    return std::log1p(-desaturation_.value(-h));
}


Foam::scalar Foam::waterRetentionModels::tabulatedRetention::dlogSedh
(
    const scalar h
) const
{
    return desaturation_.slope(-h)/Se(h);
}


Foam::scalar Foam::waterRetentionModels::tabulatedRetention::SeIntegral
(
    const scalar h
) const
{
    return h >= saturationHead() ? h : h + desaturation_.integral(-h);
}

// ************************************************************************* //
