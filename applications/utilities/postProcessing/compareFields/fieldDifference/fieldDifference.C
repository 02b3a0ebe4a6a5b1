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

#include "fieldDifference.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::fieldDifference::measure>
Foam::fieldDifference::measureNames
({
    { measure::L1, "L1" },
    { measure::L2, "L2" },
    { measure::Linf, "Linf" },
    { measure::relativeL1, "relativeL1" },
    { measure::relativeL2, "relativeL2" },
    { measure::relativeLinf, "relativeLinf" }
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::FixedList<Foam::scalar, 3> Foam::fieldDifference::norms
(
    const scalarField& magnitudes,
    const scalarField& weights
)
{
    // A difference of GREAT must not overflow when it is squared
    const scalar largest = gMax(magnitudes);
    const scalar unit = max(largest, VSMALL);
    const scalar total = gSum(weights);

    return FixedList<scalar, 3>
    ({
        gSum(weights*magnitudes)/total,
        unit*Foam::sqrt(gSum(weights*sqr(magnitudes/unit))/total),
        largest
    });
}


void Foam::fieldDifference::setMeasures
(
    const scalarField& difference,
    const scalarField& reference,
    const scalarField& weights
)
{
    const FixedList<scalar, 3> differences(norms(difference, weights));
    const FixedList<scalar, 3> references(norms(reference, weights));

    for (label i = 0; i < 3; ++i)
    {
        values_[i] = differences[i];
        values_[3 + i] = differences[i]/max(references[i], VSMALL);
    }
}


// ************************************************************************* //
