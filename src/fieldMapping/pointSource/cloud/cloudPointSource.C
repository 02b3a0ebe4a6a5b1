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

#include "cloudPointSource.H"
#include "addToRunTimeSelectionTable.H"
#include "IFstream.H"
#include "polyMesh.H"
#include "readChecked.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace pointSources
{
    defineTypeNameAndDebug(cloudPointSource, 0);
    addToRunTimeSelectionTable(pointSource, cloudPointSource, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointSources::cloudPointSource::cloudPointSource
(
    const dictionary& dict
)
:
    dict_(checkKeys(dict, {"type", "points", "file"}))
{
    if (dict_.found("points") == dict_.found("file"))
    {
        FatalIOErrorInFunction(dict_)
            << "A cloud needs either points or file, but "
            << (dict_.found("points") ? "both are" : "none is") << " given"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::pointSources::cloudPointSource::points
(
    const polyMesh& mesh
) const
{
    if (dict_.found("points"))
    {
        return dict_.get<pointField>("points");
    }

    fileName file(dict_.get<fileName>("file"));
    file.expand();

    if (!file.isAbsolute())
    {
        file = mesh.time().globalPath()/file;
    }

    IFstream is(file);

    if (!is.good())
    {
        FatalIOErrorInFunction(dict_)
            << "file: can't read " << file
            << exit(FatalIOError);
    }

    return pointField(is);
}

// ************************************************************************* //
