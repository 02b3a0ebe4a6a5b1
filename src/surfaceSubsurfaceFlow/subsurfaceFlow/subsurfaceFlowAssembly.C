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
#include "coupledMatrix.H"
#include "groundSurface.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::subsurfaceFlow::correct
(
    richardsFlux::flux& f,
    const label facei,
    const soilTable::state& first,
    const soilTable::state& second
)
{
    if (!correction_.active())
    {
        return;
    }

    const auto mobility = [&](const soilTable::state& s, const label soili)
    {
        const scalar K = max(s.K, VSMALL);
        return nonOrthogonalFlux::mobility{K/tables_[soili].Ks(), s.dK/K};
    };

    const richardsFlux::connection& c = connections_[facei];

    correction_.addTo
    (
        f,
        facei,
        mobility(first, c.soil1),
        mobility(second, c.soil2)
    );
}


void Foam::subsurfaceFlow::assembleStorage(coupledMatrix& matrix) const
{
    const scalarField& V = mesh_.V();

    // Zhu2022 Eq. 8: the change of W, whose derivative is Cm + Se Ss
    forAll(cellStates_, celli)
    {
        const soilTable::state& s = cellStates_[celli];

        matrix.add
        (
            celli,
            V[celli]*(s.storage - storageOld_[celli]),
            V[celli]*s.dStorage
        );
    }
}


void Foam::subsurfaceFlow::assembleInternal
(
    coupledMatrix& matrix,
    const richardsFlux& flux
)
{
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    // Zhu2022 Eq. 8: -K A grad(Hp + z) through the faces
    forAll(neighbour, facei)
    {
        const soilTable::state& first = cellStates_[owner[facei]];
        const soilTable::state& second = cellStates_[neighbour[facei]];
        richardsFlux::flux f(flux(connections_[facei], first, second));

        pointFlux_[facei] = f.value;
        correct(f, facei, first, second);
        faceFlux_[facei] = f.value;
        fluxScale_ += f.scale;

        matrix.addFlux
        (
            matrix.addressing().faceCoupling(facei),
            faceFlux_[facei],
            f.dFirst,
            f.dSecond
        );
    }
}


void Foam::subsurfaceFlow::assembleProcessor
(
    coupledMatrix& matrix,
    const richardsFlux& flux,
    const label patchi
)
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    const coupledLduMesh::interfaceSlot& slot =
        matrix.addressing().meshSlot(patchi);

    forAll(patch, i)
    {
        const label facei = patch.start() + i;
        const soilTable::state& first =
            cellStates_[mesh_.faceOwner()[facei]];
        const soilTable::state& second = boundaryState(facei);
        richardsFlux::flux f(flux(connections_[facei], first, second));

        pointFlux_[facei] = f.value;
        correct(f, facei, first, second);
        faceFlux_[facei] = f.value;
        fluxScale_ += f.scale;

        matrix.addInterfaceFlux
        (
            slot,
            i,
            matrix.volumes().boundaryFace(facei),
            faceFlux_[facei],
            f.dFirst,
            f.dSecond
        );
    }
}


Foam::richardsFlux::flux Foam::subsurfaceFlow::boundaryFlux
(
    const richardsFlux& flux,
    const condition type,
    const label facei,
    const scalar inflow
) const
{
    const soilTable::state& cell = cellStates_[mesh_.faceOwner()[facei]];

    richardsFlux::flux result;

    switch (type)
    {
        case condition::flux:
        {
            result.value = -inflow*mag(mesh_.faceAreas()[facei]);
            break;
        }
        case condition::freeDrainage:
        {
            const vector area
            (
                anisotropy_[connections_[facei].soil1]
              & mesh_.faceAreas()[facei]
            );
            const scalar downArea =
                soils_.variation().conductivity(mesh_.faceOwner()[facei])
               *max(-(area & up_), scalar(0));
            result.value = downArea*cell.K;
            result.dFirst = downArea*cell.dK;
            result.scale = mag(result.value);
            break;
        }
        case condition::head:
        case condition::seepage:
        {
            result = flux(connections_[facei], cell, boundaryState(facei));
            break;
        }
        case condition::noFlow:
        case condition::surface:
        {
            break;
        }
    }

    return result;
}


void Foam::subsurfaceFlow::assemblePatch
(
    coupledMatrix& matrix,
    const scalar t1,
    const scalar t2,
    const richardsFlux& flux,
    const label patchi
)
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    const fvPatchScalarField& field = psi_.boundaryField()[patchi];

    const scalar inflow =
        conditions_[patchi] == condition::flux
      ? refCast<const soilBoundaryFvPatchScalarField>(field)
       .inflow(t1, t2)
      : 0;

    forAll(patch, i)
    {
        const label facei = patch.start() + i;
        const condition type = conditions_[patchi];
        richardsFlux::flux f(boundaryFlux(flux, type, facei, inflow));

        pointFlux_[facei] = f.value;
        if (open(type))
        {
            correct
            (
                f,
                facei,
                cellStates_[mesh_.faceOwner()[facei]],
                boundaryState(facei)
            );
        }
        if (type == condition::seepage && f.value <= 0)
        {
            f = richardsFlux::flux();
            pointFlux_[facei] = -correction_.correction()[facei];
        }
        faceFlux_[facei] = f.value;
        fluxScale_ += f.scale;

        matrix.addOutflow
        (
            matrix.volumes().boundaryFace(facei),
            faceFlux_[facei],
            f.dFirst
        );
    }
}


void Foam::subsurfaceFlow::assembleGround
(
    coupledMatrix& matrix,
    const groundSurface& ground,
    const richardsFlux& flux
)
{
    forAll(ground.faces(), i)
    {
        const label facei = ground.faces()[i];
        const soilTable::state& cell =
            cellStates_[mesh_.faceOwner()[facei]];
        const soilTable::state& s = boundaryState(facei);
        richardsFlux::flux f(flux(connections_[facei], cell, s));

        pointFlux_[facei] = f.value;
        fluxScale_ += f.scale;

        correct(f, facei, cell, s);
        faceFlux_[facei] = f.value;

        matrix.addFlux
        (
            matrix.addressing().groundCoupling(i),
            f.value,
            f.dFirst,
            f.dSecond
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::subsurfaceFlow::beginStep()
{
    forAll(cellStates_, celli)
    {
        storageOld_[celli] = cellStates_[celli].storage;
        saturatedOld_.set(celli, cellStates_[celli].tau >= 0);
    }

    volScalarField::Boundary& psiBf = psi_.boundaryFieldRef();

    forAll(conditions_, patchi)
    {
        const condition type = conditions_[patchi];

        if (type != condition::head && type != condition::seepage)
        {
            continue;
        }

        if (type == condition::head)
        {
            psiBf[patchi].updateCoeffs();
            psiBf[patchi].evaluate();
        }

        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const soilTable& soil = table(mesh_.faceOwner()[facei]);

            soil.evaluate
            (
                soil.tauOfHead
                (
                    type == condition::head ? psiBf[patchi][i] : 0
                ),
                boundaryStates_[facei - mesh_.nInternalFaces()]
            );
        }
    }
}


void Foam::subsurfaceFlow::extrapolate
(
    const Pair<scalar>& weights,
    SubList<scalar> unknowns
) const
{
    forAll(cellStates_, celli)
    {
        const soilTable::state& s = cellStates_[celli];

        if (s.tau < 0 && table(celli).aboveDryEnd(s.tau))
        {
            const scalar change =
                weights.first()*storageRate_[celli]
              + weights.second()*storageRateOld_[celli];

            // tau is that long; a soil may hold no water that moves
            if (mag(change) < 2*s.dStorage)
            {
                const scalar to = s.tau + change/s.dStorage;

                // Not into another part of the curves
                if (to < 0 && table(celli).aboveDryEnd(to))
                {
                    unknowns[celli] = to;
                }
            }
        }
    }
}


void Foam::subsurfaceFlow::setCells(const UList<scalar>& unknowns)
{
    forAll(cellStates_, celli)
    {
        table(celli).evaluate(unknowns[celli], cellStates_[celli]);
        soils_.variation().apply(celli, cellStates_[celli]);
    }

    if (!Pstream::parRun())
    {
        return;
    }

    scalarList otherUnknowns;
    syncTools::swapBoundaryCellList(mesh_, unknowns, otherUnknowns);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label b = patch.start() + i - mesh_.nInternalFaces();
                tables_[otherSoil_[b]].evaluate
                (
                    otherUnknowns[b],
                    boundaryStates_[b]
                );
            }
        }
    }
}


void Foam::subsurfaceFlow::setGround(const label facei, const scalar unknown)
{
    table(mesh_.faceOwner()[facei]).evaluate
    (
        unknown,
        boundaryStates_[facei - mesh_.nInternalFaces()]
    );
}


void Foam::subsurfaceFlow::renewCorrection(const scalar weight)
{
    if (!correction_.active())
    {
        return;
    }

    scalarField kr(cellStates_.size());
    forAll(kr, celli)
    {
        kr[celli] = cellStates_[celli].K/table(celli).Ks();
    }

    // A face through which no head drives the flow has the cell's own
    scalarField boundaryKr(boundaryStates_.size());
    forAll(conditions_, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        const bool known = patch.coupled() || open(conditions_[patchi]);

        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label b = facei - mesh_.nInternalFaces();

            boundaryKr[b] =
                known
              ? boundaryState(facei).K/tables_[connections_[facei].soil2].Ks()
              : kr[mesh_.faceOwner()[facei]];
        }
    }

    correction_.update(pointFlux_, kr, boundaryKr, weight);
}


void Foam::subsurfaceFlow::assemble
(
    coupledMatrix& matrix,
    const groundSurface& ground,
    const scalar t1,
    const scalar t2,
    const bool fallback
)
{
    const richardsFlux& flux = fallback ? *fallbackFlux_ : *flux_;

    fluxScale_ = 0;

    assembleStorage(matrix);
    assembleInternal(matrix, flux);

    forAll(conditions_, patchi)
    {
        if (isA<processorPolyPatch>(mesh_.boundaryMesh()[patchi]))
        {
            assembleProcessor(matrix, flux, patchi);
        }
        else if (conditions_[patchi] != condition::surface)
        {
            assemblePatch(matrix, t1, t2, flux, patchi);
        }
    }

    assembleGround(matrix, ground, flux);
}

// ************************************************************************* //
