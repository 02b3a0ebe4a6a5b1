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

#include "overlandFlow.H"
#include "pondedWater.H"
#include "coupledMatrix.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::overlandFlow::rise
(
    const scalar depth,
    const scalar elevation,
    const scalar otherDepth,
    const scalar otherElevation
) const
{
    if (!model_->followsWater())
    {
        return otherElevation - elevation;
    }

    const scalar level = elevation + depth;
    const scalar otherLevel = otherElevation + otherDepth;

    // Dry ground above the water is its shore, not a slope of it
    return otherDepth <= 0 && otherLevel > level ? 0 : otherLevel - level;
}


Foam::vector2D Foam::overlandFlow::edgeGradient
(
    const scalar depth1,
    const vector2D& gradient1,
    const scalar depth2,
    const vector2D& gradient2
)
{
    if (depth2 <= 0)
    {
        return gradient1;
    }

    return depth1 <= 0 ? gradient2 : 0.5*(gradient1 + gradient2);
}


void Foam::overlandFlow::setFaceGradients()
{
    // Least squares over the neighbours. In a direction without neighbours
    // the gradient is zero: the matrix gets a trace of the unit tensor
    const scalar trace = 1e-9;

    const label n = h_.size();
    List<vector2D> sums(n, vector2D(0, 0));
    scalarField xx(n, Zero);
    scalarField xy(n, Zero);
    scalarField yy(n, Zero);

    const auto add = [&]
    (
        const label facei,
        const vector2D& delta,
        const scalar difference
    )
    {
        const scalar weight = 1/magSqr(delta);
        sums[facei] += (weight*difference)*delta;
        xx[facei] += weight*sqr(delta.x());
        xy[facei] += weight*delta.x()*delta.y();
        yy[facei] += weight*sqr(delta.y());
    };

    const auto riseTo = [&](const label i, const label j)
    {
        return rise(h_[i], elevation_[i], h_[j], elevation_[j]);
    };

    const labelUList& owner = aMesh_.owner();
    const labelUList& neighbour = aMesh_.neighbour();

    forAll(neighbour, edgei)
    {
        const label own = owner[edgei];
        const label nei = neighbour[edgei];
        const vector2D& delta = geometry_.edges()[edgei].delta;

        if (h_[own] > 0 || h_[nei] > 0)
        {
            add(own, delta, riseTo(own, nei));
            add(nei, -delta, riseTo(nei, own));
        }
    }

    forAll(aMesh_.boundary(), patchi)
    {
        if (!aMesh_.boundary()[patchi].coupled())
        {
            continue;
        }

        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        forAll(faces, i)
        {
            const label own = faces[i];
            add
            (
                own,
                geometry_.patchEdges()[patchi][i].delta,
                rise
                (
                    h_[own],
                    elevation_[own],
                    h_.boundaryField()[patchi][i],
                    elevation_.boundaryField()[patchi][i]
                )
            );
        }
    }

    forAll(h_, i)
    {
        if (xx[i] + yy[i] <= 0)
        {
            gradient1_[i] = 0;
            gradient2_[i] = 0;
            continue;
        }

        const scalar extra = trace*(xx[i] + yy[i]);
        const scalar a = xx[i] + extra;
        const scalar c = yy[i] + extra;
        const scalar determinant = a*c - sqr(xy[i]);

        gradient1_[i] = (c*sums[i].x() - xy[i]*sums[i].y())/determinant;
        gradient2_[i] = (a*sums[i].y() - xy[i]*sums[i].x())/determinant;
    }

    gradient1_.correctBoundaryConditions();
    gradient2_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::overlandFlow::setDepth(const pondedWater& water)
{
    forAll(h_, i)
    {
        h_[i] = water.depth()[i];
    }
    h_.correctBoundaryConditions();
}


void Foam::overlandFlow::renewGradient()
{
    setFaceGradients();

    const labelUList& owner = aMesh_.owner();
    const labelUList& neighbour = aMesh_.neighbour();

    const auto gradient = [&](const label i)
    {
        return vector2D(gradient1_[i], gradient2_[i]);
    };

    forAll(neighbour, edgei)
    {
        const label own = owner[edgei];
        const label nei = neighbour[edgei];

        edgeGradients_[edgei] = edgeGradient
        (
            h_[own],
            gradient(own),
            h_[nei],
            gradient(nei)
        );
    }

    forAll(aMesh_.boundary(), patchi)
    {
        if (!aMesh_.boundary()[patchi].coupled())
        {
            continue;
        }

        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        const faPatchScalarField& g1 = gradient1_.boundaryField()[patchi];
        const faPatchScalarField& g2 = gradient2_.boundaryField()[patchi];

        List<vector2D>& gradients = patchGradients_[patchi];
        gradients.setSize(faces.size());

        forAll(faces, i)
        {
            gradients[i] = edgeGradient
            (
                h_[faces[i]],
                gradient(faces[i]),
                h_.boundaryField()[patchi][i],
                vector2D(g1[i], g2[i])
            );
        }
    }
}


void Foam::overlandFlow::assemble
(
    coupledMatrix& matrix,
    const pondedWater& water
)
{
    const labelUList& owner = aMesh_.owner();
    const labelUList& neighbour = aMesh_.neighbour();
    const scalarField& dDepth = water.dDepth();

    fluxScale_ = 0;

    forAll(neighbour, edgei)
    {
        const label own = owner[edgei];
        const label nei = neighbour[edgei];

        if (h_[own] <= 0 && h_[nei] <= 0)
        {
            continue;
        }

        const overlandFlowModel::flux f
        (
            model_->edgeFlux
            (
                geometry_.edges()[edgei],
                side(own),
                side(nei),
                edgeGradients_[edgei]
            )
        );

        fluxScale_ +=
            mag(f.dFirst*(elevation_[own] + h_[own]))
          + mag(f.dSecond*(elevation_[nei] + h_[nei]));

        matrix.addFlux
        (
            matrix.addressing().edgeCoupling(edgei),
            f.value,
            f.dFirst*dDepth[own],
            f.dSecond*dDepth[nei]
        );
    }

    forAll(aMesh_.boundary(), patchi)
    {
        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        const List<planGeometry::edgePlan>& edges =
            geometry_.patchEdges()[patchi];

        if (aMesh_.boundary()[patchi].coupled())
        {
            const faPatchScalarField& h = h_.boundaryField()[patchi];
            const faPatchScalarField& z = elevation_.boundaryField()[patchi];
            const faPatchScalarField& n = manning_.boundaryField()[patchi];

            forAll(faces, i)
            {
                const label own = faces[i];
                const overlandFlowModel::flux f
                (
                    model_->edgeFlux
                    (
                        edges[i],
                        side(own),
                        {h[i], z[i], n[i]},
                        patchGradients_[patchi][i]
                    )
                );

                // Wet ground on the other side moves with its unknown by
                // saturatedScale = 1 m, as on this side
                matrix.addInterfaceFlux
                (
                    matrix.addressing().groundSlot(patchi),
                    i,
                    matrix.volumes().groundEdge(patchi, i),
                    f.value,
                    f.dFirst*dDepth[own],
                    h[i] > 0 ? f.dSecond : 0
                );
            }
        }
        else if (outlets_.set(patchi))
        {
            forAll(faces, i)
            {
                const label own = faces[i];
                scalar dOutflow;
                const scalar outflow = edges[i].length*outlets_[patchi].outflow
                (
                    h_[own],
                    (elevation_[own] - edges[i].elevation)
                   *edges[i].inverseDistance,
                    manning_[own],
                    dOutflow
                );

                matrix.addOutflow
                (
                    matrix.volumes().groundEdge(patchi, i),
                    outflow,
                    edges[i].length*dOutflow*dDepth[own]
                );
            }
        }
    }
}

// ************************************************************************* //
