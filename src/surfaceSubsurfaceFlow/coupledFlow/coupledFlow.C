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

#include "coupledFlow.H"
#include "gravityMeshObject.H"
#include "readChecked.H"
#include "surfaceRainFvPatchScalarField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Unit vector against gravity
static vector upward(const Time& runTime)
{
    const vector g(meshObjects::gravity::New(runTime).value());

    if (mag(g) < SMALL)
    {
        FatalErrorInFunction
            << "constant/g is zero: it must say which way water runs"
            << exit(FatalError);
    }

    return -g/mag(g);
}


//- The dictionary exists in constant
static bool given(const fvMesh& mesh, const word& name)
{
    return IOobject
    (
        name,
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    ).typeHeaderOk<IOdictionary>(false);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledFlow::checkGround() const
{
    const fvBoundaryMesh& patches = mesh_.boundary();

    forAll(patches, patchi)
    {
        const fvPatchScalarField& psi = soil_->psi().boundaryField()[patchi];
        const word& patchName = patches[patchi].name();
        const bool isGround =
            overland_ && patchName == overland_->groundPatch();

        if (isGround != (psi.type() == "groundSurface"))
        {
            FatalErrorInFunction
                << "psi, patch " << patchName << ": type is " << psi.type()
                << ". The groundPatch of constant/overlandProperties needs"
                << " groundSurface, and no other patch may have it (file "
                << soil_->psi().objectPath() << ')' << exit(FatalError);
        }
    }
}


void Foam::coupledFlow::addRainPatches()
{
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& psi = soil_->psi().boundaryField()[patchi];

        if (isA<surfaceRainFvPatchScalarField>(psi))
        {
            ground_.addPatch
            (
                mesh_.boundaryMesh()[patchi],
                refCast<const surfaceRainFvPatchScalarField>(psi).rain()
            );
        }
    }
}


void Foam::coupledFlow::readSources()
{
    if (given(mesh_, "waterSources"))
    {
        const IOdictionary dict
        (
            IOobject
            (
                "waterSources",
                mesh_.time().constant(),
                mesh_,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
        sources_.reset(new waterSourceList(dict, ground_, *soil_));
    }
}


Foam::tmp<Foam::scalarField> Foam::coupledFlow::initialHeads() const
{
    auto thead = tmp<scalarField>::New(ground_.size(), Zero);
    scalarField& head = thead.ref();

    forAll(head, i)
    {
        if (soil_)
        {
            const label facei = ground_.faces()[i];
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            const auto& psi = refCast<const soilBoundaryFvPatchScalarField>
            (
                soil_->psi().boundaryField()[patchi]
            );

            head[i] =
                psi.valueGiven()
              ? psi[facei - psi.patch().start()]
              : min(soil_->hydrostaticHead(facei), scalar(0));
        }

        if (i < ground_.nRouted())
        {
            if (overland_->headGiven())
            {
                head[i] = overland_->hs()[i];
            }
            else if (overland_->depthGiven() && overland_->h()[i] > 0)
            {
                head[i] = overland_->h()[i];
            }
        }
    }

    return thead;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledFlow::coupledFlow(fvMesh& mesh, dictionary& state)
:
    mesh_(mesh),
    controlDict_(mesh.solutionDict().subOrEmptyDict("overlandRichards")),
    controls_(controlDict_),
    solver_
    (
        mesh.solutionDict().subOrEmptyDict("solvers").subOrEmptyDict("water")
    ),
    ground_(mesh, upward(mesh.time())),
    overland_(),
    soil_(),
    water_(),
    sources_(),
    runoffWater_(),
    lduMesh_(),
    volumes_(),
    matrix_(),
    scheme_(timeScheme::New(controlDict_)),
    history_(),
    start_(0),
    unknowns_(),
    unknownsOld_(),
    leftOver_(),
    remainder_(),
    keptRemainder_(),
    totals_(),
    part_(part::all),
    hasRunoff_(false),
    hasGround_(false),
    times_(),
    step_(),
    performance_()
{
    wordList keys(coupledFlowControls::keys());
    keys.append("faceFlux");
    keys.append("timeScheme");
    checkKeys(controlDict_, keys, {"timeStep", "steady"});

    if (given(mesh, "overlandProperties"))
    {
        overland_.reset(new overlandFlow(mesh, ground_));
    }

    labelList groundCells;

    if (given(mesh, "soilProperties"))
    {
        soil_.reset(new subsurfaceFlow(mesh, ground_.up(), controlDict_));
        checkGround();
        addRainPatches();
        start_ = soil_->size();
        groundCells = UIndirectList<label>(mesh.faceOwner(), ground_.faces());
        readSources();
    }
    else if (!overland_)
    {
        FatalErrorInFunction
            << "Neither constant/soilProperties nor"
            << " constant/overlandProperties exists in "
            << mesh.time().globalPath() << ": there is nothing to solve"
            << exit(FatalError);
    }

    hasGround_ = returnReduce(ground_.size(), sumOp<label>()) > 0;
    ground_.reportRain
    (
        mesh.time().value(),
        mesh.time().endTime().value()
    );

    water_.reset(new pondedWater(ground_, soil_.get()));
    runoffWater_.reset(new pondedWater(ground_, nullptr));
    lduMesh_.reset
    (
        new coupledLduMesh
        (
            mesh,
            overland_ ? &overland_->aMesh() : nullptr,
            start_,
            ground_.size(),
            groundCells
        )
    );
    volumes_.reset
    (
        new stepVolumes
        (
            *lduMesh_,
            mesh,
            overland_ ? &overland_->aMesh() : nullptr,
            start_
        )
    );
    matrix_.reset(new coupledMatrix(*lduMesh_, *volumes_));

    unknowns_.setSize(start_ + ground_.size(), Zero);
    leftOver_.setSize(unknowns_.size(), Zero);
    keptRemainder_.reset(new stepRemainder(mesh, ground_, start_));
    keptRemainder_->get(leftOver_);

    SubList<scalar> groundUnknowns(unknowns_, ground_.size(), start_);
    water_->initialise(initialHeads(), groundUnknowns);

    if (soil_)
    {
        soil_->initialise(unknowns_);
    }
    if (soil_)
    {
        soil_->prescribe(*volumes_);
    }
    if (overland_)
    {
        forAll(overland_->depthRate(), i)
        {
            water_->depthRate()[i] = overland_->depthRate()[i];
            water_->depthRateOld()[i] = overland_->depthRateOld()[i];
        }
    }
    for (label i = ground_.nRouted(); i < ground_.size(); ++i)
    {
        water_->depthRate()[i] = soil_->pondRate(ground_.faces()[i]);
        water_->depthRateOld()[i] = soil_->pondRateOld(ground_.faces()[i]);
    }

    unknownsOld_ = unknowns_;

    // Fluxes of the initial state, from which the lagging parts begin
    setStates();
    if (soil_)
    {
        soil_->beginStep();
    }
    volumes_->begin(step_.length(), 0, 1, scalarField(), scalarField());
    renewLagged(0);
    assemble();
    setFields();

    if (soil_)
    {
        soil_->initialiseFluxes();
    }
    if (scheme_->order() > 1)
    {
        history_.reset
        (
            new stepHistory
            (
                *volumes_,
                *lduMesh_,
                mesh,
                ground_,
                overland_ ? &overland_->aMesh() : nullptr,
                hasSoil()
            )
        );
    }

    totals_.reset
    (
        new waterTotals
        (
            subsurfaceStorage() + surfaceStorage(),
            storageScale(),
            state
        )
    );

    times_.assignAll(workTimes::setUp);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupledFlow::nextRainChange(const scalar t) const
{
    scalar result = ground_.nextBreakPoint(t);

    if (sources_)
    {
        result = min(result, sources_->nextBreakPoint(t));
    }
    if (soil_)
    {
        result = min(result, soil_->nextBreakPoint(t));
    }

    return result;
}


Foam::scalar Foam::coupledFlow::subsurfaceStorage() const
{
    return soil_ ? soil_->storage() : 0;
}


Foam::scalar Foam::coupledFlow::surfaceStorage() const
{
    return water_->storage();
}


Foam::scalar Foam::coupledFlow::storageScale() const
{
    return surfaceStorage() + (soil_ ? soil_->storageScale() : 0);
}


Foam::scalar Foam::coupledFlow::changedStorage() const
{
    const scalar changed =
        water_->changedStorage() + (soil_ ? soil_->changedStorage() : 0);

    return returnReduce(changed, sumOp<scalar>());
}


Foam::scalar Foam::coupledFlow::gainedStorage() const
{
    const scalar gain =
        water_->gainedStorage() + (soil_ ? soil_->gainedStorage() : 0);

    return returnReduce(gain, sumOp<scalar>());
}


Foam::tmp<Foam::scalarField> Foam::coupledFlow::infiltration() const
{
    auto tresult = tmp<scalarField>::New(ground_.size(), Zero);

    if (soil_)
    {
        forAll(tresult(), i)
        {
            tresult.ref()[i] =
                -volumes_->volume(lduMesh_->groundCoupling(i));
        }
    }

    return tresult;
}


Foam::waterVolumes Foam::coupledFlow::moved() const
{
    waterVolumes result;

    result.rain = water_->rain();
    result.gain = gainedStorage();

    if (sources_)
    {
        result.sourceInflow =
            returnReduce(sources_->inflow(), sumOp<scalar>());
        result.sourceOutflow =
            returnReduce(sources_->outflow(), sumOp<scalar>());
    }

    if (overland_)
    {
        result.surfaceOutflow = overland_->outflow(*volumes_);
    }

    if (soil_)
    {
        result.infiltration = gSum(infiltration()());

        soil_->boundaryVolumes
        (
            *volumes_,
            result.subsurfaceInflow,
            result.subsurfaceOutflow
        );
    }

    return result;
}


void Foam::coupledFlow::setFields()
{
    if (soil_)
    {
        soil_->setFields();
    }
    for (label i = ground_.nRouted(); i < ground_.size(); ++i)
    {
        soil_->pondRate(ground_.faces()[i]) = water_->depthRate()[i];
        soil_->pondRateOld(ground_.faces()[i]) = water_->depthRateOld()[i];
    }

    if (overland_)
    {
        const scalarField exchange(infiltration()/step_.length());

        forAll(overland_->depthRate(), i)
        {
            overland_->depthRate()[i] = water_->depthRate()[i];
            overland_->depthRateOld()[i] = water_->depthRateOld()[i];
        }
        overland_->setFields(*water_, exchange);
    }
}

// ************************************************************************* //
