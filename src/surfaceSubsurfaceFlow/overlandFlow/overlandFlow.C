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
#include "readChecked.H"
#include "pondedWater.H"
#include "stepVolumes.H"
#include "groundField.H"
#include "calculatedFaPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::areaScalarField> Foam::overlandFlow::areaField
(
    const word& name,
    const dimensionSet& dimensions,
    const IOobject::readOption readOption,
    const IOobject::writeOption writeOption
) const
{
    const IOobject io
    (
        name,
        aMesh_.time().timeName(),
        aMesh_.thisDb(),
        readOption,
        writeOption
    );

    if
    (
        readOption == IOobject::READ_IF_PRESENT
     && IOobject(io).typeHeaderOk<areaScalarField>(true)
    )
    {
        Info<< "Reading field " << name << endl;
        return tmp<areaScalarField>::New(io, aMesh_);
    }

    return tmp<areaScalarField>::New
    (
        IOobject
        (
            name,
            aMesh_.time().timeName(),
            aMesh_.thisDb(),
            IOobject::NO_READ,
            writeOption
        ),
        aMesh_,
        dimensionedScalar(dimensions, Zero),
        calculatedFaPatchScalarField::typeName
    );
}


Foam::groundSurface& Foam::overlandFlow::addTo(groundSurface& ground) const
{
    const polyBoundaryMesh& patches = aMesh_.mesh().boundaryMesh();
    const label patchi = patches.findPatchID(groundPatch());

    if (patchi < 0)
    {
        FatalIOErrorInFunction(properties_)
            << "groundPatch " << groundPatch() << " is no patch of the mesh;"
            << " it has " << patches.names() << exit(FatalIOError);
    }

    label nOutside = 0;
    for (const label facei : aMesh_.faceLabels())
    {
        if (patches.whichPatch(facei) != patchi)
        {
            ++nOutside;
        }
    }

    if
    (
        returnReduce(nOutside, sumOp<label>())
     || returnReduce(aMesh_.nFaces(), sumOp<label>())
     != returnReduce(patches[patchi].size(), sumOp<label>())
    )
    {
        FatalIOErrorInFunction(properties_)
            << "groundPatch " << groundPatch() << " is not the patch of the"
            << " finite-area mesh: polyMeshPatches in faMeshDefinition must"
            << " name it and no other; then run makeFaMesh again"
            << exit(FatalIOError);
    }

    ground.addRouted(aMesh_, properties_);

    return ground;
}


void Foam::overlandFlow::setGround()
{
    const frictionModel& friction = model_->friction();

    conveyance_.primitiveFieldRef() = readGroundField
    (
        aMesh_,
        properties_,
        friction.type(),
        [](const scalar coefficient) { return coefficient > 0; },
        friction.range()
    );

    if (properties_.found("depressionStorage"))
    {
        storage_ = readGroundField
        (
            aMesh_,
            properties_,
            "depressionStorage",
            [](const scalar depth) { return depth >= 0; },
            ">= 0 m"
        );
    }

    forAll(elevation_, i)
    {
        const scalar cosine =
            ground_.planArea()[i]
           /mag(aMesh_.mesh().faceAreas()[ground_.faces()[i]]);

        conveyance_[i] = friction.conveyance(conveyance_[i]);
        bedSlope_[i] = sqrt(max(1/sqr(cosine) - 1, scalar(0)));
        elevation_[i] = ground_.elevation()[i] + storage_[i];
    }

    for (areaScalarField* field : {&conveyance_, &bedSlope_, &elevation_})
    {
        field->correctBoundaryConditions();
    }
}


void Foam::overlandFlow::setOutlets()
{
    if (!properties_.found("outlets"))
    {
        return;
    }

    const dictionary& dict = properties_.subDict("outlets");
    const faBoundaryMesh& patches = aMesh_.boundary();

    for (const word& patchName : dict.toc())
    {
        const label patchi = patches.findPatchID(patchName);
        if (patchi < 0)
        {
            FatalIOErrorInFunction(dict)
                << "No patch " << patchName
                << " in the finite-area mesh; it has " << patches.names()
                << exit(FatalIOError);
        }

        const List<planGeometry::edgePlan>& edges =
            geometry_.patchEdges()[patchi];

        scalar length = 0;
        for (const planGeometry::edgePlan& edge : edges)
        {
            length += edge.length;
        }

        outlets_.set
        (
            patchi,
            surfaceOutlet::New
            (
                patchName,
                returnReduce(length, sumOp<scalar>()),
                dict.subDict(patchName)
            )
        );

        const labelUList& faces = patches[patchi].edgeFaces();
        forAll(faces, i)
        {
            outlets_[patchi].checkEdge
            (
                edges[i].fallFirst,
                aMesh_.areaCentres()[faces[i]]
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::overlandFlow::overlandFlow(const fvMesh& mesh, groundSurface& ground)
:
    properties_
    (
        IOobject
        (
            "overlandProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    aMesh_(mesh),
    model_(overlandFlowModel::New(properties_)),
    ground_(addTo(ground)),
    geometry_(aMesh_, ground_),
    outlets_(aMesh_.boundary().size()),
    conveyance_
    (
        areaField
        (
            "conveyance",
            dimless,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    bedSlope_
    (
        areaField
        (
            "bedSlope",
            dimless,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    storage_(aMesh_.nFaces(), Zero),
    elevation_
    (
        areaField
        (
            "elevation",
            dimLength,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mobileDepth_
    (
        areaField
        (
            "mobileDepth",
            dimLength,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    h_
    (
        areaField
        (
            "h",
            dimLength,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    hs_
    (
        areaField
        (
            "hs",
            dimLength,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    qExchange_
    (
        areaField
        (
            "qExchange",
            dimVelocity,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    depthRate_
    (
        areaField
        (
            "depthRate",
            dimVelocity,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    depthRateOld_
    (
        areaField
        (
            "depthRateOld",
            dimVelocity,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    shapeDepth_
    (
        areaField
        (
            "shapeDepth",
            dimLength,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    surroundings_(aMesh_, geometry_),
    fluxScale_(0)
{
    const word friction
    (
        properties_.getOrDefault<word>("frictionModel", "manning")
    );
    checkKeys
    (
        properties_,
        {
            "groundPatch", "overlandFlowModel", "slopeFloor", "slope",
            "frictionModel", friction, "depressionStorage", "rainfall"
        },
        {
            friction + "Zones", "depressionStorageZones", "rainfall",
            "rainfallCoeffs", "outlets", "hydrographs"
        }
    );

    // Construction from a temporary field does not keep this
    for
    (
        areaScalarField* field
      : {&h_, &hs_, &qExchange_, &depthRate_, &depthRateOld_, &shapeDepth_}
    )
    {
        field->writeOpt() = IOobject::AUTO_WRITE;
    }

    setGround();
    setOutlets();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::overlandFlow::headGiven() const
{
    return hs_.readOpt() == IOobject::READ_IF_PRESENT;
}


bool Foam::overlandFlow::depthGiven() const
{
    return h_.readOpt() == IOobject::READ_IF_PRESENT;
}


Foam::scalar Foam::overlandFlow::outflow(const stepVolumes& volumes) const
{
    scalar sum = 0;

    forAll(outlets_, patchi)
    {
        if (outlets_.set(patchi))
        {
            forAll(aMesh_.boundary()[patchi].edgeFaces(), i)
            {
                sum += volumes.volume(volumes.groundEdge(patchi, i));
            }
        }
    }

    return returnReduce(sum, sumOp<scalar>());
}


void Foam::overlandFlow::setFields
(
    const pondedWater& water,
    const UList<scalar>& exchange
)
{
    forAll(hs_, i)
    {
        hs_[i] = water.head()[i];
        qExchange_[i] = exchange[i]/ground_.planArea()[i];
    }
    setDepth(water);
    hs_.correctBoundaryConditions();
    qExchange_.correctBoundaryConditions();
}

// ************************************************************************* //
