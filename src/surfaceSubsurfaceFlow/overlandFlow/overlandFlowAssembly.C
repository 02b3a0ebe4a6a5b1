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

Foam::scalar Foam::overlandFlow::dMobile
(
    const pondedWater& water,
    const label facei
) const
{
    return
        mobileDepth_[facei] > 0 || storage_[facei] <= 0
      ? water.dDepth()[facei]
      : 0;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::overlandFlow::setDepth(const pondedWater& water)
{
    forAll(h_, i)
    {
        h_[i] = water.depth()[i];
        mobileDepth_[i] = max(h_[i] - storage_[i], scalar(0));
    }
    h_.correctBoundaryConditions();
    mobileDepth_.correctBoundaryConditions();
}


void Foam::overlandFlow::assemble
(
    coupledMatrix& matrix,
    const pondedWater& water
)
{
    const labelUList& owner = aMesh_.owner();
    const labelUList& neighbour = aMesh_.neighbour();

    fluxScale_ = 0;

    forAll(neighbour, edgei)
    {
        const label own = owner[edgei];
        const label nei = neighbour[edgei];

        const label coupling = matrix.addressing().edgeCoupling(edgei);

        if
        (
            mobileDepth_[own] <= 0
         && mobileDepth_[nei] <= 0
         && !matrix.volumes().flowed(coupling)
        )
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
                surroundings_.edges()[edgei]
            )
        );

        fluxScale_ +=
            mag(f.dFirst*(elevation_[own] + mobileDepth_[own]))
          + mag(f.dSecond*(elevation_[nei] + mobileDepth_[nei]));

        matrix.addFlux
        (
            coupling,
            f.value,
            f.dFirst*dMobile(water, own),
            f.dSecond*dMobile(water, nei)
        );
    }

    forAll(aMesh_.boundary(), patchi)
    {
        const labelUList& faces = aMesh_.boundary()[patchi].edgeFaces();
        const List<planGeometry::edgePlan>& edges =
            geometry_.patchEdges()[patchi];

        if (aMesh_.boundary()[patchi].coupled())
        {
            forAll(faces, i)
            {
                const label own = faces[i];
                const overlandFlowModel::flux f
                (
                    model_->edgeFlux
                    (
                        edges[i],
                        side(own),
                        side(patchi, i),
                        surroundings_.patchEdges()[patchi][i]
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
                    f.dFirst*dMobile(water, own),
                    side(patchi, i).depth > 0 ? f.dSecond : 0
                );
            }
        }
        else if (outlets_.set(patchi))
        {
            forAll(faces, i)
            {
                const label own = faces[i];

                surfaceOutlet::edgeWater at;
                at.depth = mobileDepth_[own];
                at.bedSlope = edges[i].fallFirst;
                at.discharge = model_->friction().discharge
                (
                    at.depth,
                    conveyance_[own],
                    at.dDischarge
                );

                scalar dOutflow;
                const scalar outflow =
                    edges[i].length*outlets_[patchi].outflow(at, dOutflow);

                matrix.addOutflow
                (
                    matrix.volumes().groundEdge(patchi, i),
                    outflow,
                    edges[i].length*dOutflow*dMobile(water, own)
                );
            }
        }
    }
}

// ************************************************************************* //
