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

#include "depthBelowGround.H"
#include "polyMesh.H"
#include "readChecked.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace waterTables
{
    defineTypeNameAndDebug(depthBelowGround, 0);
    addToRunTimeSelectionTable(waterTable, depthBelowGround, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterTables::depthBelowGround::depthBelowGround
(
    const dictionary& dict,
    const polyMesh& mesh,
    const vector& up
)
:
    waterTable(),
    depth_
    (
        readChecked
        (
            dict,
            "depth",
            [](const scalar x) { return x >= 0; },
            "depth >= 0 [m]"
        )
    )
{
    checkKeys(dict, {"type", "depth", "groundPatch"}, {"FoamFile"});

    const word patchName(dict.getOrDefault<word>("groundPatch", "ground"));
    const label patchi = mesh.boundaryMesh().findPatchID(patchName);

    if (patchi < 0)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh has no patch '" << patchName << "' (entry groundPatch)"
            << nl << "    Valid names: " << mesh.boundaryMesh().names() << nl
            << exit(FatalIOError);
    }

    ground_.reset(new planSurface(mesh.boundaryMesh()[patchi], up));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::waterTables::depthBelowGround::elevation
(
    const UList<point>& points
) const
{
    return ground_->elevation(points) - depth_;
}

// ************************************************************************* //
