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

#include "subsurfaceFlow.H"
#include "stepVolumes.H"
#include "calculatedFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A field that follows from psi, written but not read
static volScalarField derivedField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions,
    const IOobject::readOption readOption = IOobject::NO_READ
)
{
    return volScalarField
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            readOption,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimensions, Zero),
        calculatedFvPatchScalarField::typeName
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::subsurfaceFlow::checkHeads() const
{
    // Ten times what the tables of unlimited curves reach
    const scalar largest = 1e7;

    const labelList& cellSoil = soils_.zones().cellSoil();

    forAll(psi_, celli)
    {
        const soilHydraulics& soil = soils_[cellSoil[celli]];
        const scalar least = -min(largest, soil.maxSuction());

        if (psi_[celli] < least || psi_[celli] > largest)
        {
            FatalErrorInFunction
                << "psi is " << psi_[celli] << " m in cell " << celli << " at "
                << mesh_.cellCentres()[celli] << ", soil " << soil.name()
                << "; there it must lie between " << least << " m, where the"
                << " curves of the soil end, and " << largest << " m (file "
                << psi_.objectPath() << ')' << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::subsurfaceFlow::subsurfaceFlow
(
    const fvMesh& mesh,
    const vector& up,
    const dictionary& controls
)
:
    mesh_(mesh),
    up_(up),
    soils_(mesh),
    tables_(soils_.size()),
    anisotropy_(readAnisotropies()),
    psi_
    (
        IOobject
        (
            "psi",
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    boundaryNodes_(psi_),
    theta_(derivedField("theta", mesh, dimless)),
    Se_(derivedField("Se", mesh, dimless)),
    kr_(derivedField("kr", mesh, dimless)),
    storageRate_
    (
        derivedField
        (
            "storageRate",
            mesh,
            dimless/dimTime,
            IOobject::READ_IF_PRESENT
        )
    ),
    storageRateOld_
    (
        derivedField
        (
            "storageRateOld",
            mesh,
            dimless/dimTime,
            IOobject::READ_IF_PRESENT
        )
    ),
    conditions_(mesh.boundary().size(), condition::noFlow),
    flux_(richardsFlux::New(controls, tables_)),
    fallbackFlux_
    (
        richardsFlux::New
        (
            dictionary(IStringStream("faceFlux integralUpwind;")()),
            tables_
        )
    ),
    connections_(mesh.nFaces()),
    correction_(mesh),
    otherSoil_(),
    cellStates_(mesh.nCells()),
    boundaryStates_(mesh.nFaces() - mesh.nInternalFaces()),
    storageOld_(mesh.nCells(), Zero),
    saturatedOld_(mesh.nCells()),
    faceFlux_(mesh.nFaces(), Zero),
    pointFlux_(mesh.nFaces(), Zero),
    pointHistory_(),
    obliqueHistory_(),
    fluxScale_(0)
{
    forAll(tables_, soili)
    {
        tables_.set(soili, new soilTable(soils_[soili]));
    }

    checkHeads();
    readConditions();
    makeConnections();

    const dimensionSet dimensions(dimVolume/dimTime);

    if (correction_.active())
    {
        pointHistory_.reset(new faceHistory("pointFlux", dimensions, mesh));
    }
    if (correction_.changesSoil())
    {
        obliqueHistory_.reset(new faceHistory("obliqueFlux", dimensions, mesh));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::subsurfaceFlow::initialise(scalarField& unknowns) const
{
    forAll(cellStates_, celli)
    {
        unknowns[celli] = table(celli).tauOfHead(psi_[celli]);
    }
}


Foam::scalar Foam::subsurfaceFlow::hydrostaticHead(const label facei) const
{
    const label celli = mesh_.faceOwner()[facei];

    return
        psi_[celli]
      + ((mesh_.cellCentres()[celli] - mesh_.faceCentres()[facei]) & up_);
}


Foam::scalar Foam::subsurfaceFlow::nextBreakPoint(const scalar t) const
{
    scalar result = boundaryNodes_.next(t);

    for (const fvPatchScalarField& psi : psi_.boundaryField())
    {
        if (const auto* patch = isA<soilBoundaryFvPatchScalarField>(psi))
        {
            result = min(result, patch->nextBreakPoint(t));
        }
    }

    return result;
}


void Foam::subsurfaceFlow::prescribe(stepVolumes& volumes) const
{
    forAll(conditions_, patchi)
    {
        if (conditions_[patchi] == condition::flux)
        {
            const polyPatch& patch = mesh_.boundaryMesh()[patchi];
            forAll(patch, i)
            {
                volumes.prescribe(volumes.boundaryFace(patch.start() + i));
            }
        }
    }
}


void Foam::subsurfaceFlow::capacities
(
    SubList<scalar> content,
    SubList<scalar> room
) const
{
    // Rise of the head over which saturated soil takes up water [m]
    const scalar headRise = 1e4;

    const scalarField& V = mesh_.V();

    List<soilTable::state> dry(tables_.size());
    List<soilTable::state> full(tables_.size());
    forAll(tables_, soili)
    {
        const soilTable& soil = tables_[soili];
        soil.evaluate(soil.dryEnd(), dry[soili]);
        soil.evaluate(0, full[soili]);
    }

    const labelList& cellSoil = soils_.zones().cellSoil();

    forAll(cellStates_, celli)
    {
        const soilTable::state& s = cellStates_[celli];

        const auto storageAt = [&](soilTable::state limit)
        {
            soils_.variation().apply(celli, limit);
            return limit.storage;
        };

        content[celli] =
            V[celli]
           *max(s.storage - storageAt(dry[cellSoil[celli]]), scalar(0));
        room[celli] =
            s.tau < 0
          ? V[celli]*(storageAt(full[cellSoil[celli]]) - s.storage)
          : V[celli]*headRise*s.dStorage/s.dHead;
    }
}


Foam::label Foam::subsurfaceFlow::driedCell() const
{
    // What the residual of the step before may take of a cell
    const scalar small = 1e-7;

    forAll(cellStates_, celli)
    {
        const soilTable::state& s = cellStates_[celli];

        if
        (
            !table(celli).aboveDryEnd(s.tau)
         && s.storage < storageOld_[celli] - small
        )
        {
            return celli;
        }
    }

    return -1;
}


void Foam::subsurfaceFlow::localError
(
    const FixedList<scalar, 3>& weights,
    const scalar dt,
    Pair<scalar>& error,
    Pair<scalar>& total
) const
{
    const scalarField& V = mesh_.V();

    forAll(cellStates_, celli)
    {
        const scalar storage = cellStates_[celli].storage;
        const bool saturated =
            cellStates_[celli].tau >= 0 && saturatedOld_.test(celli);

        error[saturated] += V[celli]*sqr
        (
            weights[0]*(storage - storageOld_[celli])/dt
          + weights[1]*storageRate_[celli]
          + weights[2]*storageRateOld_[celli]
        );
        total[saturated] += V[celli]*sqr(storage);
    }
}


Foam::scalar Foam::subsurfaceFlow::changedStorage() const
{
    const scalarField& V = mesh_.V();
    scalar result = 0;

    forAll(cellStates_, celli)
    {
        result += V[celli]*mag(cellStates_[celli].storage - storageOld_[celli]);
    }

    return result;
}


Foam::scalar Foam::subsurfaceFlow::gainedStorage() const
{
    const scalarField& V = mesh_.V();
    scalar result = 0;

    forAll(cellStates_, celli)
    {
        result += V[celli]*(cellStates_[celli].storage - storageOld_[celli]);
    }

    return result;
}


Foam::scalar Foam::subsurfaceFlow::storageMagnitude() const
{
    const scalarField& V = mesh_.V();

    scalar sum = 0;
    forAll(cellStates_, celli)
    {
        sum += V[celli]*mag(cellStates_[celli].storage);
    }

    return sum;
}


void Foam::subsurfaceFlow::addMoved
(
    const stepVolumes& volumes,
    scalar& crossed,
    scalar& changed,
    scalar& total
) const
{
    changed += changedStorage();
    total += storageMagnitude();

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                crossed += mag(volumes.volume(volumes.boundaryFace(facei)));
            }
        }
    }
}


Foam::scalar Foam::subsurfaceFlow::storage() const
{
    const scalarField& V = mesh_.V();

    scalar sum = 0;
    scalar lost = 0;
    forAll(cellStates_, celli)
    {
        // Summed with compensation: the balance wants all digits
        const scalar part = V[celli]*cellStates_[celli].storage - lost;
        const scalar next = sum + part;
        lost = (next - sum) - part;
        sum = next;
    }

    return returnReduce(sum, sumOp<scalar>());
}


Foam::scalar Foam::subsurfaceFlow::storageScale() const
{
    return returnReduce(storageMagnitude(), sumOp<scalar>());
}


void Foam::subsurfaceFlow::boundaryVolumes
(
    const stepVolumes& volumes,
    scalar& inflow,
    scalar& outflow
) const
{
    inflow = 0;
    outflow = 0;

    forAll(conditions_, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];

        if (!patch.coupled() && conditions_[patchi] != condition::surface)
        {
            forAll(patch, i)
            {
                const scalar volume =
                    volumes.volume(volumes.boundaryFace(patch.start() + i));
                (volume < 0 ? inflow : outflow) += mag(volume);
            }
        }
    }

    reduce(inflow, sumOp<scalar>());
    reduce(outflow, sumOp<scalar>());
}

// ************************************************************************* //
