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

#include "tabulatedPermeability.H"
#include "readChecked.H"
#include "tabulatedRetention.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace relativePermeabilityModels
{
    defineTypeNameAndDebug(tabulatedPermeability, 0);
    addToRunTimeSelectionTable
    (
        relativePermeabilityModel,
        tabulatedPermeability,
        dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::suctionTable
Foam::relativePermeabilityModels::tabulatedPermeability::readTable
(
    const dictionary& dict,
    const waterRetentionModel& retention
)
{
    using retentionTable = waterRetentionModels::tabulatedRetention;

    const bool own = suctionTable::given(dict);

    if (!own && !isA<retentionTable>(retention))
    {
        FatalIOErrorInFunction(dict)
            << "relativePermeability type " << typeName << " needs a table"
            << " ('values' or 'file'), or the retention type " << typeName
            << " with a column kr; the retention type is " << retention.type()
            << nl << exit(FatalIOError);
    }

    const suctionTable table
    (
        own
      ? suctionTable(dict)
      : refCast<const retentionTable>(retention).table()
    );

    if (table.kr().empty())
    {
        FatalIOErrorInFunction(dict)
            << "The table of " << dict.name() << " has no column kr" << nl
            << exit(FatalIOError);
    }

    if (table.suction().first() < -retention.saturationHead())
    {
        FatalIOErrorInFunction(dict)
            << "The table of " << dict.name() << " begins at "
            << table.suction().first() << " m of suction, where the retention"
            << " curve is still saturated: it leaves saturation at "
            << -retention.saturationHead() << " m" << nl
            << exit(FatalIOError);
    }

    return table;
}


Foam::scalarList
Foam::relativePermeabilityModels::tabulatedPermeability::logarithms() const
{
    scalarList result(table_.kr());

    for (scalar& value : result)
    {
        value = std::log(value);
    }

    return result;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::relativePermeabilityModels::tabulatedPermeability::tabulatedPermeability
(
    const dictionary& dict,
    const waterRetentionModel& retention
)
:
    relativePermeabilityModel(),
    table_(readTable(dict, retention)),
    logKr_(table_.suction(), logarithms(), table_.cubic())
{
    checkKeys
    (
        dict,
        {"type", "values", "file", "separator", "headUnit", "interpolation"}
    );
}

// ************************************************************************* //
