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

Application
    Test-checkedInput

Description
    Entries, csv tables and rasters: what they mean and what is refused.

\*---------------------------------------------------------------------------*/

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "error.H"

#include <cfenv>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    return doctest::Context(argc, argv).run();
}

// ************************************************************************* //
