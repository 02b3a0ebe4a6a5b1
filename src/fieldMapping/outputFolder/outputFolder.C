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

#include "outputFolder.H"
#include "OSspecific.H"
#include "error.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::makeOutputFolder(const fileName& folder)
{
    if (!isDir(folder))
    {
        mkDir(folder);
    }

    if (!isDir(folder))
    {
        FatalErrorInFunction
            << "Can't make the folder " << folder
            << (exists(folder) ? ": a file has this name" : "")
            << exit(FatalError);
    }
}


void Foam::replaceByComplete(const fileName& complete, const fileName& name)
{
    // A folder can't be renamed onto one that is not empty
    if (isDir(name))
    {
        rmDir(name);
    }

    if (!mv(complete, name))
    {
        FatalErrorInFunction
            << "Can't rename " << complete << " to " << name
            << exit(FatalError);
    }
}

// ************************************************************************* //
