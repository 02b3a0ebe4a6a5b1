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

#include "edgeSurroundings.H"
#include "calculatedFaPatchFields.H"
#include "processorFaPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A field in the faces that is not written
static areaScalarField faceField
(
    const faMesh& aMesh,
    const word& name,
    const dimensionSet& dimensions
)
{
    return areaScalarField
    (
        IOobject
        (
            name,
            aMesh.time().timeName(),
            aMesh.thisDb(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        aMesh,
        dimensionedScalar(dimensions, Zero),
        calculatedFaPatchScalarField::typeName
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::edgeSurroundings::setNeighbours()
{
    const labelUList& owner = aMesh_.owner();
    const labelUList& nei = aMesh_.neighbour();

    forAll(nei, edgei)
    {
        const planGeometry::edgePlan& edge = geometry_.edges()[edgei];
        const scalar inverse = 1/mag(edge.delta);

        neighbours_[owner[edgei]].append
        ({
            nei[edgei], -1, -1, edgei, true,
            edge.delta, inverse, edge.position
        });
        neighbours_[nei[edgei]].append
        ({
            owner[edgei], -1, -1, edgei, false,
            -edge.delta, inverse, 1 - edge.position
        });
    }

    forAll(patchEdges_, patchi)
    {
        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        const bool coupled = aMesh_.boundary()[patchi].coupled();

        forAll(faces, i)
        {
            const planGeometry::edgePlan& edge =
                geometry_.patchEdges()[patchi][i];

            if (!coupled)
            {
                mirrored_[faces[i]].append
                (
                    (2/edge.inverseDistance)*edge.normal
                );
                continue;
            }

            neighbours_[faces[i]].append
            ({
                -1, patchi, i, -1, true,
                edge.delta, 1/mag(edge.delta), edge.position
            });
        }
    }
}


void Foam::edgeSurroundings::setInverse()
{
    // In a direction without neighbours the gradient is zero: the matrix gets
    // a trace of the unit tensor
    const scalar trace = 1e-9;

    forAll(inverse_, facei)
    {
        scalar xx = 0;
        scalar xy = 0;
        scalar yy = 0;

        for (const neighbour& n : neighbours_[facei])
        {
            const vector2D unit(n.inverse*n.delta);

            xx += sqr(unit.x());
            xy += unit.x()*unit.y();
            yy += sqr(unit.y());
        }

        const scalar extra = trace*(xx + yy);
        const scalar determinant = (xx + extra)*(yy + extra) - sqr(xy);

        if (determinant > 0)
        {
            inverse_[facei][0] = (yy + extra)/determinant;
            inverse_[facei][1] = -xy/determinant;
            inverse_[facei][2] = (xx + extra)/determinant;
        }
    }
}


Foam::scalar Foam::edgeSurroundings::rise
(
    const bool followsWater,
    const scalar depth,
    const scalar elevation,
    const scalar otherDepth,
    const scalar otherElevation
)
{
    if (!followsWater)
    {
        return otherElevation - elevation;
    }

    const scalar level = elevation + depth;
    const scalar otherLevel = otherElevation + otherDepth;

    // Dry ground above the water is its shore, not a slope of it
    return otherDepth <= 0 && otherLevel > level ? 0 : otherLevel - level;
}


void Foam::edgeSurroundings::setGradients
(
    const bool followsWater,
    const areaScalarField& depth,
    const areaScalarField& elevation
)
{
    forAll(inverse_, facei)
    {
        gradient1_[facei] = 0;
        gradient2_[facei] = 0;

        // Those of dry faces are not needed
        if (depth[facei] <= 0)
        {
            continue;
        }

        vector2D sum(0, 0);

        for (const neighbour& n : neighbours_[facei])
        {
            sum += sqr(n.inverse)*n.delta*rise
            (
                followsWater,
                depth[facei],
                elevation[facei],
                value(depth, n),
                value(elevation, n)
            );
        }

        const FixedList<scalar, 3>& m = inverse_[facei];

        gradient1_[facei] = m[0]*sum.x() + m[1]*sum.y();
        gradient2_[facei] = m[1]*sum.x() + m[2]*sum.y();
    }

    gradient1_.correctBoundaryConditions();
    gradient2_.correctBoundaryConditions();
}


void Foam::edgeSurroundings::setShape(const areaScalarField& depth)
{
    const scalar share = 0.5;

    forAll(shape_, facei)
    {
        scalar& shape = shape_[facei];

        shape =
            shape > 0 && depth[facei] > 0
          ? shape + share*(depth[facei] - shape)
          : depth[facei];
    }

    shape_.correctBoundaryConditions();
}


Foam::scalar Foam::edgeSurroundings::ratio
(
    const label facei,
    const neighbour& to
) const
{
    const scalar maxRatio = 2;

    // Depth below which the ratio tends to one, so that it has no jump where
    // the ground becomes wet [m]
    const scalar film = 1e-6;

    // Cosine from which a neighbour lies opposite rather than to the side
    const scalar minCosine = 0.25;

    const scalar here = shape_[facei];

    if (here <= 0)
    {
        return 1;
    }

    const scalar ahead = value(shape_, to) - here;

    const vector2D slope(gradient1_[facei], gradient2_[facei]);
    const scalar along = slope & to.delta;

    scalar behind = 0;
    scalar distance = 0;

    // The faces opposite to the edge and on the other side along the flow, with
    // the weight of the flow towards them
    const auto add = [&]
    (
        const vector2D& delta,
        const scalar inverse,
        const scalar change
    )
    {
        const scalar cosine = -(delta & to.delta)*inverse*to.inverse;
        const scalar back = -(slope & delta);

        if (cosine > minCosine && back*along > 0)
        {
            const scalar weight = mag(back)*inverse;

            behind += weight*change;
            distance += weight*mag(back);
        }
    };

    for (const neighbour& n : neighbours_[facei])
    {
        add(n.delta, n.inverse, here - value(shape_, n));
    }
    for (const vector2D& delta : mirrored_[facei])
    {
        add(delta, 1/mag(delta), 0);
    }

    behind *= mag(along)/max(distance, VSMALL);

    if (ahead*behind <= 0)
    {
        return 1;
    }

    const scalar change =
        ahead*behind*(ahead + behind)/(sqr(ahead) + sqr(behind));

    return min
    (
        max(1 + to.position*change/(here + film), 1/maxRatio),
        maxRatio
    );
}


void Foam::edgeSurroundings::setRatios()
{
    forAll(neighbours_, facei)
    {
        for (const neighbour& to : neighbours_[facei])
        {
            overlandFlowModel::surroundings& edge =
                to.face >= 0
              ? edges_[to.edgei]
              : patchEdges_[to.patchi][to.i];

            (to.first ? edge.ratioFirst : edge.ratioSecond) = ratio(facei, to);
        }
    }

    swapRatios();
}


void Foam::edgeSurroundings::swapRatios()
{
    const auto forAllProcessorPatches = [&](const auto& operation)
    {
        forAll(patchEdges_, patchi)
        {
            if (isA<processorFaPatch>(aMesh_.boundary()[patchi]))
            {
                operation
                (
                    refCast<const processorFaPatch>
                    (
                        aMesh_.boundary()[patchi]
                    ),
                    patchEdges_[patchi]
                );
            }
        }
    };

    forAllProcessorPatches
    (
        [](const processorFaPatch& patch, const auto& edges)
        {
            scalarField ratios(edges.size());
            forAll(edges, i)
            {
                ratios[i] = edges[i].ratioFirst;
            }
            patch.send(Pstream::commsTypes::blocking, ratios);
        }
    );

    forAllProcessorPatches
    (
        [](const processorFaPatch& patch, auto& edges)
        {
            const scalarField ratios
            (
                patch.receive<scalar>
                (
                    Pstream::commsTypes::blocking,
                    edges.size()
                )
            );
            forAll(edges, i)
            {
                edges[i].ratioSecond = ratios[i];
            }
        }
    );
}


Foam::vector2D Foam::edgeSurroundings::edgeGradient
(
    const scalar depth1,
    const vector2D& gradient1,
    const scalar depth2,
    const vector2D& gradient2
)
{
    const scalar weight1 = max(depth1, VSMALL);
    const scalar weight2 = max(depth2, VSMALL);

    return (weight1*gradient1 + weight2*gradient2)/(weight1 + weight2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::edgeSurroundings::edgeSurroundings
(
    const faMesh& aMesh,
    const planGeometry& geometry
)
:
    aMesh_(aMesh),
    geometry_(geometry),
    neighbours_(aMesh.nFaces()),
    mirrored_(aMesh.nFaces()),
    inverse_(aMesh.nFaces(), FixedList<scalar, 3>(Zero)),
    shape_(faceField(aMesh, "shapeOfDepth", dimLength)),
    gradient1_(faceField(aMesh, "surfaceGradient1", dimless)),
    gradient2_(faceField(aMesh, "surfaceGradient2", dimless)),
    edges_(aMesh.neighbour().size()),
    patchEdges_(aMesh.boundary().size())
{
    forAll(patchEdges_, patchi)
    {
        if (aMesh.boundary()[patchi].coupled())
        {
            patchEdges_[patchi].setSize(aMesh.boundary()[patchi].size());
        }
    }

    setNeighbours();
    setInverse();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::edgeSurroundings::begin(const areaScalarField& shape)
{
    shape_.primitiveFieldRef() = shape;
}


void Foam::edgeSurroundings::update
(
    const bool followsWater,
    const areaScalarField& depth,
    const areaScalarField& elevation
)
{
    setGradients(followsWater, depth, elevation);
    setShape(depth);
    setRatios();

    const auto gradient = [&](const label facei)
    {
        return vector2D(gradient1_[facei], gradient2_[facei]);
    };

    const labelUList& owner = aMesh_.owner();
    const labelUList& nei = aMesh_.neighbour();

    forAll(edges_, edgei)
    {
        edges_[edgei].gradient = edgeGradient
        (
            depth[owner[edgei]],
            gradient(owner[edgei]),
            depth[nei[edgei]],
            gradient(nei[edgei])
        );
    }

    forAll(patchEdges_, patchi)
    {
        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        const faPatchScalarField& h = depth.boundaryField()[patchi];
        const faPatchScalarField& g1 = gradient1_.boundaryField()[patchi];
        const faPatchScalarField& g2 = gradient2_.boundaryField()[patchi];

        forAll(patchEdges_[patchi], i)
        {
            patchEdges_[patchi][i].gradient = edgeGradient
            (
                depth[faces[i]],
                gradient(faces[i]),
                h[i],
                vector2D(g1[i], g2[i])
            );
        }
    }
}

// ************************************************************************* //
