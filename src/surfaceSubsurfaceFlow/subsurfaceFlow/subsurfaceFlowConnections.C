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
#include "anisotropy.H"
#include "DynamicList.H"
#include "fixedValueFvPatchFields.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::subsurfaceFlow::readConditions()
{
    forAll(conditions_, patchi)
    {
        const fvPatchScalarField& field = psi_.boundaryField()[patchi];
        const fvPatch& patch = field.patch();

        if (isA<soilBoundaryFvPatchScalarField>(field))
        {
            conditions_[patchi] =
                refCast<const soilBoundaryFvPatchScalarField>(field)
               .prescribes();
        }
        else if (field.fixesValue() && !patch.coupled())
        {
            conditions_[patchi] = condition::head;
        }
        else if
        (
            !isA<processorPolyPatch>(patch.patch())
         && (
                patch.coupled()
             || !polyPatch::constraintType(patch.patch().type())
            )
        )
        {
            FatalErrorInFunction
                << "psi, patch " << patch.name() << ": type " << field.type()
                << " does not say how water passes. Use noFlow, fixedValue or"
                << " another fixed head, fixedPiezometricHead, darcyFlux,"
                << " freeDrainage, seepageFace, groundSurface or surfaceRain;"
                << " empty, symmetry, symmetryPlane and wedge patches are"
                << " walls, cyclic ones are not supported (file "
                << psi_.objectPath() << ')'
                << exit(FatalError);
        }
    }
}


bool Foam::subsurfaceFlow::open(const condition type)
{
    return
        type == condition::head
     || type == condition::seepage
     || type == condition::surface;
}


Foam::List<Foam::symmTensor> Foam::subsurfaceFlow::readAnisotropies() const
{
    List<symmTensor> result(soils_.size());

    forAll(result, soili)
    {
        const dictionary& dict =
            soils_.zones().soilDict(soili).subDict("hydraulic");

        result[soili] = readAnisotropy(dict);

        if (dict.found("anisotropy"))
        {
            Info<< "Conductivity of " << soils_[soili].name()
                << ": Ks times the tensor (xx xy xz yy yz zz) "
                << result[soili] << nl << endl;
        }
    }

    return result;
}


void Foam::subsurfaceFlow::setConnection
(
    const label facei,
    const facePaths& paths,
    DynamicList<richardsFlux::interface>& interfaces
)
{
    const labelList& cellSoil = soils_.zones().cellSoil();

    richardsFlux::connection& c = connections_[facei];

    c.transmissibility = paths.transmissibility(facei);
    c.drop = -(paths.delta(facei) & up_);
    c.soil1 = cellSoil[mesh_.faceOwner()[facei]];
    c.soil2 = c.soil1;

    if (paths.twoSided(facei))
    {
        c.soil2 =
            mesh_.isInternalFace(facei)
          ? cellSoil[mesh_.faceNeighbour()[facei]]
          : otherSoil_[facei - mesh_.nInternalFaces()];
    }

    if (c.soil1 != c.soil2)
    {
        const facePaths::side first(paths.first(facei));
        const facePaths::side second(paths.second(facei));

        richardsFlux::interface sides;
        sides.first.transmissibility = first.transmissibility;
        sides.first.drop = -(first.delta & up_);
        sides.second.transmissibility = second.transmissibility;
        sides.second.drop = -(second.delta & up_);

        c.interface = interfaces.size();
        c.transmissibility =
            1/(
                1/(first.transmissibility*tables_[c.soil1].Ks())
              + 1/(second.transmissibility*tables_[c.soil2].Ks())
            );

        interfaces.append(sides);
    }
}


void Foam::subsurfaceFlow::makeConnections()
{
    const labelList& cellSoil = soils_.zones().cellSoil();
    syncTools::swapBoundaryCellList(mesh_, cellSoil, otherSoil_);

    symmTensorField tensors
    (
        UIndirectList<symmTensor>(anisotropy_, cellSoil)
    );
    forAll(tensors, celli)
    {
        tensors[celli] *= soils_.variation().conductivity(celli);
    }
    const facePaths paths(mesh_, tensors);

    DynamicList<richardsFlux::interface> interfaces;
    boolList same(mesh_.nFaces());

    forAll(connections_, facei)
    {
        setConnection(facei, paths, interfaces);
        same[facei] = connections_[facei].interface < 0;
    }

    flux_->prepare(connections_, interfaces);

    boolList openFaces(mesh_.nFaces() - mesh_.nInternalFaces(), false);
    forAll(conditions_, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        SubList<bool>
        (
            openFaces,
            patch.size(),
            patch.start() - mesh_.nInternalFaces()
        ) = open(conditions_[patchi]);
    }

    scalarList Ks(mesh_.nCells());
    forAll(Ks, celli)
    {
        Ks[celli] = table(celli).Ks();
    }

    scalarList otherKs;
    syncTools::swapBoundaryCellList(mesh_, Ks, otherKs);

    correction_.setGeometry(paths, openFaces, same, Ks, otherKs);
}

// ************************************************************************* //
