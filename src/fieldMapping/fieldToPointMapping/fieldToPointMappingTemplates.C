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

#include "fieldToPointMapping.H"
#include "Pstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::fieldToPointMapping::gather
(
    const UList<Type>& localValues,
    Field<Type>& values
) const
{
    List<labelList> allPoints(Pstream::nProcs());
    List<List<Type>> allValues(Pstream::nProcs());

    allPoints[Pstream::myProcNo()] = localPoints_;
    allValues[Pstream::myProcNo()] = localValues;

    Pstream::gatherList(allPoints);
    Pstream::gatherList(allValues);

    if (Pstream::master() || !Pstream::parRun())
    {
        forAll(allPoints, proci)
        {
            forAll(allPoints[proci], i)
            {
                values[allPoints[proci][i]] = allValues[proci][i];
            }
        }
    }

    Pstream::scatter(values);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::fieldToPointMapping::map
(
    const UList<Type>& cellValues,
    const Type& outsideValue
) const
{
    auto tvalues = tmp<Field<Type>>::New(nPoints_, outsideValue);

    gather<Type>
    (
        reconstruction_->values(cellValues, cellIndex_, displacement_)(),
        tvalues.ref()
    );

    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::fieldToPointMapping::map
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const Type& outsideValue
) const
{
    return map<Type>
    (
        static_cast<const UList<Type>&>(field.primitiveField()),
        outsideValue
    );
}

// ************************************************************************* //
