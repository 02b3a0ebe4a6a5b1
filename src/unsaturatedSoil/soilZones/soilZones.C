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

#include "soilZones.H"
#include "polyMesh.H"
#include "Time.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Number of cells over all processors and the centre of one of them
    Foam::label countCells
    (
        const Foam::polyMesh& mesh,
        const Foam::labelList& cells,
        Foam::point& example
    )
    {
        using namespace Foam;

        const label noProc = Pstream::nProcs();
        const label first =
            returnReduce
            (
                cells.empty() ? noProc : Pstream::myProcNo(),
                minOp<label>()
            );

        example = Zero;

        if (first == Pstream::myProcNo())
        {
            example = mesh.cellCentres()[cells.first()];
        }

        reduce(example, sumOp<vector>());

        return returnReduce(cells.size(), sumOp<label>());
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::soilZones::readNames() const
{
    const dictionary& soils = properties_.subDict("soils");
    const wordList names(soils.toc());

    if (names.empty())
    {
        FatalIOErrorInFunction(soils)
            << "No soil in " << soils.name()
            << ": name one sub-dictionary a soil" << nl
            << exit(FatalIOError);
    }

    for (const word& name : names)
    {
        if (!soils.isDict(name))
        {
            FatalIOErrorInFunction(soils)
                << "Entry '" << name << "' of " << soils.name()
                << " is not a dictionary. Valid entries: "
                << "one sub-dictionary a soil, named like its cellZone" << nl
                << exit(FatalIOError);
        }
    }

    return names;
}


void Foam::soilZones::mapCells(const polyMesh& mesh)
{
    const wordList zoneNames(mesh.cellZones().names());
    const dictionary& soils = properties_.subDict("soils");

    if (names_.size() == 1 && zoneNames.empty())
    {
        cellSoil_ = 0;
        return;
    }

    DynamicList<label> twice;

    forAll(names_, soili)
    {
        const label zonei = mesh.cellZones().findZoneID(names_[soili]);

        if (zonei < 0)
        {
            FatalIOErrorInFunction(soils)
                << "The mesh has no cellZone '" << names_[soili]
                << "' for the soil of that name in " << soils.name() << nl
                << "    Valid names, the mesh's cellZones: " << zoneNames << nl
                << exit(FatalIOError);
        }

        for (const label celli : mesh.cellZones()[zonei])
        {
            if (cellSoil_[celli] != -1)
            {
                twice.append(celli);
            }

            cellSoil_[celli] = soili;
        }
    }

    DynamicList<label> unassigned;

    forAll(cellSoil_, celli)
    {
        if (cellSoil_[celli] == -1)
        {
            unassigned.append(celli);
        }
    }

    checkCells(mesh, unassigned, twice);
}


void Foam::soilZones::checkCells
(
    const polyMesh& mesh,
    const labelList& unassigned,
    const labelList& twice
) const
{
    const dictionary& soils = properties_.subDict("soils");
    point example;

    if (const label n = countCells(mesh, unassigned, example))
    {
        FatalIOErrorInFunction(soils)
            << n << " cells lie in no cellZone of a soil, one of them at "
            << example << nl
            << "    Soils: " << names_ << nl
            << "    The mesh's cellZones: " << mesh.cellZones().names() << nl
            << exit(FatalIOError);
    }

    if (const label n = countCells(mesh, twice, example))
    {
        FatalIOErrorInFunction(soils)
            << n << " cells lie in the cellZones of two soils or more,"
            << " one of them at " << example << nl
            << "    Soils: " << names_ << nl
            << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::soilZones::soilZones(const polyMesh& mesh, const word& dictName)
:
    properties_
    (
        IOobject
        (
            dictName,
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    names_(readNames()),
    cellSoil_(mesh.nCells(), -1)
{
    mapCells(mesh);
}

// ************************************************************************* //
