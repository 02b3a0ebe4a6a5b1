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

#include "restartState.H"
#include "Time.H"
#include "primitiveEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restartState::restartState(const Time& runTime)
:
    IOdictionary
    (
        IOobject
        (
            "waterState",
            runTime.timeName(),
            "uniform",
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartState::set
(
    dictionary& dict,
    const word& key,
    const scalar value
)
{
    // As a token: a value would be printed and read with writePrecision
    dict.set(new primitiveEntry(key, token(value)));
}


bool Foam::restartState::writeData(Ostream& os) const
{
    const int allDigits = 17;
    const int precision = os.precision(allDigits);

    dictionary::write(os, false);
    os.precision(precision);

    return os.good();
}

// ************************************************************************* //
