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
#include "OSspecific.H"
#include "readChecked.H"
#include "slidePoints.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(slideWall, 0);
    defineRunTimeSelectionTable(slideWall, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::slideWall::checkWallKeys(const wordList& own) const
{
    wordList keys(own);
    keys.append
    (
        wordList({"type", "condition", "friction", "adhesion", "force"})
    );
    checkKeys(dict_, keys);
}


mpm::WallSettings Foam::slideWall::settings
(
    const word& engineType,
    const bool writesForce
) const
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
    wall.adhesion = readCheckedOrDefault
    (
        dict_,
        "adhesion",
        wall.adhesion,
        [&](const scalar x)
        {
            return x == 0 || (x > 0 && wall.condition == "coulomb");
        },
        ">= 0 Pa, and 0 unless the condition is coulomb"
    );
    wall.recordsLoad = dict_.getOrDefault("force", writesForce);

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


Foam::fileName Foam::slideWall::caseFile(const word& key) const
{
    fileName file(dict_.get<fileName>(key));
    file.expand();

    return
        file.isAbsolute() ? file : fileName(getEnv("FOAM_CASE"))/file;
}


void Foam::slideWall::refusePointsInside
(
    const slidePoints& points,
    const std::function<double(const mpm::Point3&)>& distance
) const
{
    // What a point may lie in a body of the volume around it
    const scalar depth = 0.25*points.spacing();

    label nInside = 0;
    label first = -1;
    forAll(points.position(), i)
    {
        if (distance(toMpm(points.position()[i])) < -depth)
        {
            first = nInside++ ? first : i;
        }
    }

    if (nInside)
    {
        FatalIOErrorInFunction(dict_)
            << nInside << " of the " << points.size() << " points lie inside"
            << " of the wall " << name_ << ", for instance point " << first
            << " at " << points.position()[first]
            << ": a body must stand clear of the soil at the start"
            << exit(FatalIOError);
    }
}


void Foam::slideWall::checkThickness
(
    const slidePoints& points,
    const vector& extent
) const
{
    const scalar least = 2*points.cellSize();
    const scalar leastOfAll = 0.01*points.cellSize();

    for (direction cmpt = 0; cmpt < points.frame().dimension(); ++cmpt)
    {
        if (extent[cmpt] < leastOfAll)
        {
            FatalIOErrorInFunction(dict_)
                << "The wall " << name_ << " is " << extent[cmpt]
                << " m thick, which the grid with its cellSize of "
                << points.cellSize() << " m can't see"
                << exit(FatalIOError);
        }

        if (extent[cmpt] < least)
        {
            IOWarningInFunction(dict_)
                << "The wall " << name_ << " is " << extent[cmpt]
                << " m thick. Soil on its two sides shares nodes of the grid"
                << " and may stick together unless it is at least two cells, "
                << least << " m" << endl;
            return;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slideWall::slideWall(const word& name, const dictionary& dict)
:
    name_(name),
    dict_(dict)
{}

// ************************************************************************* //
