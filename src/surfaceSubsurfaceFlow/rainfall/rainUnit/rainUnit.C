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

#include "rainUnit.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rainRate
(
    const dictionary& dict,
    const scalar amount,
    const scalar interval
)
{
    const scalar millimetre = 1e-3;
    const string unit(dict.get<string>("unit"));

    if (unit == "m/s")
    {
        return amount;
    }
    if (unit == "mm/h")
    {
        return amount*millimetre/3600;
    }
    if (unit == "mm/d")
    {
        return amount*millimetre/86400;
    }
    if (unit == "mm")
    {
        return amount*millimetre/interval;
    }

    FatalIOErrorInFunction(dict)
        << "Entry 'unit' is \"" << unit.c_str() << "\"; it must be one of"
        << " \"m/s\", \"mm/h\", \"mm/d\" and \"mm\"" << exit(FatalIOError);

    return 0;
}

// ************************************************************************* //
