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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The value of a field on a face of the boundary
static scalar& boundaryValue(volScalarField& field, const label facei)
{
    const polyBoundaryMesh& patches = field.mesh().boundaryMesh();
    const label patchi = patches.whichPatch(facei);

    return field.boundaryFieldRef()[patchi][facei - patches[patchi].start()];
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::subsurfaceFlow::patchHead
(
    const label patchi
) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];

    auto thead = tmp<scalarField>::New(patch.size());
    scalarField& head = thead.ref();

    forAll(head, i)
    {
        const label facei = patch.start() + i;

        switch (conditions_[patchi])
        {
            case condition::surface:
            {
                head[i] = boundaryState(facei).head;
                break;
            }
            case condition::head:
            {
                head[i] = psi_.boundaryField()[patchi][i];
                break;
            }
            case condition::freeDrainage:
            {
                head[i] = psi_[mesh_.faceOwner()[facei]];
                break;
            }
            case condition::seepage:
            {
                head[i] = min(hydrostaticHead(facei), scalar(0));
                break;
            }
            case condition::noFlow:
            case condition::flux:
            {
                head[i] = hydrostaticHead(facei);
                break;
            }
        }
    }

    return thead;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar& Foam::subsurfaceFlow::pondRate(const label facei)
{
    return boundaryValue(storageRate_, facei);
}


Foam::scalar& Foam::subsurfaceFlow::pondRateOld(const label facei)
{
    return boundaryValue(storageRateOld_, facei);
}


void Foam::subsurfaceFlow::initialiseFluxes()
{
    if (pointHistory_ && pointHistory_->read())
    {
        pointHistory_->get(pointFlux_);
    }
    if (obliqueHistory_ && obliqueHistory_->read())
    {
        obliqueHistory_->get(correction_.correction());
    }
}


void Foam::subsurfaceFlow::endStep(const scalar dt)
{
    if (pointHistory_)
    {
        pointHistory_->keep(pointFlux_);
    }
    if (obliqueHistory_)
    {
        obliqueHistory_->keep(correction_.correction());
    }

    storageRateOld_.primitiveFieldRef() = storageRate_.primitiveField();

    forAll(cellStates_, celli)
    {
        storageRate_[celli] =
            (cellStates_[celli].storage - storageOld_[celli])/dt;
    }
}


void Foam::subsurfaceFlow::setFields()
{
    const labelList& cellSoil = soils_.zones().cellSoil();

    const soilVariation& variation = soils_.variation();

    // From the water content by the soil's own curve, and the conductivity
    const auto setDerived = [&]
    (
        const label celli,
        const scalar soilTheta,
        const scalar K,
        scalar& theta,
        scalar& Se,
        scalar& kr
    )
    {
        const label soili = cellSoil[celli];
        const waterRetentionModel& curve = soils_[soili].retention();

        theta = variation.theta(celli, soilTheta);
        Se = (soilTheta - curve.thetaR())/(curve.thetaS() - curve.thetaR());
        kr = K/tables_[soili].Ks();
    };

    forAll(cellStates_, celli)
    {
        const soilTable::state& s = cellStates_[celli];

        psi_[celli] = s.head;
        setDerived
        (
            celli,
            variation.soilTheta(celli, s.theta),
            s.K,
            theta_[celli],
            Se_[celli],
            kr_[celli]
        );
    }

    forAll(conditions_, patchi)
    {
        fvPatchScalarField& psip = psi_.boundaryFieldRef()[patchi];

        const bool coupled = psip.coupled();

        if (isA<soilBoundaryFvPatchScalarField>(psip))
        {
            psip == patchHead(patchi);
        }
        else if (!psip.fixesValue() && !coupled)
        {
            psip.evaluate();
        }

        fvPatchScalarField& thetap = theta_.boundaryFieldRef()[patchi];
        fvPatchScalarField& Sep = Se_.boundaryFieldRef()[patchi];
        fvPatchScalarField& krp = kr_.boundaryFieldRef()[patchi];

        forAll(psip, i)
        {
            const label facei = psip.patch().start() + i;

            if (coupled)
            {
                psip[i] =
                    boundaryStates_[facei - mesh_.nInternalFaces()].head;
            }
            else
            {
                const label celli = mesh_.faceOwner()[facei];
                const soilTable::state s
                (
                    table(celli).at(table(celli).tauOfHead(psip[i]))
                );

                setDerived(celli, s.theta, s.K, thetap[i], Sep[i], krp[i]);
            }
        }
    }

    // Across processors
    theta_.correctBoundaryConditions();
    Se_.correctBoundaryConditions();
    kr_.correctBoundaryConditions();
}

// ************************************************************************* //
