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

#include "stepTable.H"
#include "Time.H"
#include "OSspecific.H"
#include "clock.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepTable::stepTable
(
    const Time& runTime,
    const word& name,
    const wordList& columns
)
:
    file_()
{
    if (!Pstream::master())
    {
        return;
    }

    const fileName directory
    (
        runTime.globalPath()/"postProcessing"/name/runTime.timeName()
    );

    if (!isDir(directory) && !mkDir(directory))
    {
        FatalErrorInFunction
            << "Cannot make the directory " << directory
            << " for " << name << ".dat" << exit(FatalError);
    }

    const fileName path(directory/(name + ".dat"));
    file_.reset(new OFstream(path));

    if (!file_->good())
    {
        FatalErrorInFunction
            << "Cannot write " << path << exit(FatalError);
    }

    const int digits = 15;
    file_->precision(digits);

    file_()
        << "# " << name << ", machine " << hostName() << ", begun "
        << clock::dateTime().c_str() << nl;

    forAll(columns, i)
    {
        file_() << (i ? "\t" : "") << columns[i].c_str();
    }
    file_() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepTable::write(const List<field>& row)
{
    if (!file_)
    {
        return;
    }

    const char* separator = "";
    for (const field& f : row)
    {
        file_() << separator;
        if (f.computed)
        {
            file_() << f.value;
        }
        separator = "\t";
    }
    file_() << endl;
}

// ************************************************************************* //
