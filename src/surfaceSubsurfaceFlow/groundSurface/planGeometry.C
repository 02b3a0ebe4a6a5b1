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

#include "planGeometry.H"
#include "groundSurface.H"
#include "areaFields.H"
#include "processorFaPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::planGeometry::edgePlan Foam::planGeometry::makeEdge
(
    const vector& edge,
    const point& middle,
    const point& first,
    const point& second
) const
{
    edgePlan result;

    const vector2D along(plan(edge));

    result.length = mag(along);
    result.delta = plan(second - first);
    result.normal = vector2D(along.y(), -along.x())/max(result.length, VSMALL);
    if ((result.normal & result.delta) < 0)
    {
        result.normal = -result.normal;
    }

    // Bounded for edges that are seen almost end-on from the centres
    const scalar minCosine = 0.05;
    const scalar distance =
        max(result.normal & result.delta, minCosine*mag(result.delta));

    result.inverseDistance = 1/distance;
    result.rest = result.normal - result.delta/distance;

    // Bounded for edges that pass close by a centre
    const scalar minShare = 0.05;
    const bool rim = (middle == second);

    result.position =
        rim
      ? 1
      : min
        (
            max((result.normal & plan(middle - first))/distance, minShare),
            1 - minShare
        );
    result.fallFirst =
        ((first - middle) & up_)/(result.position*distance);
    result.fallSecond =
        rim
      ? 0
      : ((second - middle) & up_)/((1 - result.position)*distance);

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::planGeometry::planGeometry
(
    const faMesh& aMesh,
    const groundSurface& ground
)
:
    aMesh_(aMesh),
    up_(ground.up()),
    edges_(),
    patchEdges_()
{
    // The horizontal axis that is closest to x unless that is vertical
    const vector x
    (
        mag(up_.x()) < 0.9 ? vector(1, 0, 0) : vector(0, 1, 0)
    );

    axis1_ = x - (x & up_)*up_;
    axis1_ /= mag(axis1_);
    axis2_ = up_ ^ axis1_;

    update();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::planGeometry::update()
{
    const fvMesh& mesh = refCast<const fvMesh>(aMesh_.mesh());
    const pointField& points = aMesh_.points();
    const vectorField centres(mesh.faceCentres(), aMesh_.faceLabels());

    const labelUList& owner = aMesh_.owner();
    const labelUList& neighbour = aMesh_.neighbour();

    edges_.setSize(neighbour.size());
    forAll(edges_, edgei)
    {
        edges_[edgei] = makeEdge
        (
            aMesh_.edges()[edgei].vec(points),
            aMesh_.edges()[edgei].centre(points),
            centres[owner[edgei]],
            centres[neighbour[edgei]]
        );
    }

    patchEdges_.setSize(aMesh_.boundary().size());
    forAll(patchEdges_, patchi)
    {
        const faPatch& patch = aMesh_.boundary()[patchi];
        const labelUList& faces = patch.edgeFaces();
        const edgeList::subList edges(patch.patchSlice(aMesh_.edges()));

        List<edgePlan>& plans = patchEdges_[patchi];
        plans.setSize(patch.size());

        const bool coupled = isA<processorFaPatch>(patch);

        forAll(plans, i)
        {
            const point middle(edges[i].centre(points));

            plans[i] = makeEdge
            (
                edges[i].vec(points),
                middle,
                centres[faces[i]],
                coupled
              ? refCast<const processorFaPatch>(patch)
               .neighbEdgeFaceCentres()[i]
              : middle
            );
        }
    }
}

// ************************************************************************* //
