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

#include "slideWall.H"
#include "mpmChecked.H"
#include "readChecked.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(slideWall, 0);
    defineRunTimeSelectionTable(slideWall, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

mpm::WallSettings Foam::slideWall::settings(const word& engineType) const
{
    mpm::WallSettings wall;

    wall.name = name_;
    wall.type = engineType;
    wall.condition = dict_.get<word>("condition");
    wall.friction = readCheckedOrDefault
    (
        dict_,
        "friction",
        wall.friction,
        [](const scalar x){ return x >= 0; },
        ">= 0, the tangent of an angle"
    );

    if (wall.condition == "coulomb" && !dict_.found("friction"))
    {
        FatalIOErrorInFunction(dict_)
            << "condition coulomb needs friction, the tangent of the angle of"
            << " friction between wall and soil"
            << exit(FatalIOError);
    }

    return wall;
}


void Foam::slideWall::requireMesh(const fvMesh* meshPtr) const
{
    if (!meshPtr)
    {
        FatalIOErrorInFunction(dict_)
            << "A wall of type " << type() << " is taken from a mesh, but this"
            << " slide has none: its points come from a file"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWall::slideWall(const word& name, const dictionary& dict)
:
    name_(name),
    dict_(dict)
{}

// ************************************************************************* //
