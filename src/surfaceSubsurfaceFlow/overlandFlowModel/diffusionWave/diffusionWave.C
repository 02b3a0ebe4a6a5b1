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

#include "diffusionWave.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace overlandFlowModels
{
    defineTypeNameAndDebug(diffusionWave, 0);
    addToRunTimeSelectionTable(overlandFlowModel, diffusionWave, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::overlandFlowModels::diffusionWave::diffusionWave(const dictionary& dict)
:
    overlandFlowModel(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::overlandFlowModel::flux
Foam::overlandFlowModels::diffusionWave::edgeFlux
(
    const planGeometry::edgePlan& edge,
    const side& first,
    const side& second,
    const vector2D& gradient
) const
{
    const scalar level1 = first.elevation + first.depth;
    const scalar level2 = second.elevation + second.depth;

    const scalar normal =
        (level2 - level1)*edge.inverseDistance + (edge.rest & gradient);
    const scalar tangential =
        edge.normal.x()*gradient.y() - edge.normal.y()*gradient.x();

    const bool forward = (normal <= 0);
    const side& upwind = forward ? first : second;
    const scalar bed = max(first.elevation, second.elevation);
    const scalar depth = max((forward ? level1 : level2) - bed, scalar(0));

    scalar dNormal, dDepth;
    flux result;

    result.value = manningFlux
    (
        edge.length,
        upwind.manning,
        depth,
        normal,
        tangential,
        dNormal,
        dDepth
    );
    result.dFirst = -dNormal*edge.inverseDistance + (forward ? dDepth : 0);
    result.dSecond = dNormal*edge.inverseDistance + (forward ? 0 : dDepth);

    return result;
}

// ************************************************************************* //
