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

void Foam::subsurfaceFlow::endStep(const scalar dt)
{
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

    const auto setDerived = [&]
    (
        const soilTable::state& s,
        const label soili,
        scalar& theta,
        scalar& Se,
        scalar& kr
    )
    {
        const waterRetentionModel& curve = soils_[soili].retention();

        theta = s.theta;
        Se = (s.theta - curve.thetaR())/(curve.thetaS() - curve.thetaR());
        kr = s.K/tables_[soili].Ks();
    };

    forAll(cellStates_, celli)
    {
        psi_[celli] = cellStates_[celli].head;
        setDerived
        (
            cellStates_[celli],
            cellSoil[celli],
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
            const label b = facei - mesh_.nInternalFaces();
            const label soili =
                coupled ? otherSoil_[b] : cellSoil[mesh_.faceOwner()[facei]];

            if (coupled)
            {
                psip[i] = boundaryStates_[b].head;
            }

            setDerived
            (
                coupled
              ? boundaryStates_[b]
              : tables_[soili].at(tables_[soili].tauOfHead(psip[i])),
                soili,
                thetap[i],
                Sep[i],
                krp[i]
            );
        }
    }
}

// ************************************************************************* //
