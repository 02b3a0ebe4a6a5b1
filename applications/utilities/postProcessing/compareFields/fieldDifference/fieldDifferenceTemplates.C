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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::fieldDifference::fieldDifference
(
    const Field<Type>& values,
    const Field<Type>& reference,
    const scalarField& weights,
    const vectorField& centres,
    const word& element
)
{
    scalarField difference(values.size());
    label worst = -1;

    forAll(difference, i)
    {
        bool finite = true;
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            finite = finite
                && std::isfinite(component(values[i], d))
                && std::isfinite(component(reference[i], d));
        }

        difference[i] = finite ? mag(values[i] - reference[i]) : GREAT;

        if (worst < 0 || difference[i] > difference[worst])
        {
            worst = i;
        }
    }

    setMeasures(difference, mag(reference)(), weights);

    // Each rank describes its own worst place, the master picks one
    scalarList largest(Pstream::nProcs(), scalar(-1));
    List<string> places(Pstream::nProcs());

    if (worst >= 0)
    {
        OStringStream place;
        place.precision(max(IOstream::defaultPrecision(), 10u));
        place
            << element << ' ' << worst;

        if (Pstream::parRun())
        {
            place << " of rank " << Pstream::myProcNo();
        }

        place
            << " at " << centres[worst] << ": " << values[worst]
            << ", reference " << reference[worst];

        largest[Pstream::myProcNo()] = difference[worst];
        places[Pstream::myProcNo()] = place.str();
    }

    Pstream::gatherList(largest);
    Pstream::gatherList(places);

    worst_ = places[findMax(largest)];
}


// ************************************************************************* //
