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

#include "waterSource.H"
#include "coupledMatrix.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(waterSource, 0);
    defineRunTimeSelectionTable(waterSource, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::waterSource::share Foam::waterSource::supply
(
    const soilTable& table,
    const soilTable::state& s
)
{
    const scalar left = (s.tau - table.dryEnd())/last;

    return
        left >= 1 ? share{1, 0}
      : left > 0 ? share{left, 1/last}
      : share{0, 0};
}


void Foam::waterSource::addInflow
(
    coupledMatrix& matrix,
    const label unknown,
    const scalar volume,
    const scalar derivative
)
{
    (volume > 0 ? inflow_ : outflow_) += mag(volume);

    matrix.add(unknown, -volume, -derivative);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSource::waterSource
(
    const dictionary& dict,
    const groundSurface& ground,
    const subsurfaceFlow& soil
)
:
    inflow_(0),
    outflow_(0),
    name_(dict.dictName()),
    mesh_(soil.psi().mesh()),
    ground_(ground),
    soil_(soil)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::waterSource::assemble(coupledMatrix& matrix, const label start)
{
    inflow_ = 0;
    outflow_ = 0;

    add(matrix, start);
}

// ************************************************************************* //
