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

#include "wholeCase.H"
#include "argList.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::isWholeCase(const argList& args)
{
    if (!UPstream::parRun())
    {
        return false;
    }

    label nFolders = 0;
    while (isDir(args.globalPath()/("processor" + Foam::name(nFolders))))
    {
        ++nFolders;
    }

    if (nFolders > 0 && nFolders != UPstream::nProcs())
    {
        FatalErrorInFunction
            << "The case " << args.globalPath() << " is decomposed for "
            << nFolders << " processors, but there are "
            << UPstream::nProcs() << nl
            << "    Start as many, decompose anew, or remove the processor"
            << " folders to share a slide of the whole case"
            << exit(FatalError);
    }

    return nFolders == 0;
}

// ************************************************************************* //
