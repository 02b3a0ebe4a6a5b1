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

#include "coupledLduMesh.H"
#include "faMesh.H"
#include "processorFvPatch.H"
#include "processorFaPatch.H"
#include "processorGAMGInterface.H"
#include "processorGAMGInterfaceField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::coupledLduMesh::coupledLduMesh
(
    const fvMesh& mesh,
    const faMesh* aMesh,
    const label nCells,
    const label nFaces,
    const label nEdges,
    addressing&& couplings
)
:
    objectRegistry
    (
        IOobject
        (
            "coupledLduMesh",
            mesh.time().timeName(),
            mesh.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    lduPrimitiveMesh
    (
        couplings.size,
        couplings.lower,
        couplings.upper,
        mesh.comm(),
        true
    ),
    couplings_(std::move(couplings)),
    nFaceCouplings_(nFaces),
    nEdgeCouplings_(nEdges),
    meshSlots_(mesh.boundary().size()),
    groundSlots_(aMesh ? aMesh->boundary().size() : 0),
    interfaceFields_(),
    interfaceFieldPtrs_()
{
    makeInterfaces(mesh, aMesh, nCells);
}


void Foam::coupledLduMesh::makeInterfaces
(
    const fvMesh& mesh,
    const faMesh* aMesh,
    const label nCells
)
{
    // Unknowns beside each neighbour's, first those of the mesh's patches.
    // The order within a patch is the same on both sides
    Map<DynamicList<label>> sharedUnknowns;

    if (nCells)
    {
        forAll(mesh.boundary(), patchi)
        {
            const auto* patch =
                isA<processorFvPatch>(mesh.boundary()[patchi])
              ? &refCast<const processorFvPatch>(mesh.boundary()[patchi])
              : nullptr;

            if (patch)
            {
                auto& unknowns = sharedUnknowns(patch->neighbProcNo());
                meshSlots_[patchi].index = patch->neighbProcNo();
                meshSlots_[patchi].start = unknowns.size();
                unknowns.append(patch->faceCells());
            }
        }
    }

    forAll(groundSlots_, patchi)
    {
        const auto* patch =
            isA<processorFaPatch>(aMesh->boundary()[patchi])
          ? &refCast<const processorFaPatch>(aMesh->boundary()[patchi])
          : nullptr;

        if (patch)
        {
            auto& unknowns = sharedUnknowns(patch->neighbProcNo());
            groundSlots_[patchi].index = patch->neighbProcNo();
            groundSlots_[patchi].start = unknowns.size();
            for (const label facei : patch->edgeFaces())
            {
                unknowns.append(nCells + facei);
            }
        }
    }

    const labelList neighbours(sharedUnknowns.sortedToc());

    lduInterfacePtrsList interfaces(neighbours.size());
    forAll(neighbours, i)
    {
        interfaces.set
        (
            i,
            new processorGAMGInterface
            (
                i,
                rawInterfaces(),
                sharedUnknowns[neighbours[i]],
                labelList(),
                comm(),
                UPstream::myProcNo(comm()),
                neighbours[i],
                tensorField(),
                UPstream::msgType()
            )
        );
    }

    addInterfaces
    (
        interfaces,
        lduPrimitiveMesh::nonBlockingSchedule<processorGAMGInterface>
        (
            interfaces
        )
    );

    interfaceFields_.setSize(neighbours.size());
    interfaceFieldPtrs_.setSize(neighbours.size());
    forAll(neighbours, i)
    {
        interfaceFields_.set
        (
            i,
            new processorGAMGInterfaceField
            (
                refCast<const GAMGInterface>(rawInterfaces()[i]),
                false,
                0
            )
        );
        interfaceFieldPtrs_.set(i, &interfaceFields_[i]);
    }

    // So far the slots name the neighbour, not the interface
    for (List<interfaceSlot>* slots : {&meshSlots_, &groundSlots_})
    {
        for (interfaceSlot& slot : *slots)
        {
            slot.index = neighbours.find(slot.index);
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::coupledLduMesh::addressing Foam::coupledLduMesh::makeCouplings
(
    const fvMesh& mesh,
    const faMesh* aMesh,
    const label nCells,
    const label nGround,
    const labelUList& groundCells
)
{
    addressing result;
    result.size = nCells + nGround;

    DynamicList<label> first;
    DynamicList<label> second;

    if (nCells)
    {
        first.append(mesh.owner());
        second.append(mesh.neighbour());
    }

    if (aMesh)
    {
        forAll(aMesh->neighbour(), edgei)
        {
            first.append(nCells + aMesh->owner()[edgei]);
            second.append(nCells + aMesh->neighbour()[edgei]);
        }
    }

    forAll(groundCells, i)
    {
        first.append(groundCells[i]);
        second.append(nCells + i);
    }

    result.first.transfer(first);
    result.second.transfer(second);

    const label n = result.first.size();
    labelList lower(n);
    labelList upper(n);
    forAll(lower, i)
    {
        lower[i] = min(result.first[i], result.second[i]);
        upper[i] = max(result.first[i], result.second[i]);
    }

    result.sorted =
        lduPrimitiveMesh::upperTriOrder(result.size, lower, upper);

    result.lower.setSize(n);
    result.upper.setSize(n);
    forAll(lower, i)
    {
        result.lower[result.sorted[i]] = lower[i];
        result.upper[result.sorted[i]] = upper[i];
    }

    lduPrimitiveMesh::checkUpperTriangular
    (
        result.size,
        result.lower,
        result.upper
    );

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledLduMesh::coupledLduMesh
(
    const fvMesh& mesh,
    const faMesh* aMesh,
    const label nCells,
    const label nGround,
    const labelUList& groundCells
)
:
    coupledLduMesh
    (
        mesh,
        aMesh,
        nCells,
        nCells ? mesh.nInternalFaces() : 0,
        aMesh ? aMesh->neighbour().size() : 0,
        makeCouplings(mesh, aMesh, nCells, nGround, groundCells)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::scalarField> Foam::coupledLduMesh::across
(
    const List<scalarField>& here
) const
{
    const Pstream::commsTypes comms = Pstream::commsTypes::nonBlocking;

    List<scalarField> result(here.size());
    const label startRequest = Pstream::nRequests();

    const auto interface = [&](const label i) -> const processorLduInterface&
    {
        return refCast<const processorLduInterface>
        (
            rawInterfaces()[i]
        );
    };

    forAll(here, i)
    {
        interface(i).send(comms, here[i]);
    }
    Pstream::waitRequests(startRequest);

    forAll(result, i)
    {
        result[i].setSize(here[i].size());
        interface(i).receive(comms, result[i]);
    }

    return result;
}

// ************************************************************************* //
