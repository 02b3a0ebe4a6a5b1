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

#include "well.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterSources
{
    defineTypeNameAndDebug(well, 0);
    addToRunTimeSelectionTable(waterSource, well, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::waterSources::well::add(coupledMatrix& matrix, const label)
{
    forAll(cells_, i)
    {
        const label celli = cells_[i];
        const scalar volume = volume_*part_[i];

        const share met =
            volume < 0
          ? supply(soil_.table(celli), soil_.cellState(celli))
          : share{1, 0};

        addInflow(matrix, celli, volume*met.value, volume*met.derivative);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSources::well::well
(
    const dictionary& dict,
    const groundSurface& ground,
    const subsurfaceFlow& soil
)
:
    waterSource(dict, ground, soil),
    rate_("rate", dict, -GREAT),
    cells_(),
    part_(),
    volume_(0)
{
    checkKeys(dict, {"type", "rate", "cellZone"}, {"rate", "rateCoeffs"});

    const word zoneName(dict.get<word>("cellZone"));
    const label zonei = mesh_.cellZones().findZoneID(zoneName);

    if (zonei < 0)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh has no cellZone '" << zoneName << "'" << nl
            << "    Valid names: " << mesh_.cellZones().names() << nl
            << exit(FatalIOError);
    }

    cells_ = mesh_.cellZones()[zonei];
    part_ = scalarField(mesh_.V(), cells_);

    const scalar V = gSum(part_);

    if (V <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The cellZone '" << zoneName << "' has no cell" << nl
            << exit(FatalIOError);
    }

    part_ /= V;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterSources::well::beginStep
(
    const scalar t1,
    const scalar t2,
    const scalar stretch
)
{
    volume_ = stretch*rate_.amount(t1, t2);
}


void Foam::waterSources::well::writeInfo(Ostream& os) const
{
    os  << "    " << name_ << ": well in "
        << returnReduce(cells_.size(), sumOp<label>()) << " cells" << nl;
}

// ************************************************************************* //
